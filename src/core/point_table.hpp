// SPDX-License-Identifier: MIT
// The points that were given: which vertex stands for each, and what all of them have in common.
#pragma once

#include "core/affine_basis.hpp"
#include "core/degenerate_points.hpp"
#include "mesh/scale.hpp"

namespace mgdt {

struct PointTable {
    explicit PointTable(Allocator& allocator) noexcept : map(allocator), held(allocator) {}

    // -1 without points, 0 to 2 for points that do not span space, else 3.
    int dimension() const noexcept { return basis.dimension(); }
    void clear() noexcept;
    // Throws MGDT_ERR_INVALID_ARGUMENT unless each of these points, counted from 0, is in and is
    // listed once. `what` is to happen to them; `index_base` numbers them in messages.
    void require_in(const Buffer<std::uint32_t>& points, const char* what,
                    std::int32_t index_base) const;

    // By point: its vertex. infinite_vertex where the point is not in.
    Buffer<VertexId> map;
    // The vertices while all points are in a plane, on a line or at one place: they are held until
    // others span space with them.
    DegeneratePoints held;
    AffineBasis basis;
    ExponentRange exponents;
    bool exponents_are_wide = false;  // `exponents` has those of points that are gone, too
};

// Indices are 32 bits inside; the last two values mean none.
inline constexpr std::size_t max_points = 0xFFFFFFFEu;

}  // namespace mgdt
