// SPDX-License-Identifier: MIT
// A triangulation made through the C interface, and everything that can be exported from it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "../support/messages.hpp"
#include "../support/schemes.hpp"
#include "../support/small.h"
#include "mgdt/mgdt.h"
#include "mgdt/mgdt_voronoi.h"

namespace property {

struct Destroy {
    void operator()(mgdt_triangulation* t) const noexcept { mgdt_destroy(t); }
};
using Handle = std::unique_ptr<mgdt_triangulation, Destroy>;

inline Handle create() {
    mgdt_triangulation* t = nullptr;
    EXPECT_EQ(mgdt_create(&t), MGDT_OK);
    return Handle(t);
}

using mgdt_tests::error_of;

// Inserts the points in batches that begin at the given positions (ascending, the first is 0).
inline mgdt_status insert(mgdt_triangulation* t, const std::vector<double>& xyz,
                          const std::vector<std::size_t>& batches) {
    const std::size_t n = xyz.size() / 3;
    for (std::size_t k = 0; k < batches.size(); ++k) {
        const std::size_t from = batches[k], to = k + 1 < batches.size() ? batches[k + 1] : n;
        const mgdt_status status =
            mgdt_insert_points(t, static_cast<std::int64_t>(to - from), xyz.data() + 3 * from);
        if (status != MGDT_OK) return status;
    }
    return MGDT_OK;
}

// n points in `count` batches of nearly equal size.
inline std::vector<std::size_t> equal_batches(std::size_t n, std::size_t count) {
    std::vector<std::size_t> begin;
    for (std::size_t k = 0; k < count; ++k) begin.push_back(n * k / count);
    return begin;
}

using GetArray = mgdt_status (*)(const mgdt_triangulation*, std::int64_t, std::int64_t*);

inline std::vector<std::int64_t> get(GetArray function, const mgdt_triangulation* t,
                                     std::int64_t size) {
    std::vector<std::int64_t> v(static_cast<std::size_t>(size));
    EXPECT_EQ(function(t, size, v.data()), MGDT_OK) << error_of(t);
    return v;
}

inline std::vector<std::int64_t> tetrahedra(const mgdt_triangulation* t) {
    return get(mgdt_get_tetrahedra, t, 4 * mgdt_tetrahedron_count(t));
}
inline std::vector<std::int64_t> neighbors(const mgdt_triangulation* t) {
    return get(mgdt_get_neighbors, t, 4 * mgdt_tetrahedron_count(t));
}
inline std::vector<std::int64_t> hull_facets(const mgdt_triangulation* t) {
    return get(mgdt_get_hull_facets, t, 3 * mgdt_hull_facet_count(t));
}
inline std::vector<std::int64_t> edges(const mgdt_triangulation* t) {
    return get(mgdt_get_edges, t, 2 * mgdt_edge_count(t));
}
inline std::vector<std::int64_t> point_map(const mgdt_triangulation* t) {
    return get(mgdt_get_point_map, t, mgdt_point_count(t));
}

// Tetrahedra as a set: vertices ascending in each, tetrahedra sorted.
using Key = std::array<std::uint32_t, 4>;
using Keys = std::vector<Key>;

inline Keys keys(const std::vector<std::int64_t>& tetrahedra) {
    Keys out(tetrahedra.size() / 4);
    for (std::size_t i = 0; i < out.size(); ++i) {
        for (std::size_t k = 0; k < 4; ++k)
            out[i][k] = static_cast<std::uint32_t>(tetrahedra[4 * i + k]);
        std::sort(out[i].begin(), out[i].end());
    }
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace property
