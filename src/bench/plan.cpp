// SPDX-License-Identifier: MIT
#include "bench/plan.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <thread>

#include "bench/paper.hpp"
#include "cli/errors.hpp"
#include "cli/program_triangulation.hpp"

namespace mgdt::cli::bench {
namespace {

using Names = std::vector<std::string>;

template <class T>
bool contains(const std::vector<T>& list, const T& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

// Removes repeats and keeps the order of first occurrences.
template <class T>
std::vector<T> distinct(const std::vector<T>& list) {
    std::vector<T> result;
    for (const T& value : list) {
        if (!contains(result, value)) result.push_back(value);
    }
    return result;
}

void require_known(const Names& names, const Names& known, const char* option) {
    for (const std::string& name : names) {
        if (contains(known, name)) continue;
        throw Error(exit_usage, fmt::format("{}: unknown {}; known are {}", option, quote(name),
                                            fmt::join(known, ", ")));
    }
}

template <class T>
std::vector<T> or_default(const std::vector<T>& list, std::vector<T> other) {
    return list.empty() ? std::move(other) : distinct(list);
}

// The number of threads that the library uses for 0.
int all_cores() {
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

std::vector<int> thread_numbers(std::vector<int> list) {
    std::replace(list.begin(), list.end(), 0, all_cores());
    return or_default(list, {1});
}

struct Candidate {
    std::string distribution;
    std::size_t points;
};

std::vector<Candidate> ordinary_sets(const PlanOptions& options) {
    std::vector<Candidate> sets;
    for (const std::string& distribution :
         or_default(options.distributions,
                    {"uniform", "line", "diagonal", "ellipse", "spiral", "cluster", "galaxy"})) {
        for (const std::size_t n : or_default(options.sizes, {1000000})) {
            sets.push_back({distribution, n});
        }
    }
    return sets;
}

std::vector<Candidate> sets_of_the_paper(const PlanOptions& options, Names& left_out) {
    std::vector<Candidate> sets;
    Names known;
    for (const PaperTable& table : paper_tables()) {
        known.push_back(table.distribution);
        if (!options.distributions.empty() && !contains(options.distributions, known.back())) {
            continue;
        }
        for (const std::size_t n : table.sizes) {
            if (n <= options.largest) {
                sets.push_back({table.distribution, n});
            } else {
                left_out.push_back(fmt::format("{} {}", table.distribution, n));
            }
        }
    }
    require_known(options.distributions, known, "--distributions with --paper");
    return sets;
}

}  // namespace

std::size_t Plan::row_count() const {
    std::size_t count = 0;
    for (const PlannedSet& set : sets) count += set.rows.size();
    return count;
}

Plan make_plan(const PlanOptions& options) {
    if (!options.paper) {
        require_known(options.distributions, distribution_names(), "--distributions");
    }
    require_known(options.schemes, scheme_names(), "--schemes");
    require_known(options.peers, peer_names, "--peers");
    const Names schemes =
        or_default(options.schemes, options.paper ? paper_schemes() : Names{"auto"});

    const int runs = options.runs > 0 ? options.runs : options.paper ? 1 : 3;
    Plan plan;
    for (const Candidate& candidate :
         options.paper ? sets_of_the_paper(options, plan.left_out) : ordinary_sets(options)) {
        PlannedSet set{{candidate.distribution, candidate.points, options.seed}, {}};
        Row row;
        row.distribution = candidate.distribution;
        row.points = candidate.points;
        row.seed = options.seed;
        for (row.run = 1; row.run <= runs; ++row.run) {
            const auto add = [&](const std::string& library, const std::string& scheme, int threads,
                                 std::string_view suffix = "") {
                const std::string& name = scheme.empty() ? library : scheme;
                if (options.paper && is_hopeless(name, candidate.distribution, candidate.points)) {
                    return;
                }
                row.library = library;
                row.scheme = scheme;
                row.scheme += suffix;
                row.threads = threads;
                set.rows.push_back(row);
            };
            for (const std::string& scheme : schemes) {
                for (const int threads : thread_numbers(options.threads)) {
                    add("mgdt", scheme, threads);
                    if (options.compact) add("mgdt", scheme, threads, compact_suffix);
                }
            }
            for (const std::string& peer : distinct(options.peers)) add(peer, "", 1);
        }
        if (!set.rows.empty()) plan.sets.push_back(std::move(set));
    }
    if (plan.sets.empty()) {
        throw Error(exit_usage,
                    "nothing to run: what the paper ran of these is larger than --largest, or "
                    "hopeless with these schemes");
    }
    return plan;
}

}  // namespace mgdt::cli::bench
