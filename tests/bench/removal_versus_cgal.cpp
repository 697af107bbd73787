// SPDX-License-Identifier: MIT
// Times the removal of a tenth of the points, drawn at random, on the seven distributions: by mgdt
// in one batch and in single calls, and by CGAL, beside the insertion of all of them by each.
//
//   removal_versus_cgal [points [runs [distribution...]]]
// Ends with a vertex of degree 10,000.
//
// White-box: it calls the library's own object. Figures are medians of interleaved runs, in
// microseconds per point; "/ insert" is the ratio to the insertion of a point in the same run.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "cli/point_sets/distributions.hpp"
#include "core/triangulation.hpp"
#include "measure.hpp"

namespace {

using bench::median;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Base = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using Cgal = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Base>>;

struct Figures {
    std::vector<double> insert, batch, single, cgal_insert, cgal_remove;
    bool are_equal = true;  // the numbers of tetrahedra, where no points are equal
};

void insert(mgdt::Triangulation& t, const std::vector<double>& xyz) {
    const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    t.insert(xyz.size() / 3, axis, 3);
}

void remove(mgdt::Triangulation& t, const std::uint32_t* points, std::size_t n) {
    mgdt::Buffer<std::uint32_t> list(t.allocator());
    list.reserve(n);
    for (std::size_t i = 0; i < n; ++i) list.push_back(points[i]);
    t.remove(list);
}

void run(const std::vector<double>& xyz, const std::vector<std::uint32_t>& removed, Figures& f) {
    const auto per_point = [](double seconds, std::size_t n) {
        return seconds * 1e6 / static_cast<double>(n);
    };
    const std::size_t n = xyz.size() / 3, few = std::min<std::size_t>(removed.size(), 10000);
    mgdt::Triangulation batch(nullptr, nullptr, nullptr), single(nullptr, nullptr, nullptr);
    f.insert.push_back(per_point(bench::seconds([&] { insert(batch, xyz); }), n));
    f.batch.push_back(per_point(
        bench::seconds([&] { remove(batch, removed.data(), removed.size()); }), removed.size()));
    insert(single, xyz);
    f.single.push_back(per_point(bench::seconds([&] {
                                     for (std::size_t i = 0; i < few; ++i)
                                         remove(single, &removed[i], 1);
                                 }),
                                 few));

    std::vector<std::pair<Cgal::Point, std::uint32_t>> points;
    for (std::size_t i = 0; i < n; ++i)
        points.emplace_back(Cgal::Point(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]),
                            static_cast<std::uint32_t>(i));
    Cgal cgal;
    f.cgal_insert.push_back(
        per_point(bench::seconds([&] { cgal.insert(points.begin(), points.end()); }), n));
    std::vector<Cgal::Vertex_handle> of(n);
    for (auto v = cgal.finite_vertices_begin(); v != cgal.finite_vertices_end(); ++v)
        of[v->info()] = v;
    f.cgal_remove.push_back(per_point(bench::seconds([&] {
                                          for (const std::uint32_t i : removed)
                                              if (of[i] != nullptr) cgal.remove(of[i]);
                                      }),
                                      removed.size()));
    // Of equal points, CGAL has one for all.
    if (batch.statistics().duplicates == 0)
        f.are_equal = f.are_equal && cgal.number_of_finite_cells() == batch.mesh().finite_count();
}

// A point with all others, on a sphere, around it: its removal beside a triangulation of these.
void run_hub(std::size_t n, int runs) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    std::vector<double> around;
    while (around.size() < 3 * n) {
        double p[3], square = 0;
        for (double& x : p) {
            x = normal(random);
            square += x * x;
        }
        for (const double x : p) around.push_back(x / std::sqrt(square));
    }
    std::vector<double> all(3, 0.0), seconds, of_link;
    all.insert(all.end(), around.begin(), around.end());
    const std::uint32_t hub = 0;
    for (int k = 0; k < runs; ++k) {
        mgdt::Triangulation t(nullptr, nullptr, nullptr), link(nullptr, nullptr, nullptr);
        insert(t, all);
        seconds.push_back(bench::seconds([&] { remove(t, &hub, 1); }));
        of_link.push_back(bench::seconds([&] { insert(link, around); }));
    }
    std::printf(
        "%zu points on a sphere around one: it leaves in %.3f s, %.1f times their insertion\n", n,
        median(seconds), median(seconds) / median(of_link));
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t n = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100000;
    const int runs = argc > 2 ? std::atoi(argv[2]) : 3;
    std::vector<std::string> names(argv + std::min(argc, 3), argv + argc);
    if (names.empty())
        names = {"uniform", "line", "diagonal", "ellipse", "spiral", "cluster", "galaxy"};
    std::printf("%zu points, a tenth removed, medians of %d interleaved runs, one thread\n", n,
                runs);
    std::printf("%-10s %8s %8s %9s %8s %9s %8s %9s %7s %7s\n", "set", "insert", "batch", "/ insert",
                "single", "/ insert", "CGAL in", "CGAL out", "/ batch", "/single");
    bool are_equal = true;
    for (const std::string& name : names) {
        const std::vector<double> xyz = mgdt::cli::generate(name, n, {});
        std::vector<std::uint32_t> order(n);
        for (std::uint32_t i = 0; i < n; ++i) order[i] = i;
        std::shuffle(order.begin(), order.end(), std::mt19937(1));
        order.resize(n / 10);
        Figures f;
        for (int k = 0; k < runs; ++k) run(xyz, order, f);
        const double in = median(f.insert), batch = median(f.batch), single = median(f.single),
                     out = median(f.cgal_remove);
        std::printf("%-10s %8.3f %8.3f %9.2f %8.3f %9.2f %8.3f %9.3f %7.2f %7.2f%s\n", name.c_str(),
                    in, batch, batch / in, single, single / in, median(f.cgal_insert), out,
                    out / batch, out / single, f.are_equal ? "" : "  DIFFERENT TETRAHEDRA");
        are_equal = are_equal && f.are_equal;
    }
    run_hub(10000, runs);
    return are_equal ? 0 : 1;
}
