// SPDX-License-Identifier: MIT
//
// The parts of mgdt-bench that run nothing: what is planned, lines of the table, medians.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "bench/plan.hpp"
#include "bench/row.hpp"
#include "bench/summary.hpp"
#include "cli/errors.hpp"

namespace mgdt::cli::bench {
namespace {

std::vector<std::string> contenders(const PlannedSet& set) {
    std::vector<std::string> names;
    for (const Row& row : set.rows) {
        names.push_back(row.contender() + " " + std::to_string(row.threads) + " " +
                        std::to_string(row.run));
    }
    return names;
}

const PlannedSet* find(const Plan& plan, const std::string& distribution, std::size_t points) {
    for (const PlannedSet& set : plan.sets) {
        if (set.name.distribution == distribution && set.name.points == points) return &set;
    }
    return nullptr;
}

bool has(const PlannedSet* set, const std::string& contender) {
    return set != nullptr && std::any_of(set->rows.begin(), set->rows.end(), [&](const Row& row) {
               return row.contender() == contender;
           });
}

std::string refusal(const PlanOptions& options) {
    try {
        make_plan(options);
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), exit_usage);
        return e.what();
    }
    return "";
}

TEST(Plan, Defaults) {
    const Plan plan = make_plan({});
    ASSERT_EQ(plan.sets.size(), 7U);
    EXPECT_EQ(plan.row_count(), 21U);
    EXPECT_EQ(plan.sets[0].name.distribution, "uniform");
    EXPECT_EQ(plan.sets[6].name.distribution, "galaxy");
    EXPECT_EQ(plan.sets[6].name.points, 1000000U);
    EXPECT_EQ(contenders(plan.sets[6]),
              (std::vector<std::string>{"auto 1 1", "auto 1 2", "auto 1 3"}));
    EXPECT_TRUE(plan.left_out.empty());
}

TEST(Plan, EveryoneHasATurnInEachRun) {
    PlanOptions options;
    options.distributions = {"lattice", "lattice"};
    options.sizes = {10, 20, 10};
    options.schemes = {"brio", "auto", "brio"};
    options.threads = {2, 1};
    options.peers = {"qhull"};
    options.runs = 2;
    options.seed = 9;
    const Plan plan = make_plan(options);
    ASSERT_EQ(plan.sets.size(), 2U);
    EXPECT_EQ(
        contenders(plan.sets[1]),
        (std::vector<std::string>{"brio 2 1", "brio 1 1", "auto 2 1", "auto 1 1", "qhull 1 1",
                                  "brio 2 2", "brio 1 2", "auto 2 2", "auto 1 2", "qhull 1 2"}));
    EXPECT_EQ(plan.sets[1].name.seed, 9U);
    std::set<std::string> keys;
    for (const PlannedSet& set : plan.sets) {
        for (const Row& row : set.rows) {
            EXPECT_EQ(row.seed, 9U);
            EXPECT_EQ(row.points, set.name.points);
            EXPECT_TRUE(keys.insert(row.key()).second);
        }
    }
}

TEST(Plan, CompactStorageHasATurnToo) {
    PlanOptions options;
    options.distributions = {"lattice"};
    options.sizes = {10};
    options.schemes = {"auto", "brio"};
    options.peers = {"qhull"};
    options.compact = true;
    options.runs = 1;
    const Plan plan = make_plan(options);
    ASSERT_EQ(plan.sets.size(), 1U);
    EXPECT_EQ(contenders(plan.sets[0]),
              (std::vector<std::string>{"auto 1 1", "auto+compact 1 1", "brio 1 1",
                                        "brio+compact 1 1", "qhull 1 1"}));
    const std::vector<Row>& rows = plan.sets[0].rows;
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(rows[k].compact(), k % 2 == 1);
        EXPECT_EQ(rows[k].plain_scheme(), k < 2 ? "auto" : "brio");
        EXPECT_EQ(from_csv(to_csv(rows[k]))->compact(), k % 2 == 1);
    }
    EXPECT_FALSE(rows[4].compact());
    EXPECT_EQ(rows[4].plain_scheme(), "");
    EXPECT_NE(rows[0].key(), rows[1].key());
    EXPECT_NE(rows[0].subject(), rows[1].subject());
    // Both or neither of what would take too long.
    options = {};
    options.paper = true;
    options.compact = true;
    options.schemes = {"random"};
    for (const PlannedSet& set : make_plan(options).sets) {
        EXPECT_EQ(set.rows.size(), 2U);
        EXPECT_LE(set.name.points, 400000U);
    }
}

