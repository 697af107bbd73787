// SPDX-License-Identifier: MIT
// Calls of the library to which faults are done: every insertion that allocates in its own way,
// and every other call that allocates. Each can be made again and again on handles that are alike.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "../property/handle.hpp"
#include "../support/points.hpp"
#include "capi/triangulation_handle.hpp"
#include "faults.h"

namespace faults {

using mgdt_tests::Points;
using property::Handle;
using Numbers = std::vector<std::int64_t>;

inline std::int64_t count(const Points& xyz) {
    return static_cast<std::int64_t>(xyz.size() / 3);
}

// Coordinates are multiples of 1/grid, or any if grid is 0.
inline Points random_points(std::size_t n, unsigned seed, int grid = 0) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    Points xyz(3 * n);
    for (double& x : xyz) {
        x = uniform(random);
        if (grid != 0) x = std::floor(x * grid) / grid;
    }
    return xyz;
}

inline Points flat_points(std::size_t n, unsigned seed) {
    Points xyz = random_points(n, seed);
    for (std::size_t i = 2; i < xyz.size(); i += 3) xyz[i] = 0.5;
    return xyz;
}

// Rounded onto a sphere about the middle of the unit cube: the middle has them all as neighbours.
inline Points sphere_points(std::size_t n, unsigned seed) {
    Points xyz = random_points(n, seed);
    for (std::size_t i = 0; i < xyz.size(); i += 3) {
        const double x = xyz[i] - 0.5, y = xyz[i + 1] - 0.5, z = xyz[i + 2] - 0.5;
        const double length = std::sqrt(x * x + y * y + z * z);
        for (std::size_t k = 0; k < 3; ++k) xyz[i + k] = (xyz[i + k] - 0.5) / length + 0.5;
    }
    return xyz;
}

inline Points scaled(Points xyz, double factor) {
    for (double& x : xyz) x *= factor;
    return xyz;
}

