// SPDX-License-Identifier: MIT
// Times what a program does besides one large triangulation, mgdt and CGAL side by side: many small
// triangulations, points inserted one at a time, location, nearest vertices and export. Runs are
// interleaved so that all meet the same noise; figures are medians, in microseconds.
//
//   calls_versus_cgal [points [runs]]
//
// The first table is of small sets from points to arrays: make, insert, export tetrahedra and
// neighbours, take down. The second is of calls on a triangulation of many uniform points. Its
// column "share" is mgdt's figure over its microseconds a point for the whole triangulation: of a
// single call how many points it is worth, of what is done for all points the share of the time.
// "fast" is CGAL with its Fast_location policy. What mgdt puts off until it is needed is in the
// figure of the first to need it: the numbers of the tetrahedra in an export's, whatever helps to
// find places in that of locating many.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/point_sets/distributions.hpp"
#include "measure.hpp"
#include "mgdt/mgdt.h"

namespace {

using bench::median;

// Calls of each kind that are made one at a time.
constexpr std::size_t single_calls = 20000;
// Segments, from each of as many places to the next one.
constexpr std::size_t segments = 200;

template <class Body>
double microseconds_each(std::size_t count, Body body) {
    return 1e6 * bench::seconds(body) / static_cast<double>(count);
}

std::vector<double> uniform(std::size_t n, std::uint64_t seed, double scale = 1) {
    mgdt::cli::GenerateOptions options;
    options.seed = seed;
    options.scale = scale;
    return mgdt::cli::generate("uniform", n, options);
}

/// Room for an export; what is longer than it needs to be stays, as in a program that reuses it.
template <class Int>
struct Arrays {
    std::vector<Int> tetrahedra, neighbors;

    void make_room(std::size_t count) {
        if (tetrahedra.size() >= 4 * count) return;
        tetrahedra.resize(4 * count);
        neighbors.resize(4 * count);
    }
};

// ------------------------------------------------------------------------------------- mgdt

void require(mgdt_status status, const char* call) {
    if (status == MGDT_OK) return;
    throw std::runtime_error(std::string(call) + ": " + mgdt_status_string(status));
}

struct Destroy {
    void operator()(mgdt_triangulation* t) const noexcept { mgdt_destroy(t); }
};
using Handle = std::unique_ptr<mgdt_triangulation, Destroy>;

Handle create() {
    mgdt_triangulation* t = nullptr;
    require(mgdt_create(&t), "mgdt_create");
    return Handle(t);
}

void insert(mgdt_triangulation* t, std::size_t n, const double* xyz) {
    require(mgdt_insert_points(t, static_cast<std::int64_t>(n), xyz), "mgdt_insert_points");
}

std::size_t tetrahedron_count(const mgdt_triangulation* t) {
    return static_cast<std::size_t>(mgdt_tetrahedron_count(t));
}

void get(const mgdt_triangulation* t, Arrays<std::int64_t>& out) {
    const std::int64_t capacity = static_cast<std::int64_t>(out.tetrahedra.size());
    require(mgdt_get_tetrahedra(t, capacity, out.tetrahedra.data()), "mgdt_get_tetrahedra");
    require(mgdt_get_neighbors(t, capacity, out.neighbors.data()), "mgdt_get_neighbors");
}

void get(const mgdt_triangulation* t, Arrays<std::int32_t>& out) {
    const std::int64_t capacity = static_cast<std::int64_t>(out.tetrahedra.size());
    require(mgdt_get_tetrahedra_i32(t, capacity, out.tetrahedra.data()), "mgdt_get_tetrahedra_i32");
    require(mgdt_get_neighbors_i32(t, capacity, out.neighbors.data()), "mgdt_get_neighbors_i32");
}

// ------------------------------------------------------------------------------------- CGAL

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Compact = CGAL::Delaunay_triangulation_3<Kernel>;
using Fast = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location>;

/// Of a cell; infinite ones keep what a new cell has, which is mgdt's number for none.
struct Number {
    std::int32_t value = -1;
};
// With the numbers that an export writes. The cell's fits into padding, the vertex's does not, so
// this type is for exports alone.
using Numbered = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<
                CGAL::Triangulation_vertex_base_with_info_3<std::int32_t, Kernel>,
                CGAL::Triangulation_cell_base_with_info_3<
                    Number, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>>;
using NumberedPoint = std::pair<Point, std::int32_t>;

std::vector<Point> to_points(const std::vector<double>& xyz) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < xyz.size(); i += 3)
        points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
    return points;
}

