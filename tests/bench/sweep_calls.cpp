// SPDX-License-Identifier: MIT
// Looks for the sets of points on which the calls after an insertion take longest: families of
// sets, each call timed with one thread. The last lines have each column's median over the
// families, and its worst families as multiples of the median.
//
//   sweep_calls [--points N] [--worst N] [FAMILY...]
//
// Columns:
//   insert   microseconds per point of the insertion of all points in one call
//   tenth    time of the removal of a tenth of the points in one call, over that of their insertion
//   half     likewise of every second point
//   cells    microseconds per tetrahedron, a fourth of the cells' corners, for volumes of cells in
//            the box of the points, enlarged by a tenth
//   inner    likewise without a box
//   alphas   microseconds per tetrahedron for the alphas of facets
//   sibson   microseconds per neighbour of a place for Sibson's interpolation at 100 places
//
// FAMILY is a part of a family's name; without any, all families are taken.
#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "../support/points.hpp"
#include "measure.hpp"
#include "mgdt/mgdt.h"
#include "sweep_families.hpp"

namespace {

using mgdt_tests::Points;

struct Destroy {
    void operator()(mgdt_triangulation* t) const noexcept { mgdt_destroy(t); }
};
using Handle = std::unique_ptr<mgdt_triangulation, Destroy>;

constexpr int columns = 7;
const char* const names[columns] = {"insert", "tenth",  "half",  "cells",
                                    "inner",  "alphas", "sibson"};

struct Row {
    std::string family;
    std::size_t points;
    double value[columns];  // NaN where the call refuses the set
};

Handle inserted(const Points& xyz) {
    mgdt_triangulation* t = nullptr;
    if (mgdt_create(&t) != MGDT_OK) throw std::runtime_error("out of memory");
    Handle handle(t);
    if (mgdt_insert_points(t, static_cast<std::int64_t>(xyz.size() / 3), xyz.data()) != MGDT_OK)
        throw std::runtime_error("the points were not inserted");
    return handle;
}

// The least of a few runs, unless one takes long; NaN where the body refuses.
template <class Body>
double least_seconds(const Body& body) {
    double least = NAN;
    for (int run = 0; run < 3; ++run) {
        bool is_done = false;
        const double seconds = bench::processor_seconds([&] { is_done = body(); });
        if (!is_done) return NAN;
        least = run == 0 ? seconds : std::min(least, seconds);
        if (seconds > 0.3) break;
    }
    return least;
}

double removal_seconds(const Points& xyz, std::size_t step) {
    const std::size_t n = xyz.size() / 3;
    std::vector<std::int64_t> out;
    for (std::size_t i = 0; i < n; i += step) out.push_back(static_cast<std::int64_t>(i));
    double least = NAN;
    for (int run = 0; run < 3; ++run) {
        const Handle t = inserted(xyz);
        const double seconds = bench::processor_seconds([&] {
            mgdt_remove_points(t.get(), static_cast<std::int64_t>(out.size()), out.data());
        });
        least = run == 0 ? seconds : std::min(least, seconds);
        if (seconds > 0.3) break;
    }
    return least;
}

Row measured(const bench::Family& family, std::size_t size) {
    const Points xyz = family.points(std::min(size, family.most));
    const std::size_t n = xyz.size() / 3;
    const auto count = static_cast<double>(n);
    Row row = {family.name, n, {}};
    Handle t;
    const double insertion = least_seconds([&] { return t.reset(), t = inserted(xyz), true; });
    row.value[0] = 1e6 * insertion / count;
    row.value[1] = removal_seconds(xyz, 10) / insertion;
    row.value[2] = removal_seconds(xyz, 2) / insertion;
    Points low(3, INFINITY), high(3, -INFINITY);
    for (std::size_t i = 0; i < xyz.size(); ++i) {
        low[i % 3] = std::min(low[i % 3], xyz[i]);
        high[i % 3] = std::max(high[i % 3], xyz[i]);
    }
    Points planes;
    for (std::size_t k = 0; k < 3; ++k)
        for (const double sign : {1.0, -1.0}) {
            Points plane(4);
            const double margin = 0.1 * (high[k] / 2 - low[k] / 2);
            plane[k] = sign;
            plane[3] = std::min(DBL_MAX, sign > 0 ? high[k] + margin : margin - low[k]);
            planes.insert(planes.end(), plane.begin(), plane.end());
        }
    Points volumes(n);
    const auto cells = [&](std::int64_t n_planes) {
        return least_seconds([&] {
            return mgdt_get_cell_measures(t.get(), MGDT_MEASURE_VOLUME, n_planes, planes.data(),
                                          static_cast<std::int64_t>(n), volumes.data()) == MGDT_OK;
        });
    };
    const std::int64_t tetrahedra = mgdt_tetrahedron_count(t.get());
    row.value[3] = 1e6 * cells(6) / static_cast<double>(tetrahedra);
    row.value[4] = 1e6 * cells(0) / static_cast<double>(tetrahedra);
    Points alphas(4 * static_cast<std::size_t>(tetrahedra));
    row.value[5] = 1e6 * least_seconds([&] {
                       return tetrahedra > 0 &&
                              mgdt_get_alphas(t.get(), 2, 4 * tetrahedra, alphas.data()) == MGDT_OK;
                   }) /
                   static_cast<double>(tetrahedra);
    // Means of vertices, so that places are where vertices are, and of the hull's extent.
    constexpr std::size_t places = 100;
    std::mt19937_64 random(5);
    Points at;
    for (std::size_t i = 0; i < places; ++i) {
        const double *const a = &xyz[3 * (random() % n)], *const b = &xyz[3 * (random() % n)],
                            *const c = &xyz[3 * (random() % n)],
                            *const d = &xyz[3 * (random() % n)];
        for (std::size_t k = 0; k < 3; ++k)
            at.push_back((a[k] / 4 + b[k] / 4) + (c[k] / 4 + d[k] / 4));
    }
    Points values(n, 1), results(places);
    const double sibson = least_seconds([&] {
        return mgdt_interpolate(t.get(), MGDT_INTERPOLATE_SIBSON, MGDT_OUTSIDE_NONE, 1,
                                values.data(), places, at.data(), results.data()) == MGDT_OK;
    });
    std::vector<std::int64_t> offsets(places + 1);
    mgdt_get_interpolation_weights(t.get(), MGDT_INTERPOLATE_SIBSON, MGDT_OUTSIDE_NONE, places,
                                   at.data(), places + 1, offsets.data(), 0, nullptr, nullptr);
    row.value[6] = 1e6 * sibson / static_cast<double>(offsets[places]);
    return row;
}

void print(const Row& row) {
    std::printf("%-44s %7zu", row.family.c_str(), row.points);
    for (const double x : row.value) std::printf(" %9.3f", x);
    std::printf("\n");
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
    std::size_t size = 1000, worst = 5;
    std::vector<std::string> families;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if ((argument == "--points" || argument == "--worst") && i + 1 < argc)
            (argument == "--points" ? size : worst) = std::stoul(argv[++i]);
        else
            families.push_back(argument);
    }
    std::printf("%-44s %7s", "family", "points");
    for (const char* name : names) std::printf(" %9s", name);
    std::printf("\n");
    std::vector<Row> rows;
    for (const bench::Family& family : bench::sweep_families()) {
        if (!families.empty() &&
            std::none_of(families.begin(), families.end(), [&](const std::string& f) {
                return family.name.find(f) != std::string::npos;
            }))
            continue;
        rows.push_back(measured(family, size));
        print(rows.back());
    }
    std::printf("\n");
    for (int c = 0; c < columns; ++c) {
        std::vector<const Row*> sorted;
        std::vector<double> values;
        for (const Row& row : rows)
            if (!std::isnan(row.value[c])) {
                sorted.push_back(&row);
                values.push_back(row.value[c]);
            }
        if (values.empty()) continue;
        std::sort(sorted.begin(), sorted.end(),
                  [c](const Row* a, const Row* b) { return a->value[c] > b->value[c]; });
        const double median = bench::median(values);
        std::printf("%-9s median %.3f; worst", names[c], median);
        for (std::size_t i = 0; i < std::min(worst, sorted.size()); ++i)
            std::printf("%s %.1f %s", i == 0 ? "" : ",", sorted[i]->value[c] / median,
                        sorted[i]->family.c_str());
        std::printf("\n");
    }
    return 0;
} catch (const std::exception& e) {
    std::printf("%s\n", e.what());
    return 1;
}
