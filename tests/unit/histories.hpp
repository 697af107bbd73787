// SPDX-License-Identifier: MIT
// Triangulations that points come to, leave, and move in; and what they have to be.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "../support/limited_blocks.hpp"
#include "surgery.hpp"
#include "unwatched.hpp"

namespace mgdt {
namespace histories {

using namespace surgery;
using mgdt_tests::LimitedBlocks;

inline std::unique_ptr<Triangulation> empty(unsigned threads = 1) {
    auto t = std::make_unique<Triangulation>(nullptr, nullptr, nullptr);
    t->settings().threads = static_cast<std::int32_t>(threads);
    return t;
}

inline void remove(Triangulation& t, const std::vector<std::uint32_t>& points) {
    Buffer<std::uint32_t> list(t.allocator());
    list.reserve(points.size());
    for (const std::uint32_t i : points) list.push_back(i);
    t.remove(list);
}

inline void move(Triangulation& t, const std::vector<std::uint32_t>& points, const Points& places) {
    Buffer<std::uint32_t> list(t.allocator());
    list.reserve(points.size());
    for (const std::uint32_t i : points) list.push_back(i);
    t.move(list, places.data());
}

inline std::vector<std::uint32_t> points_in(const Triangulation& t) {
    std::vector<std::uint32_t> in;
    for (std::uint32_t i = 0; i < t.point_map().size(); ++i)
        if (t.point_map()[i] != infinite_vertex) in.push_back(i);
    return in;
}

inline std::string complaint(const Triangulation& t, int level = 3) {
    Team team;
    try {
        check_triangulation(team, t.check_input(), t.allocator(), level, 0, Unwatched());
        return {};
    } catch (const Error& error) {
        return error.message;
    }
}

// The tetrahedra by the caller's indices, each from its least one on, in order.
inline std::set<std::array<std::uint32_t, 4>> tetrahedra(const Triangulation& t) {
    std::set<std::array<std::uint32_t, 4>> all;
    for (TetId id = 0; id < t.mesh().tetrahedra.size(); ++id) {
        const Tetrahedron& record = t.mesh().tetrahedra[id];
        if (record.is_dead() || record.is_ghost()) continue;
        std::array<std::uint32_t, 4> v;
        for (unsigned i = 0; i < 4; ++i) v[i] = t.mesh().vertices[record.v[i]].index;
        std::sort(v.begin(), v.end());
        all.insert(v);
    }
    return all;
}

// The triangulation of the points that are in, given with the others left out.
inline void expect_as_fresh(const Triangulation& t, const Points& xyz) {
    ASSERT_EQ(complaint(t), "");
    Points rest;
    std::vector<std::uint32_t> index;
    for (std::uint32_t i = 0; i < t.point_map().size(); ++i) {
        if (t.point_map()[i] == infinite_vertex) continue;
        rest.insert(rest.end(), xyz.begin() + 3 * i, xyz.begin() + 3 * i + 3);
        index.push_back(i);
    }
    const auto fresh = empty();
    insert(*fresh, rest);
    EXPECT_EQ(t.dimension(), fresh->dimension());
    EXPECT_EQ(t.vertex_count(), fresh->vertex_count());
    EXPECT_EQ(t.statistics().duplicates, fresh->statistics().duplicates);
    std::set<std::array<std::uint32_t, 4>> expected;
    for (std::array<std::uint32_t, 4> v : tetrahedra(*fresh)) {
        for (std::uint32_t& i : v) i = index[i];
        expected.insert(v);
    }
    EXPECT_EQ(tetrahedra(t), expected);
}

inline Points sphere(std::size_t n, Random& random, bool with_centre) {
    Points xyz;
    for (std::size_t i = 0; i < n; ++i) {
        double p[3], square = 0;
        for (double& x : p) x = uniform(random) - 0.5;
        for (const double x : p) square += x * x;
        for (const double x : p) xyz.push_back(x / std::sqrt(square));
    }
    if (with_centre) xyz.insert(xyz.end(), {0, 0, 0});
    return xyz;
}

// Ties everywhere, repeats, points in a plane, coordinates that no filter is proved for.
inline std::vector<Points> sets(Random& random) {
    std::vector<Points> all = {uniform_points(300, random), lattice(6), sphere(150, random, true)};
    Points repeats = lattice(3), flat = uniform_points(60, random),
           tiny = uniform_points(80, random);
    for (std::size_t i = 0; i < 40; ++i)
        for (std::size_t k = 0; k < 3; ++k) repeats.push_back(repeats[3 * (i % 27) + k]);
    for (std::size_t i = 0; i < 55; ++i) flat[3 * i + 2] = 0.25;
    for (std::size_t i = 0; i < tiny.size(); ++i) tiny[i] *= i % 7 == 0 ? 1e-170 : 1e-160;
    Points mixed = uniform_points(100, random);
    for (std::size_t i = 0; i < 3 * 20; ++i) mixed[i] *= 1e200;
    all.insert(all.end(), {repeats, flat, tiny, mixed});
    return all;
}

}  // namespace histories
}  // namespace mgdt