/// Points in sets of n, numbered from 0 in each.
std::vector<NumberedPoint> to_numbered_points(const std::vector<double>& xyz, std::size_t n) {
    std::vector<NumberedPoint> points;
    for (const Point& p : to_points(xyz))
        points.emplace_back(p, static_cast<std::int32_t>(points.size() % n));
    return points;
}

template <class Int>
void get(const Numbered& t, Arrays<Int>& out) {
    std::int32_t count = 0;
    for (const Numbered::Cell_handle c : t.finite_cell_handles()) c->info().value = count++;
    Int* tetrahedron = out.tetrahedra.data();
    Int* neighbor = out.neighbors.data();
    for (const Numbered::Cell_handle c : t.finite_cell_handles()) {
        for (int i = 0; i < 4; ++i) {
            *tetrahedron++ = c->vertex(i)->info();
            *neighbor++ = c->neighbor(i)->info().value;
        }
    }
}

// ------------------------------------------------------------------------------- small sets

double small_mgdt(const std::vector<double>& xyz, std::size_t n, Arrays<std::int64_t>& out) {
    return microseconds_each(xyz.size() / 3, [&] {
        for (std::size_t i = 0; i < xyz.size(); i += 3 * n) {
            const Handle t = create();
            insert(t.get(), n, &xyz[i]);
            out.make_room(tetrahedron_count(t.get()));
            get(t.get(), out);
        }
    });
}

double small_cgal(const std::vector<NumberedPoint>& points, std::size_t n,
                  Arrays<std::int64_t>& out) {
    return microseconds_each(points.size(), [&] {
        for (auto p = points.begin(); p != points.end(); p += static_cast<std::ptrdiff_t>(n)) {
            const Numbered t(p, p + static_cast<std::ptrdiff_t>(n));
            out.make_room(t.number_of_cells());  // with the infinite ones; counting takes longer
            get(t, out);
        }
    });
}

void compare_small_sets(int runs) {
    std::printf("sets of n uniform points, from points to arrays: microseconds a point\n");
    std::printf("%8s %9s %9s %6s\n", "n", "mgdt", "CGAL", "ratio");
    for (const std::size_t n : {4u, 10u, 100u, 1000u, 10000u}) {
        // Each set another one, so that branches are not learnt by heart.
        const std::vector<double> xyz = uniform(20000 / n * n, n);
        const std::vector<NumberedPoint> points = to_numbered_points(xyz, n);
        Arrays<std::int64_t> out;
        out.make_room(8 * n);
        std::vector<double> ours, theirs;
        for (int run = 0; run < runs; ++run) {
            ours.push_back(small_mgdt(xyz, n, out));
            theirs.push_back(small_cgal(points, n, out));
        }
        std::printf("%8zu %9.3f %9.3f %6.2f\n", n, median(ours), median(theirs),
                    median(theirs) / median(ours));
        std::fflush(stdout);
    }
}

// ------------------------------------------------------------------------------------ calls

struct Input {
    explicit Input(std::size_t n)
        : points(uniform(n, 1)),
          queries(uniform(n, 2)),
          to_locate(uniform(single_calls, 3)),
          to_approach(uniform(single_calls, 4)),
          anywhere(uniform(single_calls, 5)),
          local(uniform(single_calls, 6, 0.05)) {
        for (double& x : local) x += 0.475;  // a cube of side 0.05 in the middle
    }
    std::size_t size() const { return points.size() / 3; }

    // Each kind of call has places of its own: none finds what another has brought to the cache.
    std::vector<double> points, queries, to_locate, to_approach, anywhere, local;
};

/// Microseconds, an entry a run.
struct Figure {
    std::vector<double> mgdt, compact, fast;
};
using Library = std::vector<double> Figure::*;

struct Figures {
    Figure triangulate, insert_random, insert_local, locate_points, locate, nearest, export_64,
        export_32, export_canonical, nearest_many, traverse;
};

/// What the calls answered, to compare the libraries by.
struct Answers {
    std::size_t outside = 0;  // the hull
    double nearest = 0;       // x of nearest vertices, summed
    std::size_t tetrahedra = 0;
    std::size_t passages = 0;  // of segments through tetrahedra

    bool operator!=(const Answers& other) const {
        return outside != other.outside || nearest != other.nearest ||
               tetrahedra != other.tetrahedra || passages != other.passages;
    }
};

template <class Int>
double time_export(const mgdt_triangulation* t, std::size_t points) {
    Arrays<Int> out;
    out.make_room(tetrahedron_count(t));
    return microseconds_each(points, [&] { get(t, out); });
}

