// SPDX-License-Identifier: MIT
// How many tetrahedra a walk to a new point visits, by the order of insertion, the place where the
// walk starts, how it goes and where it stops; and how many tetrahedra an insertion removes, by the
// order. The walks are taken from the same mesh, before the library inserts the point, and each
// one's end is checked exactly, as is the triangulation.
//
//   walks [points] [--every k] [--sets a,b] [--orders a,b] [--csv file]
//
// docs/paper.md, "The open question", reads the tables.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>

#include "../unit/unwatched.hpp"
#include "cli/point_sets/distributions.hpp"
#include "core/triangulation.hpp"
#include "order/grid.hpp"
#include "query/check.hpp"
#include "walk_probe.hpp"

namespace {

using namespace bench;

const char* const start_names[start_kinds] = {
    "best of four in the last star",      "last insertion", "last vertex of the same cell",
    "nearest of the cell's last eight",   "nearest vertex", "kd-tree over one vertex in 16",
    "nearest of n^(1/4) random vertices", "random vertex"};
const char* const walk_names[walk_kinds] = {"power, first conflict",
                                            "power, base",
                                            "orientation, first conflict",
                                            "orientation, base",
                                            "orientation, faces in order, base",
                                            "orientation, by volume coordinate, base"};

// What one order does on one set, a point.
struct Result {
    Sums sums;
    double removed;  // by all insertions
    double mean(double sum) const { return sum / static_cast<double>(sums.count); }
    double steps(unsigned start, unsigned walk) const {
        return sums.steps[start][walk] / static_cast<double>(sums.starts[start]);
    }
    double tests(unsigned start, unsigned walk) const {
        return sums.tests[start][walk] / static_cast<double>(sums.starts[start]);
    }
};
using Results = std::map<std::string, std::map<std::string, Result>>;  // by set, by order

// The cells of the paper's multi-grid: a regular grid of eight points a cell, and one in each cell
// with more than 200.
class Cells {
  public:
    explicit Cells(const mgdt::PointSet& points) : of(points.size), points_(points) {
        std::vector<std::uint32_t> all(points.size);
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(i);
        divide(all);
    }
    std::vector<std::uint32_t> of;  // by point

  private:
    void divide(const std::vector<std::uint32_t>& members) {
        const auto index = [&](std::size_t j) { return members[j]; };
        const mgdt::Box box = mgdt::box_of(points_, members.size(), index);
        const mgdt::Grid grid(points_, box, members.size(), 8);
        std::map<std::uint32_t, std::vector<std::uint32_t>> cells;
        for (const std::uint32_t i : members) cells[grid.path(points_, i)].push_back(i);
        for (const auto& [path, inside] : cells) {
            if (inside.size() > 200 && cells.size() > 1) {
                divide(inside);
            } else {
                for (const std::uint32_t i : inside) of[i] = count_;
                ++count_;
            }
        }
    }

    const mgdt::PointSet& points_;
    std::uint32_t count_ = 0;
};

mgdt::PointSet point_set(const std::vector<double>& xyz) {
    mgdt::PointSet points = {{&xyz[0], &xyz[1], &xyz[2]}, 3, xyz.size() / 3, 1, {}, {}};
    const mgdt::Box box = mgdt::box_of(points, points.size, [](std::size_t i) { return i; });
    std::copy(box.low, box.low + 3, points.low);
    std::copy(box.high, box.high + 3, points.high);
    return points;
}

// "multi-grid:cells" empties a cell before the next, "multi-grid:passes" takes a point of each cell
// at a time; "brio:31" has rounds that grow 31-fold.
mgdt::Settings settings_of(const std::string& order) {
    mgdt::Settings settings;
    const std::size_t colon = order.find(':');
    if (mgdt_order_scheme_from_name(order.substr(0, colon).c_str(), &settings.scheme) != MGDT_OK)
        throw std::runtime_error("unknown order " + order);
    if (colon == std::string::npos) return settings;
    const std::string value = order.substr(colon + 1);
    if (value == "cells")
        settings.order.separation = mgdt::Separation::none;
    else if (value == "passes")
        settings.order.separation = mgdt::Separation::passes;
    else
        settings.order.round_ratio = std::stod(value);
    return settings;
}

Probe* probe;  // for the kernel's function, which is told nothing else

Result run(const std::vector<double>& xyz, const std::vector<std::uint32_t>& cells,
           const std::string& order, std::uint32_t every) {
    mgdt::Kernel probing = mgdt::default_kernel();
    probing.with_spheres.insert = [](Mesh& mesh, mgdt::Workspace& w, VertexId q, TetId start) {
        return probe->insert(mesh, w, q, start);
    };
    Probe here(mgdt::default_kernel(), cells, every, order == "random");
    probe = &here;
    mgdt::Triangulation t(nullptr, nullptr, nullptr);
    t.settings() = settings_of(order);
    t.set_kernel(probing);
    const double* const axis[3] = {&xyz[0], &xyz[1], &xyz[2]};
    t.insert(xyz.size() / 3, axis, 3);
    mgdt::Team alone;
    check_triangulation(alone, t.check_input(), t.allocator(), MGDT_CHECK_CANONICAL, 0,
                        Unwatched());
    if (here.sums().count == 0) throw std::runtime_error("too few points: no walk was taken");
    const double n = static_cast<double>(xyz.size() / 3);
    return {here.sums(), static_cast<double>(t.counters().removed) / n};
}

std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, x < 99.95 ? "%.1f" : "%.0f", x);
    return text;
}

// A row of a table, a figure of each set.
struct Row {
    std::string label, order;
    std::function<std::string(const Result&)> figure;
};

