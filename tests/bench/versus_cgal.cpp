// SPDX-License-Identifier: MIT
// Times mgdt and CGAL on the seven distributions in one run, interleaved so that both meet the
// same noise, and prints medians, their ratio and the counts that explain them.
//
//   versus_cgal [points [runs [distribution...]]]
//
// Timed is the way from points in memory to the triangulation; taking it down is not. "own" is the
// ratio of processor times less the system's, which depends on how the machine, above all a virtual
// one, comes by its pages. "order s" and "insert s" are mgdt's seconds for the schedule and for the
// insertions, and "order" the schedule's share; what is left of "mgdt s" is the scan of the points.
// NP, NR and NC are the tetrahedra visited by walks, removed and created, "bytes" the peak memory
// beyond the caller's array, "cycles" the processor's, all a point.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "cli/point_sets/distributions.hpp"
#include "cycles.hpp"
#include "measure.hpp"
#include "mgdt/mgdt.h"

namespace {

using bench::median;
using Triangulation =
    CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Point = Triangulation::Point;

/// What was measured of one library, an entry a run.
struct Costs {
    std::vector<double> seconds, own, cycles;

    template <class Body>
    void add(const bench::CycleCounter& counter, Body body) {
        const auto timed = [&] { seconds.push_back(bench::seconds(body)); };
        const auto counted = [&] { cycles.push_back(counter.count(timed)); };
        own.push_back(bench::own_seconds(counted));
    }
};

struct Figures {
    Costs ours, theirs;
    std::vector<double> order_seconds, insert_seconds;
    // The same in every run.
    double walk_steps, removed, created, bytes;
    long long our_tetrahedra, their_tetrahedra;

    double ratio() const { return median(theirs.seconds) / median(ours.seconds); }
    double own_ratio() const { return median(theirs.own) / median(ours.own); }
};

mgdt_status run_mgdt(const std::vector<double>& xyz, const bench::CycleCounter& counter,
                     Figures& f) {
    mgdt_triangulation* t = nullptr;
    mgdt_status status = MGDT_OK;
    f.ours.add(counter, [&] {
        status = mgdt_create(&t);
        if (status == MGDT_OK)
            status = mgdt_insert_points(t, static_cast<int64_t>(xyz.size() / 3), xyz.data());
    });
    const auto stat = [&](int32_t key) {
        double value = 0;
        mgdt_get_stat(t, key, &value);
        return value;
    };
    const double points = std::max(1.0, stat(MGDT_STAT_POINTS_INSERTED));
    f.order_seconds.push_back(stat(MGDT_STAT_ORDER_SECONDS));
    f.insert_seconds.push_back(stat(MGDT_STAT_INSERT_SECONDS));
    f.walk_steps = stat(MGDT_STAT_WALK_STEPS) / points;
    f.removed = stat(MGDT_STAT_TETRAHEDRA_REMOVED) / points;
    f.created = stat(MGDT_STAT_TETRAHEDRA_CREATED) / points;
    f.bytes = stat(MGDT_STAT_PEAK_MEMORY_BYTES) / static_cast<double>(xyz.size() / 3);
    f.our_tetrahedra = mgdt_tetrahedron_count(t);
    mgdt_destroy(t);
    return status;
}

void run_cgal(const std::vector<Point>& points, const bench::CycleCounter& counter, Figures& f) {
    std::optional<Triangulation> t;
    f.theirs.add(counter, [&] { t.emplace(points.begin(), points.end()); });
    f.their_tetrahedra = static_cast<long long>(t->number_of_finite_cells());
}

/// False, with a message, if something went wrong.
bool measure(const std::string& kind, std::size_t points, int runs,
             const bench::CycleCounter& counter, Figures& f) {
    const std::vector<double> xyz = mgdt::cli::generate(kind, points, {});
    std::vector<Point> cgal_points;
    for (std::size_t i = 0; i < xyz.size(); i += 3)
        cgal_points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
    for (int run = 0; run < runs; ++run) {
        const mgdt_status status = run_mgdt(xyz, counter, f);
        if (status != MGDT_OK) {
            std::printf("%s: mgdt: %s\n", kind.c_str(), mgdt_status_string(status));
            return false;
        }
        run_cgal(cgal_points, counter, f);
        if (f.our_tetrahedra != f.their_tetrahedra) {
            std::printf("%s: mgdt has %lld tetrahedra, CGAL %lld\n", kind.c_str(), f.our_tetrahedra,
                        f.their_tetrahedra);
            return false;
        }
    }
    return true;
}

class Ratios {
  public:
    void add(double ratio) {
        log_sum_ += std::log(ratio);
        least_ = std::min(least_, ratio);
        ++count_;
    }
    void print(const char* name) const {
        std::printf("%s: geometric mean %.2f, least %.2f\n", name, std::exp(log_sum_ / count_),
                    least_);
    }

  private:
    double log_sum_ = 0, least_ = 1e300;
    int count_ = 0;
};

std::string cycles_a_point(const Costs& costs, std::size_t points) {
    const double cycles = median(costs.cycles) / static_cast<double>(points);
    return cycles > 0 ? std::to_string(std::llround(cycles)) : "-";
}

void print_heading() {
    std::printf("%-9s %7s %7s %6s %6s %6s %6s %6s %6s %8s %8s %6s %7s %11s\n", "set", "mgdt s",
                "CGAL s", "ratio", "own", "NP", "NR", "NC", "order", "order s", "insert s", "bytes",
                "cycles", "CGAL cycles");
}

void print_row(const std::string& kind, std::size_t points, const Figures& f) {
    const double ours = median(f.ours.seconds), theirs = median(f.theirs.seconds);
    const double order = median(f.order_seconds);
    std::printf(
        "%-9s %7.3f %7.3f %6.2f %6.2f %6.2f %6.2f %6.2f %5.1f%% %8.4f %8.4f %6.0f %7s %11s\n",
        kind.c_str(), ours, theirs, f.ratio(), f.own_ratio(), f.walk_steps, f.removed, f.created,
        100 * order / ours, order, median(f.insert_seconds), f.bytes,
        cycles_a_point(f.ours, points).c_str(), cycles_a_point(f.theirs, points).c_str());
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t points = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
    const int runs = std::max(1, argc > 2 ? std::atoi(argv[2]) : 3);
    std::vector<std::string> kinds(argv + std::min(argc, 3), argv + argc);
    if (kinds.empty())
        kinds = {"uniform", "line", "diagonal", "ellipse", "spiral", "cluster", "galaxy"};

    const bench::CycleCounter counter;
    std::printf("%zu points, medians of %d interleaved runs, one thread; cycles %s\n", points, runs,
                counter.scope());
    print_heading();
    Ratios all, own;
    for (const std::string& kind : kinds) {
        Figures figures{};
        if (!measure(kind, points, runs, counter, figures)) return 1;
        print_row(kind, points, figures);
        all.add(figures.ratio());
        own.add(figures.own_ratio());
    }
    all.print("ratio");
    own.print("own");
    return 0;
}