/// Each of these exports is the first after an insertion, as the 64-bit one is after the batch.
/// Here it is of a point that is in: the tetrahedra stay, what the handle knows of their numbers
/// does not.
void time_other_exports(mgdt_triangulation* t, const Input& input, Figures& f) {
    insert(t, 1, input.points.data());
    f.export_32.mgdt.push_back(time_export<std::int32_t>(t, input.size()));
    insert(t, 1, input.points.data());
    require(mgdt_set_canonical_output(t, 1), "mgdt_set_canonical_output");
    f.export_canonical.mgdt.push_back(time_export<std::int64_t>(t, input.size()));
    require(mgdt_set_canonical_output(t, 0), "mgdt_set_canonical_output");
}

void time_queries(const mgdt_triangulation* t, const Input& input, Figures& f, Answers& answers) {
    std::vector<std::int64_t> found(std::max(input.size(), single_calls));
    f.locate_points.mgdt.push_back(microseconds_each(input.size(), [&] {
        require(mgdt_locate_points(t, static_cast<std::int64_t>(input.size()), input.queries.data(),
                                   found.data(), nullptr),
                "mgdt_locate_points");
    }));
    f.locate.mgdt.push_back(microseconds_each(single_calls, [&] {
        for (std::size_t i = 0; i < single_calls; ++i)
            require(mgdt_locate(t, &input.to_locate[3 * i], &found[i]), "mgdt_locate");
    }));
    for (std::size_t i = 0; i < single_calls; ++i) answers.outside += found[i] < 0;
    std::vector<double> parameters(found.size() + 1);
    const double whole = microseconds_each(1, [&] {
        for (std::size_t i = 0; i < segments; ++i) {
            std::int64_t passed = 0;
            require(mgdt_traverse_segment(t, &input.to_locate[3 * i], &input.to_locate[3 * i + 3],
                                          static_cast<std::int64_t>(found.size()), found.data(),
                                          parameters.data(), &passed),
                    "mgdt_traverse_segment");
            answers.passages += static_cast<std::size_t>(passed);
        }
    });
    f.traverse.mgdt.push_back(whole / static_cast<double>(answers.passages));
    f.nearest_many.mgdt.push_back(microseconds_each(input.size(), [&] {
        require(mgdt_nearest_vertices(t, static_cast<std::int64_t>(input.size()),
                                      input.queries.data(), found.data()),
                "mgdt_nearest_vertices");
    }));
    f.nearest.mgdt.push_back(microseconds_each(single_calls, [&] {
        for (std::size_t i = 0; i < single_calls; ++i)
            require(mgdt_nearest_vertex(t, &input.to_approach[3 * i], &found[i]),
                    "mgdt_nearest_vertex");
    }));
    for (std::size_t i = 0; i < single_calls; ++i)
        answers.nearest += input.points[3 * static_cast<std::size_t>(found[i])];
}

double time_insertions(mgdt_triangulation* t, const std::vector<double>& xyz) {
    return microseconds_each(xyz.size() / 3, [&] {
        for (std::size_t i = 0; i < xyz.size(); i += 3) insert(t, 1, &xyz[i]);
    });
}

Answers run_mgdt(const Input& input, Figures& f) {
    Handle t;
    f.triangulate.mgdt.push_back(microseconds_each(input.size(), [&] {
        t = create();
        insert(t.get(), input.size(), input.points.data());
    }));
    Answers answers;
    f.export_64.mgdt.push_back(time_export<std::int64_t>(t.get(), input.size()));
    time_queries(t.get(), input, f, answers);
    time_other_exports(t.get(), input, f);
    f.insert_random.mgdt.push_back(time_insertions(t.get(), input.anywhere));
    f.insert_local.mgdt.push_back(time_insertions(t.get(), input.local));
    answers.tetrahedra = tetrahedron_count(t.get());
    return answers;
}

template <class Triangulation>
void time_queries(const Triangulation& t, const Input& input, Library library, Figures& f,
                  Answers& answers) {
    std::vector<Point> places = to_points(input.to_locate);
    std::vector<typename Triangulation::Cell_handle> cells(places.size());
    (f.locate.*library).push_back(microseconds_each(places.size(), [&] {
        for (std::size_t i = 0; i < places.size(); ++i) cells[i] = t.locate(places[i]);
    }));
    for (const auto c : cells) answers.outside += t.is_infinite(c);
    const double whole = microseconds_each(1, [&] {
        for (std::size_t i = 0; i < segments; ++i) {
            auto c = t.segment_traverser_cells_begin(places[i], places[i + 1]);
            for (; c != t.segment_traverser_cells_end(); ++c) answers.passages += !t.is_infinite(c);
        }
    });
    (f.traverse.*library).push_back(whole / static_cast<double>(answers.passages));
    places = to_points(input.to_approach);
    std::vector<typename Triangulation::Vertex_handle> vertices(places.size());
    (f.nearest.*library).push_back(microseconds_each(places.size(), [&] {
        for (std::size_t i = 0; i < places.size(); ++i) vertices[i] = t.nearest_vertex(places[i]);
    }));
    for (const auto v : vertices) answers.nearest += v->point().x();
}