Row steps(const std::string& label, const std::string& order, StartKind start, WalkKind walk) {
    return {label, order, [=](const Result& r) { return number(r.steps(start, walk)); }};
}

// The rows of the orders that were run.
void print(const std::string& title, const Results& results, const std::vector<std::string>& sets,
           const std::vector<Row>& rows) {
    bool has_head = false;
    for (const Row& row : rows) {
        if (results.at(sets[0]).count(row.order) == 0) continue;
        if (!has_head) {
            std::printf("\n%s\n\n| |", title.c_str());
            for (const std::string& set : sets) std::printf(" %s |", set.c_str());
            std::printf("\n|---|");
            for (std::size_t i = 0; i < sets.size(); ++i) std::printf("---|");
            std::printf("\n");
            has_head = true;
        }
        std::printf("| %s |", row.label.c_str());
        for (const std::string& set : sets)
            std::printf(" %s |", row.figure(results.at(set).at(row.order)).c_str());
        std::printf("\n");
    }
}

void print_tables(const Results& results, const std::vector<std::string>& sets,
                  const std::vector<std::string>& orders) {
    std::vector<Row> removed, by_order, as_paper, by_start, by_walk;
    for (const std::string& order : orders) {
        removed.push_back({order, order, [](const Result& r) {
                               const double percent = 100 / r.sums.removed;
                               return number(r.removed) + " / " +
                                      std::to_string(std::lround(r.sums.young * percent)) + " / " +
                                      std::to_string(std::lround(r.sums.elongated * percent));
                           }});
        by_order.push_back(
            {order, order, [](const Result& r) { return number(r.mean(r.sums.visited)); }});
        as_paper.push_back(steps(order, order, last, ordered_base));
    }
    const std::string cell = "regular-grid:cells, from the last vertex of the multi-grid's cell";
    as_paper.push_back(steps(cell, "regular-grid:cells", cell_last, ordered_base));
    for (const std::string order : {"random", "multi-grid:passes", "auto"})
        for (unsigned s = in_star; s < start_kinds; ++s)
            by_start.push_back(steps(order + ", " + start_names[s], order,
                                     static_cast<StartKind>(s), power_conflict));
    for (const std::string order : {"kd-tree", "auto"})
        for (unsigned k = 0; k < walk_kinds; ++k)
            by_walk.push_back({order + ", " + walk_names[k], order, [k](const Result& r) {
                                   return number(r.steps(last, k)) + " / " +
                                          number(r.tests(last, k));
                               }});
    print("NR / of 100 of these, with a vertex of the last 100 / with an edge 5 times another's",
          results, sets, removed);
    print("NP of the library", results, sets, by_order);
    print("NP of an orientation walk, faces in order, from the last insertion to the base", results,
          sets, as_paper);
    print("NP by start: power walk to the first conflict", results, sets, by_start);
    print("NP / tests by walk, from the last insertion", results, sets, by_walk);
}

void write_csv(const std::string& file, std::size_t n, const Results& results) {
    std::FILE* const out = std::fopen(file.c_str(), "w");
    if (!out) throw std::runtime_error("cannot write " + file);
    std::fprintf(
        out, "points,set,order,removed,visited,young,elongated,ghosts,start,walk,steps,tests\n");
    for (const auto& [set, orders] : results)
        for (const auto& [order, r] : orders)
            for (unsigned s = 0; s < start_kinds; ++s)
                for (unsigned k = 0; k < walks_from(s); ++k)
                    std::fprintf(
                        out, "%zu,%s,%s,%.3f,%.3f,%.3f,%.3f,%.3f,\"%s\",\"%s\",%.3f,%.3f\n", n,
                        set.c_str(), order.c_str(), r.removed, r.mean(r.sums.visited),
                        r.mean(r.sums.young), r.mean(r.sums.elongated), r.mean(r.sums.ghosts),
                        start_names[s], walk_names[k], r.steps(s, k), r.tests(s, k));
    if (std::fclose(out) != 0) throw std::runtime_error("cannot write " + file);
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t n = 200000;
    std::uint32_t every = 64;
    std::vector<std::string> sets = {"uniform", "line",    "diagonal", "ellipse",
                                     "spiral",  "cluster", "galaxy"};
    std::vector<std::string> orders = {"random",           "regular-grid:cells",
                                       "multi-grid:cells", "multi-grid:passes",
                                       "kd-tree",          "enhanced-kd-tree",
                                       "hilbert",          "brio",
                                       "regular-grid",     "auto"};
    std::string csv;
    CLI::App app("Walks and removals by order, start, way and stop");
    app.add_option("points", n, "points of each set")->capture_default_str();
    app.add_option("--every", every, "walk for one insertion in so many")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--sets", sets, "distributions")->delimiter(',');
    app.add_option("--orders", orders, "schemes; multi-grid:cells, multi-grid:passes, brio:RATIO")
        ->delimiter(',');
    app.add_option("--csv", csv, "file for all figures");
    CLI11_PARSE(app, argc, argv);
    Results results;
    try {
        for (const std::string& set : sets) {
            const std::vector<double> xyz = mgdt::cli::generate(set, n, {});
            const std::vector<std::uint32_t> cells = Cells(point_set(xyz)).of;
            for (const std::string& order : orders) {
                std::fprintf(stderr, "%s %s\n", set.c_str(), order.c_str());
                results[set][order] = run(xyz, cells, order, every);
            }
        }
        if (!csv.empty()) write_csv(csv, n, results);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "walks: %s\n", error.what());
        return 1;
    }
    std::printf("%zu points, walks of one insertion in %u\n", n, every);
    print_tables(results, sets, orders);
    return 0;
}
