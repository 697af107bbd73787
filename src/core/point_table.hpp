// SPDX-License-Identifier: MIT
// The points that were given: which vertex stands for each, and what all of them have in common.
#pragma once

#include "core/affine_basis.hpp"
#include "core/degenerate_points.hpp"
#include "core/equal_point_lists.hpp"
#include "mesh/scale.hpp"

namespace mgdt {

struct PointTable {
    explicit PointTable(Allocator& allocator) noexcept
        : map(allocator), equals(allocator), held(allocator) {}

    // -1 without points, 0 to 2 for points that do not span space, else 3.
    int dimension() const noexcept { return basis.dimension(); }
    void clear() noexcept;
    // Throws MGDT_ERR_INVALID_ARGUMENT unless each of these points, counted from 0, has a vertex
    // and is listed once. Messages name the operation `what`, and count points from `index_base`.
    void require_in(const Buffer<std::uint32_t>& points, const char* what,
                    std::int32_t index_base) const;

    // The vertex of each point; infinite_vertex if the point is not in the triangulation.
    Buffer<VertexId> map;
    EqualPointLists equals;
    // The vertices while all points are in a plane, on a line or at one place. These vertices are
    // held until further points span space with them.
    DegeneratePoints held;
    AffineBasis basis;
    ExponentRange exponents;
    bool exponents_are_wide = false;  // `exponents` may include points that are gone
};

// The greatest number of points. Indices have 32 bits inside; the two last values mean none.
inline constexpr std::size_t max_points = 0xFFFFFFFEu;

}  // namespace mgdt