template <class Triangulation>
void time_insertions(Triangulation& t, const Input& input, Library library, Figures& f) {
    std::vector<Point> places = to_points(input.anywhere);
    (f.insert_random.*library).push_back(microseconds_each(places.size(), [&] {
        for (const Point& p : places) t.insert(p);
    }));
    places = to_points(input.local);
    (f.insert_local.*library).push_back(microseconds_each(places.size(), [&] {
        // Its way to be told that points are near each other; mgdt has to see it by itself.
        auto last = t.infinite_vertex();
        for (const Point& p : places) last = t.insert(p, last->cell());
    }));
}

template <class Triangulation>
Answers run_cgal(const Input& input, Library library, Figures& f) {
    const std::vector<Point> points = to_points(input.points);
    Triangulation t;
    (f.triangulate.*library).push_back(microseconds_each(points.size(), [&] {
        t.insert(points.begin(), points.end());
    }));
    Answers answers;
    time_queries(t, input, library, f, answers);
    time_insertions(t, input, library, f);
    answers.tetrahedra = t.number_of_finite_cells();
    return answers;
}

void run_cgal_exports(const Input& input, Figures& f) {
    const std::vector<NumberedPoint> points = to_numbered_points(input.points, input.size());
    const Numbered t(points.begin(), points.end());
    Arrays<std::int64_t> wide;
    wide.make_room(t.number_of_cells());
    f.export_64.compact.push_back(microseconds_each(points.size(), [&] { get(t, wide); }));
    Arrays<std::int32_t> narrow;
    narrow.make_room(t.number_of_cells());
    f.export_32.compact.push_back(microseconds_each(points.size(), [&] { get(t, narrow); }));
}

void print_against(const std::vector<double>& theirs, double ours) {
    if (theirs.empty())
        std::printf(" %9s %6s", "-", "-");
    else
        std::printf(" %9.3f %6.2f", median(theirs), median(theirs) / ours);
}

void print_row(const char* name, const Figure& figure, const Figure& triangulate) {
    const double ours = median(figure.mgdt);
    std::printf("%-36s %9.3f %7.3f", name, ours, ours / median(triangulate.mgdt));
    print_against(figure.compact, ours);
    print_against(figure.fast, ours);
    std::printf("\n");
}

void print(const Figures& f) {
    std::printf("%-36s %9s %7s %9s %6s %9s %6s\n", "microseconds", "mgdt", "share", "CGAL", "ratio",
                "fast", "ratio");
    const auto row = [&](const char* name, const Figure& figure) {
        print_row(name, figure, f.triangulate);
    };
    row("triangulate, a point", f.triangulate);
    row("export, 64 bits, a point", f.export_64);
    row("export, 32 bits, a point", f.export_32);
    row("export, canonical, 64 bits, a point", f.export_canonical);
    row("locate as many points, a point", f.locate_points);
    row("locate, a call", f.locate);
    row("traverse segment, a tetrahedron", f.traverse);
    row("nearest vertex, a call", f.nearest);
    row("nearest of as many points, a point", f.nearest_many);
    row("insert one anywhere, a call", f.insert_random);
    row("insert one in a small cube, a call", f.insert_local);
}

void compare_calls(std::size_t points, int runs) {
    const Input input(points);
    Figures figures;
    for (int run = 0; run < runs; ++run) {
        const Answers ours = run_mgdt(input, figures);
        if (ours != run_cgal<Compact>(input, &Figure::compact, figures) ||
            ours != run_cgal<Fast>(input, &Figure::fast, figures))
            throw std::runtime_error("mgdt and CGAL differ in what they answer");
        run_cgal_exports(input, figures);
    }
    print(figures);
}

}  // namespace

int main(int argc, char** argv) try {
    const std::size_t points = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
    const int runs = std::max(1, argc > 2 ? std::atoi(argv[2]) : 3);
    std::printf("medians of %d interleaved runs, one thread\n\n", runs);
    compare_small_sets(runs);
    std::printf("\ncalls on a triangulation of %zu uniform points\n", points);
    compare_calls(points, runs);
    return 0;
} catch (const std::exception& e) {
    std::printf("%s\n", e.what());
    return 1;
}