TEST(Plan, AllCoresHaveANumber) {
    PlanOptions options;
    options.distributions = {"line"};
    options.threads = {0};
    const int all = make_plan(options).sets[0].rows[0].threads;
    EXPECT_GE(all, 1);
    options.threads = {0, all, 100};
    const Plan plan = make_plan(options);
    EXPECT_EQ(plan.row_count(), 6U);
    EXPECT_EQ(plan.sets[0].rows[1].threads, 100);
}

TEST(Plan, UnknownNames) {
    PlanOptions options;
    options.distributions = {"uniform", "sponge"};
    EXPECT_NE(refusal(options).find("'sponge'"), std::string::npos);
    options.distributions = {"mild-galaxy"};
    EXPECT_NE(refusal(options).find("'mild-galaxy'"), std::string::npos);
    options = {};
    options.schemes = {"sponge"};
    EXPECT_NE(refusal(options).find("--schemes"), std::string::npos);
    options = {};
    options.peers = {"sponge"};
    EXPECT_NE(refusal(options).find("--peers"), std::string::npos);
    options = {};
    options.paper = true;
    options.distributions = {"sphere"};
    EXPECT_NE(refusal(options).find("'sphere'"), std::string::npos);
}

TEST(Plan, PaperWholly) {
    PlanOptions options;
    options.paper = true;
    options.largest = 20000000;
    options.peers = peer_names;
    const Plan plan = make_plan(options);
    EXPECT_TRUE(plan.left_out.empty());
    // Table 1: five sets. Tables 2 to 7: ten sizes of six, and the million of Table 1. Tables 8, 9.
    EXPECT_EQ(plan.sets.size(), 5U + 60U + 1U + 2U + 2U);
    for (const char* kind : {"uniform", "line", "diagonal", "ellipse", "spiral", "cluster"}) {
        for (const std::size_t n : {400000U, 800000U, 1200000U, 1600000U, 2000000U, 4000000U,
                                    8000000U, 12000000U, 16000000U, 20000000U}) {
            const PlannedSet* set = find(plan, kind, n);
            ASSERT_NE(set, nullptr) << kind << n;
            EXPECT_EQ(set->rows.front().run, 1);
            EXPECT_EQ(set->rows.back().run, 1);
            for (const char* scheme :
                 {"multi-grid", "enhanced-kd-tree", "brio", "hilbert", "auto", "cgal", "tetgen"}) {
                EXPECT_TRUE(has(set, scheme)) << kind << n << scheme;
            }
            EXPECT_EQ(has(set, "regular-grid"), n <= 2000000 || std::string(kind) == "uniform");
        }
    }
    // Where nobody would wait.
    EXPECT_TRUE(has(find(plan, "uniform", 400000), "random"));
    EXPECT_FALSE(has(find(plan, "uniform", 800000), "random"));
    EXPECT_FALSE(has(find(plan, "line", 400000), "random"));
    EXPECT_TRUE(has(find(plan, "line", 800000), "qhull"));
    EXPECT_FALSE(has(find(plan, "line", 1200000), "qhull"));
    EXPECT_TRUE(has(find(plan, "galaxy", 6000000), "regular-grid"));
    EXPECT_TRUE(has(find(plan, "machine", 3318541), "regular-grid"));
    EXPECT_TRUE(has(find(plan, "church", 4824332), "regular-grid"));
    EXPECT_TRUE(has(find(plan, "mild-cluster", 1000000), "regular-grid"));
}

TEST(Plan, PaperUpToTwoMillions) {
    PlanOptions options;
    options.paper = true;
    const Plan plan = make_plan(options);
    EXPECT_EQ(plan.sets.size(), 5U + 30U + 1U);
    EXPECT_EQ(plan.left_out.size(), 30U + 2U + 2U);
    for (const PlannedSet& set : plan.sets) EXPECT_LE(set.name.points, 2000000U);
    EXPECT_EQ(plan.left_out.back(), "church 4824332");
}

Row row_of(const std::string& library, double seconds, double count = 5) {
    Row row;
    row.library = library;
    row.distribution = "line";
    row.points = 7;
    row.scheme = library == "mgdt" ? "auto" : "";
    row.figures[total_seconds] = seconds;
    row.figures[tetrahedra] = count;
    return row;
}

std::vector<Row> numbered(std::vector<Row> rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].run = static_cast<int>(i) + 1;
    return rows;
}

