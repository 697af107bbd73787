// SPDX-License-Identifier: MIT
// Triangulations of points in a periodic cube beside those of the same points without a box, and
// beside CGAL's periodic triangulation. Microseconds a point, medians of interleaved runs.
//
//   boxes_versus_cgal [--points N] [--runs N] [--threads N] [--without-cgal] [set...]
//
// Sets are those of `mgdt generate`, shrunk to the cube where they are larger, and "axis" and
// "plane": points on a line along an axis and on a plane across the cube. "halo" is the number of
// images that a build needed for each point, and "list" the time for the list of the tetrahedra,
// which is made when it is first asked for. CGAL gets all points in one call, as a large set.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "../support/points.hpp"
#include "cli/point_sets/distributions.hpp"
#include "measure.hpp"
#include "mgdt/mgdt.h"
#include "mgdt/mgdt_periodic.h"

namespace {

using mgdt_tests::Points;
using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<
    CGAL::Exact_predicates_inexact_constructions_kernel>;
using Cgal = CGAL::Periodic_3_Delaunay_triangulation_3<Traits>;

struct Options {
    std::size_t points = 100000;
    int runs = 3, threads = 1;
    bool with_cgal = true;
    std::vector<std::string> sets;
};

Options parse(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const auto number = [&] {
            if (++i == argc) throw std::runtime_error(argument + " wants a number");
            return std::stoi(argv[i]);
        };
        if (argument == "--points")
            options.points = static_cast<std::size_t>(std::max(1, number()));
        else if (argument == "--runs")
            options.runs = std::max(1, number());
        else if (argument == "--threads")
            options.threads = number();
        else if (argument == "--without-cgal")
            options.with_cgal = false;
        else if (argument.compare(0, 2, "--") == 0)
            throw std::runtime_error("unknown option " + argument);
        else
            options.sets.push_back(argument);
    }
    if (options.sets.empty())
        options.sets = {"uniform", "lattice", "cluster", "sphere",
                        "spiral",  "line",    "axis",    "plane"};
    return options;
}

// Rounded as mgdt rounds coordinates in a cube, so that both libraries have the same points.
double on_grid(double x) {
    const double rounded = std::floor(x * 0x1p47 + 0.5) * 0x1p-47;
    return rounded < 1 ? rounded : 0;
}

// Points of [0, 1).
Points points_of(const std::string& set, std::size_t n) {
    if (set != "axis" && set != "plane") {
        Points xyz = mgdt::cli::generate(set, n, {});
        const auto [low, high] = std::minmax_element(xyz.begin(), xyz.end());
        // With a gap between the last points of a lattice and the first ones of its images.
        const double from = *low, gap = 1 / std::cbrt(static_cast<double>(n)),
                     size = (*high - from) * (1 + gap);
        const bool fits = from > -0.01 && *high < 1.01;
        for (double& x : xyz) {
            if (!fits) x = (x - from) / size;
            x = on_grid(x - std::floor(x));
        }
        return xyz;
    }
    std::mt19937_64 random(1);
    Points xyz(3 * n, 0.5);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < (set == "axis" ? 1 : 2); ++k)
            xyz[3 * i + k] = on_grid(static_cast<double>(random() >> 11) * 0x1p-53);
    return xyz;
}

void require(mgdt_status status, const char* call) {
    if (status == MGDT_OK) return;
    throw std::runtime_error(std::string(call) + ": " + mgdt_status_string(status));
}

void triangulate(const Points& xyz, int threads) {
    mgdt_triangulation* t = nullptr;
    require(mgdt_create(&t), "mgdt_create");
    require(mgdt_set_threads(t, threads), "mgdt_set_threads");
    require(mgdt_insert_points(t, static_cast<std::int64_t>(xyz.size() / 3), xyz.data()),
            "mgdt_insert_points");
    mgdt_destroy(t);
}

struct InBox {
    std::vector<double> build, list;
    std::int64_t tetrahedra = 0, images = 0;
};

void triangulate_in_box(const Points& xyz, int threads, InBox& result) {
    const double cube[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    mgdt_periodic* p = nullptr;
    result.build.push_back(bench::seconds([&] {
        require(mgdt_periodic_create(&p), "mgdt_periodic_create");
        require(mgdt_periodic_set_vectors(p, 3, cube), "mgdt_periodic_set_vectors");
        require(mgdt_periodic_set_option(p, MGDT_PERIODIC_OPTION_THREADS, threads), "threads");
        require(
            mgdt_periodic_insert_points(p, static_cast<std::int64_t>(xyz.size() / 3), xyz.data()),
            "mgdt_periodic_insert_points");
        require(mgdt_periodic_build(p), "mgdt_periodic_build");
    }));
    result.list.push_back(bench::seconds([&] {
        require(mgdt_periodic_get_stat(p, MGDT_PERIODIC_STAT_TETRAHEDRA, &result.tetrahedra),
                "tetrahedra");
    }));
    require(mgdt_periodic_get_stat(p, MGDT_PERIODIC_STAT_IMAGES, &result.images), "images");
    mgdt_periodic_destroy(p);
}

std::int64_t triangulate_with_cgal(const std::vector<Cgal::Point>& points) {
    Cgal t;
    t.insert(points.begin(), points.end(), true);
    return static_cast<std::int64_t>(t.number_of_cells());
}

void measure(const std::string& set, const Options& options) {
    const Points xyz = points_of(set, options.points);
    std::vector<Cgal::Point> points;
    for (std::size_t i = 0; i < xyz.size(); i += 3)
        points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
    std::vector<double> plain, theirs;
    InBox ours;
    std::int64_t their_count = 0;
    for (int run = 0; run < options.runs; ++run) {
        plain.push_back(bench::seconds([&] { triangulate(xyz, options.threads); }));
        triangulate_in_box(xyz, options.threads, ours);
        if (options.with_cgal)
            theirs.push_back(bench::seconds([&] { their_count = triangulate_with_cgal(points); }));
    }
    const double per = 1e6 / static_cast<double>(points.size());
    const double alone = bench::median(plain), build = bench::median(ours.build);
    std::printf("| %s | %zu | %.3f | %.3f | %.2f | %.3f | %.3f |", set.c_str(), points.size(),
                alone * per, build * per, build / alone,
                static_cast<double>(ours.images) / static_cast<double>(points.size()),
                bench::median(ours.list) * per);
    if (options.with_cgal) {
        const double them = bench::median(theirs);
        std::printf(" %.3f | %.2f | %s |", them * per, them / build,
                    their_count == ours.tetrahedra ? "equal" : "different");
    }
    std::printf("\n");
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
    const Options options = parse(argc, argv);
    std::printf("| set | points | no box | box | ratio | halo | list |%s\n",
                options.with_cgal ? " CGAL | ratio | numbers of tetrahedra |" : "");
    std::printf("|---|---|---|---|---|---|---|%s\n", options.with_cgal ? "---|---|---|" : "");
    for (const std::string& set : options.sets) measure(set, options);
    return 0;
} catch (const std::exception& e) {
    std::printf("%s\n", e.what());
    return 1;
}