inline Points joined(Points a, const Points& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// A handle and all that it was given.
class Story {
  public:
    // Threads have work from `share` points on; 0 for the library's own share.
    Story(bool own_allocator, std::int32_t threads, std::size_t share, std::int32_t scheme) {
        mgdt_triangulation* t = nullptr;
        const mgdt_status status =
            own_allocator ? mgdt_create_with_allocator(handle_take, handle_give, nullptr, &t)
                          : mgdt_create(&t);
        EXPECT_EQ(status, MGDT_OK);
        handle_.reset(t);
        EXPECT_EQ(mgdt_set_threads(t, threads), MGDT_OK);
        EXPECT_EQ(mgdt_set_order_scheme(t, scheme), MGDT_OK);
        if (share == 0) return;
        t->object.hooks().min_points_per_thread = share;
        t->object.hooks().zones = mgdt::ZoneUse::always;
    }
    mgdt_triangulation* handle() const { return handle_.get(); }

    // After a call that was to insert the points: it has counted all of them or none.
    bool note(const Points& xyz) {
        const std::size_t counted =
            static_cast<std::size_t>(mgdt_point_count(handle())) - given_.size() / 3;
        EXPECT_TRUE(counted == 0 || 3 * counted == xyz.size()) << counted;
        if (counted != 0) given_.insert(given_.end(), xyz.begin(), xyz.end());
        return counted != 0;
    }
    void insert(const Points& xyz) {
        EXPECT_EQ(mgdt_insert_points(handle(), count(xyz), xyz.data()), MGDT_OK)
            << property::error_of(handle());
        note(xyz);
    }

    // The tetrahedra as the library exports them, in canonical order.
    Numbers exported() const {
        EXPECT_EQ(mgdt_set_canonical_output(handle(), 1), MGDT_OK);
        Numbers all = property::tetrahedra(handle());
        for (const auto& more : {property::neighbors(handle()), property::hull_facets(handle()),
                                 property::edges(handle()), property::point_map(handle())})
            all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    // The tetrahedra in terms of the set of points, whatever their indices are.
    property::Keys geometry() const {
        using Point = std::array<double, 3>;
        std::vector<Point> places;
        for (std::size_t i = 0; i < given_.size(); i += 3)
            places.push_back({given_[i] + 0.0, given_[i + 1] + 0.0, given_[i + 2] + 0.0});
        std::vector<Point> sorted = places;
        std::sort(sorted.begin(), sorted.end());
        sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
        Numbers tetrahedra = property::tetrahedra(handle());
        for (std::int64_t& v : tetrahedra)
            v = std::lower_bound(sorted.begin(), sorted.end(),
                                 places[static_cast<std::size_t>(v)]) -
                sorted.begin();
        return property::keys(tetrahedra);
    }
    // What every call leaves, however it ended.
    void expect_valid() const {
        ASSERT_EQ(mgdt_check(handle(), MGDT_CHECK_CANONICAL), MGDT_OK)
            << property::error_of(handle());
        const Numbers map = property::point_map(handle());
        std::int64_t vertices = 0;
        for (std::size_t i = 0; i < map.size(); ++i) {
            vertices += map[i] == static_cast<std::int64_t>(i);
            if (map[i] < 0) continue;
            const std::size_t v = static_cast<std::size_t>(map[i]);
            for (std::size_t k = 0; k < 3; ++k)
                ASSERT_EQ(given_[3 * i + k], given_[3 * v + k]) << i << " stands for " << v;
        }
        ASSERT_EQ(vertices, mgdt_vertex_count(handle()));
    }

  private:
    Handle handle_;
    Points given_;
};

// An insertion: `before` is in, in one call or point by point, when `batch` comes.
struct Insertion {
    std::string name;
    Points before, batch;
    bool one_by_one = false;
    std::int32_t scheme = MGDT_ORDER_AUTO;
    std::int32_t threads = 1;
    std::size_t share = 40;
    // Points before span no space: they go in with the batch, and running out of memory may lose
    // them.
    bool holds = false;

    Story begin(bool own_allocator) const {
        Story story(own_allocator, threads, share, scheme);
        if (!one_by_one) {
            story.insert(before);
            return story;
        }
        for (auto p = before.begin(); p != before.end(); p += 3) story.insert(Points(p, p + 3));
        return story;
    }
};

// For GoogleTest, which would print bytes, padding too.
inline void PrintTo(const Insertion& insertion, std::ostream* out) {
    *out << insertion.name;
}

inline std::vector<Insertion> insertions() {
    const std::size_t n = is_small() ? 60 : 160;
    const Points some = random_points(n, 1), others = random_points(n, 2);
    const Points lattice = random_points(n, 3, 5), flat = flat_points(n, 4);
    std::vector<Insertion> all;
    const auto add = [&](std::string name, Points before, Points batch) -> Insertion& {
        all.push_back({});
        all.back().name = std::move(name);
        all.back().before = std::move(before);
        all.back().batch = std::move(batch);
        return all.back();
    };
    add("fresh", {}, some);
    add("more", some, others);
    add("repeats", lattice, random_points(n, 5, 5));
    add("the same again", some, some);
    add("flat", {}, flat);
    add("more flat", flat, flat_points(n, 6)).holds = true;
    add("flat, then space", flat, some).holds = true;
    add("few", {}, Points(some.begin(), some.begin() + 9));
    add("one", some, Points(others.begin(), others.begin() + 3));
    add("one in a star of all", sphere_points(is_small() ? 280 : 400, 7), {0.5, 0.5, 0.5});
    // At extreme scales every decision is exact and slow.
    const Points six(some.begin(), some.begin() + 18), ten(others.begin(), others.begin() + 30);
    add("another scale", six, scaled(ten, 1e200));
    add("extreme", scaled(six, 1e-300), scaled(ten, 1e300));
    // So many that the next needs memory: room for vertices grows by half whenever it is full.
    Insertion& lone =
        add("one by one", random_points(710, 8), Points(some.begin(), some.begin() + 3));
    lone.one_by_one = true;
    for (const std::int32_t scheme : order_schemes) {
        if (scheme == MGDT_ORDER_AUTO) continue;
        Insertion& i = add(mgdt_order_scheme_name(scheme), {}, joined(lattice, some));
        i.scheme = scheme;
    }
    for (const std::int32_t threads : {2, 3}) {
        const std::string with = ", " + std::to_string(threads) + " threads";
        add("fresh" + with, {}, joined(some, others)).threads = threads;
        add("repeats" + with, lattice, joined(random_points(n, 9, 5), others)).threads = threads;
        Insertion& held = add("flat, then space" + with, flat, some);
        held.holds = true;
        held.threads = threads;
        Insertion& scheme = add("kd-tree" + with, some, joined(lattice, others));
        scheme.threads = threads;
        scheme.scheme = MGDT_ORDER_KD_TREE;
    }
    if (is_small()) {
        std::vector<Insertion> few;
        for (std::size_t k = 0; k < all.size(); k += 3) few.push_back(all[k]);
        return few;
    }
    return all;
}

// What a call writes; large enough beforehand, so that the test itself takes no memory then.
struct Output {
    explicit Output(const mgdt_triangulation* t)
        : v(static_cast<std::size_t>(4 * mgdt_tetrahedron_count(t) + mgdt_point_count(t) + 1)),
          list(v.size()),
          v32(v.size()),
          list32(v.size()),
          queries(random_points(9000, 99)),
          found(9000),
          found32(9000),
          weights(4 * 9000),
          reals(static_cast<std::size_t>(
              std::max(3 * mgdt_tetrahedron_count(t), mgdt_point_count(t)))) {}
    bool operator==(const Output& o) const {
        return v == o.v && list == o.list && v32 == o.v32 && list32 == o.list32 &&
               found == o.found && found32 == o.found32 && weights == o.weights && reals == o.reals;
    }
    std::int64_t size() const { return static_cast<std::int64_t>(v.size()); }
    Numbers v, list;
    std::vector<std::int32_t> v32, list32;
    Points queries;
    Numbers found;
    std::vector<std::int32_t> found32;
    Points weights, reals;
};

// Where each place takes long.
constexpr std::int64_t some_places = 12;

// A call that inserts nothing. The last of them is the one that is not const.
struct Call {
    const char* name;
    mgdt_status (*make)(mgdt_triangulation* t, Output& o);
    bool asks_for_memory = true;  // on the sets of these tests
};

inline constexpr Call calls[] = {
    {"get_tetrahedra",
     [](mgdt_triangulation* t, Output& o) { return mgdt_get_tetrahedra(t, o.size(), o.v.data()); }},
    {"get_tetrahedra_i32",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_tetrahedra_i32(t, o.size(), o.v32.data());
     }},
    {"get_neighbors",
     [](mgdt_triangulation* t, Output& o) { return mgdt_get_neighbors(t, o.size(), o.v.data()); }},
    {"get_neighbors_i32",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_neighbors_i32(t, o.size(), o.v32.data());
     }},
    {"get_hull_facets", [](mgdt_triangulation* t,
                           Output& o) { return mgdt_get_hull_facets(t, o.size(), o.v.data()); }},
    {"get_hull_facets_i32",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_hull_facets_i32(t, o.size(), o.v32.data());
     }},
    {"get_edges",
     [](mgdt_triangulation* t, Output& o) { return mgdt_get_edges(t, o.size(), o.v.data()); }},
    {"get_edges_i32", [](mgdt_triangulation* t,
                         Output& o) { return mgdt_get_edges_i32(t, o.size(), o.v32.data()); }},
    {"get_point_map",
     [](mgdt_triangulation* t, Output& o) { return mgdt_get_point_map(t, o.size(), o.v.data()); }},
    {"get_point_map_i32",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_point_map_i32(t, o.size(), o.v32.data());
     }},
    {"get_vertex_tetrahedra",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_vertex_tetrahedra(t, o.size(), o.v.data(), o.size(), o.list.data());
     }},
    {"get_vertex_tetrahedra_i32",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_vertex_tetrahedra_i32(t, o.size(), o.v32.data(), o.size(),
                                               o.list32.data());
     }},
    {"get_vertex_neighbors",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_vertex_neighbors(t, o.size(), o.v.data(), o.size(), o.list.data());
     }},
    {"get_vertex_neighbors_i32",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_vertex_neighbors_i32(t, o.size(), o.v32.data(), o.size(), o.list32.data());
     }},
    {"get_gabriel_edges",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_gabriel_edges(t, o.size(), o.v.data(), o.list.data());
     }},
    {"get_gabriel_edges_i32",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_gabriel_edges_i32(t, o.size(), o.v32.data(), o.list32.data());
     }},
    {"get_spanning_tree",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_spanning_tree(t, o.size(), o.v.data(), o.list.data());
     }},
    {"get_spanning_tree_i32",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_spanning_tree_i32(t, o.size(), o.v32.data(), o.list32.data());
     }},
    {"get_circumcenters",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_circumcenters(t, mgdt_tetrahedron_count(t), o.reals.data(), nullptr);
     }},
    {"get_tetrahedron_measures",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_RADIUS_RATIO,
                                              mgdt_tetrahedron_count(t), o.reals.data());
     }},
    {"get_alphas",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_alphas(t, 3, mgdt_tetrahedron_count(t), o.reals.data());
     }},
    {"get_alpha_surface",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_alpha_surface(t, 0.1, o.size(), o.v.data(), o.list.data());
     }},
    {"get_alpha_surface_i32",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_get_alpha_surface_i32(t, 1e300, o.size(), o.v32.data(), o.list32.data());
     }},
    {"get_solid_alpha",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_dimension(t) < 3 ? MGDT_OK : mgdt_get_solid_alpha(t, o.reals.data());
     }},
    {"get_cell_measures",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_dimension(t) < 3 ? MGDT_OK
                                      : mgdt_get_cell_measures(t, MGDT_MEASURE_FACES, 0, nullptr,
                                                               mgdt_point_count(t), o.reals.data());
     }},
    {"voronoi_create",
     [](mgdt_triangulation* t, Output& o) -> mgdt_status {
         if (mgdt_dimension(t) < 3) return MGDT_OK;
         mgdt_voronoi* v = nullptr;
         const mgdt_status status = mgdt_voronoi_create(t, 0, nullptr, &v);
         if (status != MGDT_OK) return v == nullptr ? status : mgdt_status(MGDT_ERR_INTERNAL);
         const mgdt_status volumes = mgdt_voronoi_get_doubles(v, MGDT_VORONOI_ARRAY_CELL_VOLUMES,
                                                              mgdt_point_count(t), o.reals.data());
         mgdt_voronoi_destroy(v);
         return volumes;
     }},
    {"interpolate",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_dimension(t) < 3
                    ? MGDT_OK
                    : mgdt_interpolate(t, MGDT_INTERPOLATE_SIBSON_C1, MGDT_OUTSIDE_LINEAR, 1,
                                       o.reals.data(), some_places, o.queries.data(),
                                       o.weights.data());
     }},
    {"get_interpolation_weights",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_dimension(t) < 3
                    ? MGDT_OK
                    : mgdt_get_interpolation_weights(
                          t, MGDT_INTERPOLATE_LAPLACE, MGDT_OUTSIDE_LINEAR, some_places,
                          o.queries.data(), some_places + 1, o.found.data(), 0, nullptr, nullptr);
     }},
    {"get_gradients",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_dimension(t) < 3
                    ? MGDT_OK
                    : mgdt_get_gradients(t, 1, o.reals.data() + 3 * mgdt_point_count(t),
                                         o.reals.data());
     }},
    {"locate", [](mgdt_triangulation* t,
                  Output& o) { return mgdt_locate(t, o.queries.data(), o.found.data()); }},
    {"traverse_segment",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_traverse_segment(t, o.queries.data(), o.queries.data() + 3, o.size(),
                                      o.v.data(), nullptr, o.list.data());
     }},
    {"locate_points",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_locate_points(t, count(o.queries), o.queries.data(), o.found.data(),
                                   o.weights.data());
     }},
    {"locate_points_i32",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_locate_points_i32(t, count(o.queries), o.queries.data(), o.found32.data(),
                                       nullptr);
     }},
    {"nearest_vertex",
     [](mgdt_triangulation* t, Output& o) {
         return mgdt_nearest_vertex(t, o.queries.data(), o.found.data());
     },
     false},  // only where a vertex has very many neighbours: see allocator_test.cpp
    {"check 1", [](mgdt_triangulation* t, Output&) { return mgdt_check(t, 1); }},
    {"check 2", [](mgdt_triangulation* t, Output&) { return mgdt_check(t, 2); }},
    {"check 3", [](mgdt_triangulation* t, Output&) { return mgdt_check(t, 3); }},
    {"reserve",
     [](mgdt_triangulation* t, Output&) { return mgdt_reserve(t, 4 * mgdt_point_count(t)); }},
};

}  // namespace faults
