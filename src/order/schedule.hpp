// SPDX-License-Identifier: MIT
// A schedule: the order in which the points of a batch are inserted. Order schemes make schedules
// from points, and know nothing of tetrahedra.
#pragma once

#include <cstddef>
#include <cstdint>

#include "parallel/team.hpp"
#include "platform/compiler.hpp"
#include "platform/memory.hpp"

namespace mgdt {

inline constexpr std::uint32_t no_hint = 0xFFFFFFFFu;

// The caller's points, in the caller's array. Coordinates are finite. `scale` is a power of two by
// which coordinates are multiplied exactly (mesh/scale.hpp), so that their extent does not
// overflow. The extent is still infinite for sets that mix 1e300 with 1e-300, and schemes have to
// handle this.
struct PointSet {
    const double* axis[3];  // first point's x, y, z
    std::ptrdiff_t stride;  // in doubles
    std::size_t size;
    double scale;
    double low[3], high[3];  // bounding box, scaled

    double coordinate(std::size_t i, int k) const noexcept {
        return axis[k][static_cast<std::ptrdiff_t>(i) * stride] * scale;
    }
    // Prefetches a point.
    void prefetch(std::size_t i) const noexcept {
        for (const double* a : axis) mgdt::prefetch(a + static_cast<std::ptrdiff_t>(i) * stride);
    }
};

// How consecutive points of a path through cells are kept apart: see MGDT_PARAMETER_SEPARATION in
// mgdt.h.
enum class Separation { none, passes, rounds };

// The parameters of order schemes. A value of 0 stands for the default where mgdt.h says so.
struct OrderParameters {
    double points_per_cell = 0, threshold = 0;  // 0: the scheme's own defaults
    Separation separation = Separation::rounds;
    double round_ratio = 7.5;
    std::uint64_t seed = 0;

    double points_per_cell_or(double by_default) const noexcept {
        return points_per_cell > 0 ? points_per_cell : by_default;
    }
    double threshold_or(double by_default) const noexcept {
        return threshold > 0 ? threshold : by_default;
    }
};

struct Schedule {
    Schedule(Allocator& allocator, Allocator& for_scratch) noexcept
        : order(allocator), rounds(allocator), hints(allocator), scratch(for_scratch) {}

    Buffer<std::uint32_t> order;  // order[k] is the point that is inserted k-th; a permutation
    Buffer<std::uint32_t>
        rounds;  // the position where each round begins, ascending; rounds[0] is 0
    // Empty, or a hint for each position: an earlier position whose vertex is near, at which the
    // walk may start. If the hint is no_hint, the walk starts at the last insertion.
    Buffer<std::uint32_t> hints;
    Allocator& scratch;   // for temporary arrays
    unsigned levels = 0;  // the depth of the grids or trees
};

// Fills a schedule by one of the MGDT_ORDER_ schemes, for at most 2^32 - 2 points. The result
// depends on the points and the parameters alone.
void make_schedule(Team& team, const PointSet& points, std::int32_t scheme,
                   const OrderParameters& parameters, Schedule& out);

}  // namespace mgdt
