// SPDX-License-Identifier: MIT
// Times mgdt and CGAL on the seven distributions in one run, interleaved so that both meet the
// same noise, and prints medians, their ratio and the counts that explain them.
//
//   versus_cgal [points [runs [distribution...]]]
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "cli/distributions.hpp"
#include "mgdt/mgdt.h"

namespace {

using Triangulation =
    CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Point = Triangulation::Point;

template <class Body>
double seconds(Body body) {
    const auto start = std::chrono::steady_clock::now();
    body();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> v) {
    std::sort(v.begin(), v.end());
    const std::size_t half = v.size() / 2;
    return v.size() % 2 == 1 ? v[half] : (v[half - 1] + v[half]) / 2;
}

struct Figures {
    double seconds, walk_steps, removed, created, order_share;
    long long tetrahedra;
};

bool run_mgdt(const std::vector<double>& xyz, Figures& figures) {
    mgdt_triangulation* t = nullptr;
    mgdt_status status = MGDT_OK;
    figures.seconds = seconds([&] {
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
    figures.walk_steps = stat(MGDT_STAT_WALK_STEPS) / points;
    figures.removed = stat(MGDT_STAT_TETRAHEDRA_REMOVED) / points;
    figures.created = stat(MGDT_STAT_TETRAHEDRA_CREATED) / points;
    figures.order_share = stat(MGDT_STAT_ORDER_SECONDS) / figures.seconds;
    figures.tetrahedra = mgdt_tetrahedron_count(t);
    mgdt_destroy(t);
    return status == MGDT_OK;
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t points = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
    const int runs = argc > 2 ? std::atoi(argv[2]) : 3;
    std::vector<std::string> kinds(argv + std::min(argc, 3), argv + argc);
    if (kinds.empty())
        kinds = {"uniform", "line", "diagonal", "ellipse", "spiral", "cluster", "galaxy"};

    std::printf("%zu points, medians of %d interleaved runs, one thread\n", points, runs);
    std::printf("%-10s %9s %9s %6s %6s %6s %6s %6s\n", "set", "mgdt s", "CGAL s", "ratio", "NP",
                "NR", "NC", "order");
    double log_sum = 0, least = 1e300;
    for (const std::string& kind : kinds) {
        const std::vector<double> xyz = mgdt::cli::generate(kind, points, {});
        std::vector<Point> cgal_points;
        for (std::size_t i = 0; i < xyz.size(); i += 3)
            cgal_points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
        std::vector<double> ours, theirs;
        Figures figures{};
        for (int run = 0; run < runs; ++run) {
            if (!run_mgdt(xyz, figures)) {
                std::printf("%s: mgdt failed\n", kind.c_str());
                return 1;
            }
            ours.push_back(figures.seconds);
            std::size_t cells = 0;
            theirs.push_back(seconds([&] {
                const Triangulation t(cgal_points.begin(), cgal_points.end());
                cells = t.number_of_finite_cells();
            }));
            if (static_cast<long long>(cells) != figures.tetrahedra) {
                std::printf("%s: mgdt has %lld tetrahedra, CGAL %zu\n", kind.c_str(),
                            figures.tetrahedra, cells);
                return 1;
            }
        }
        const double ratio = median(theirs) / median(ours);
        log_sum += std::log(ratio);
        least = std::min(least, ratio);
        std::printf("%-10s %9.3f %9.3f %6.2f %6.2f %6.2f %6.2f %5.1f%%\n", kind.c_str(),
                    median(ours), median(theirs), ratio, figures.walk_steps, figures.removed,
                    figures.created, 100 * figures.order_share);
        std::fflush(stdout);
    }
    std::printf("ratio: geometric mean %.2f, least %.2f\n",
                std::exp(log_sum / static_cast<double>(kinds.size())), least);
    return 0;
}