TEST(Row, LineAndBack) {
    Row row = row_of("mgdt", 0.1 + 0.2);
    row.version = "1.0.0";
    row.seed = ~std::uint64_t{0};
    row.threads = 3;
    row.run = 2;
    row.status = "error: no";
    row.figures[peak_rss_bytes] = 123456789012345.0;
    row.figures[order_seconds] = 1e-9;
    const std::string line = to_csv(row);
    const std::optional<Row> back = from_csv(line);
    ASSERT_TRUE(back);
    EXPECT_EQ(to_csv(*back), line);
    EXPECT_EQ(back->figures, row.figures);
    EXPECT_EQ(back->key(), row.key());
    EXPECT_EQ(line,
              "mgdt,1.0.0,line,7,18446744073709551615,auto,3,2,error: no,,,,1e-09,,"
              "0.30000000000000004,,123456789012345,,,5,,,,,");
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 24);
    const std::string heading = csv_heading();
    EXPECT_EQ(std::count(heading.begin(), heading.end(), ','), 24);
}

TEST(Row, LinesThatAreNone) {
    const std::string good = to_csv(row_of("mgdt", 1));
    ASSERT_TRUE(from_csv(good));
    for (const std::string& bad : {std::string(), good + ",", good.substr(1 + good.find(',')),
                                   "x" + good + "inf", csv_heading(), std::string(24, ',')}) {
        EXPECT_FALSE(from_csv(bad)) << bad;
    }
}

TEST(Row, Fields) {
    EXPECT_EQ(as_field("a, \"b\"\n\x1b[1m\xc3\xa9"), "a; 'b'??[1m??");
    EXPECT_EQ(as_field(std::string(5000, 'x')).size(), 100U);
}

TEST(Summary, Medians) {
    EXPECT_EQ(median({3}), 3);
    EXPECT_EQ(median({3, 1, 2}), 2);
    EXPECT_EQ(median({4, 1, 2, 100}), 3);
    Row failed = row_of("mgdt", 1000);
    failed.status = "timeout";
    const std::vector<Median> all =
        medians(numbered({failed, row_of("mgdt", 1), row_of("mgdt", 5), row_of("mgdt", 2)}));
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].runs, 4);
    EXPECT_EQ(all[0].row.run, 3);
    EXPECT_TRUE(all[0].row.ok());
    EXPECT_EQ(all[0].row.figures[total_seconds], 2);
    const std::vector<Median> none = medians({failed});
    EXPECT_EQ(none[0].row.status, "timeout");
    EXPECT_EQ(none[0].row.run, 0);
}

TEST(Summary, Ratios) {
    std::vector<Row> rows = numbered({row_of("mgdt", 2), row_of("cgal", 8), row_of("mgdt", 4),
                                      row_of("cgal", 10), row_of("qhull", 1, 4)});
    for (Row row : numbered({row_of("mgdt", 1), row_of("cgal", 12)})) {
        row.distribution = "galaxy";
        rows.push_back(row);
    }
    rows.push_back(row_of("mgdt", 3));
    rows.back().points = 8;  // a set that no peer has
    const std::vector<Median> all = medians(rows);
    ASSERT_EQ(all.size(), 6U);
    EXPECT_EQ(all[0].ratios.at("cgal"), 3);
    EXPECT_EQ(all[0].ratios.at("qhull"), 1.0 / 3);
    EXPECT_TRUE(all[1].ratios.empty());
    EXPECT_FALSE(all[1].other_count);
    EXPECT_EQ(all[2].other_count, 5);
    EXPECT_TRUE(all[5].ratios.empty());
    const std::vector<Comparison> over_sets = comparisons(all);
    ASSERT_EQ(over_sets.size(), 2U);
    EXPECT_EQ(over_sets[0].peer, "cgal");
    EXPECT_DOUBLE_EQ(over_sets[0].geometric_mean, 6);  // of 3 and 12
    EXPECT_EQ(over_sets[0].least, 3);
    EXPECT_EQ(over_sets[0].sets, 2U);
}

TEST(Summary, Disagreement) {
    Row failed = row_of("mgdt", 1, 6);
    failed.status = "timeout";
    EXPECT_EQ(disagreement({row_of("mgdt", 1), row_of("cgal", 1, 6), failed, row_of("mgdt", 2)}),
              "");
    Row other = row_of("mgdt", 1, 6);
    other.scheme = "brio";
    EXPECT_EQ(disagreement({row_of("mgdt", 1), other}),
              "line 7: 5 tetrahedra with auto and 6 with brio");
    other.points = 8;
    EXPECT_EQ(disagreement({row_of("mgdt", 1), other}), "");
}

}  // namespace
}  // namespace mgdt::cli::bench
