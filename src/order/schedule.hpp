// SPDX-License-Identifier: MIT
// A schedule says in which order the points of one insertion go in. Order schemes turn points
// into schedules and know nothing of tetrahedra.
#pragma once

#include <cstddef>
#include <cstdint>

#include "parallel/team.hpp"
#include "platform/compiler.hpp"
#include "platform/memory.hpp"

namespace mgdt {

inline constexpr std::uint32_t no_hint = 0xFFFFFFFFu;

// The caller's points, where they lie. Coordinates are finite; `scale` is a power of two that
// multiplies them exactly (see mesh/scale.hpp), so that their extent does not overflow except
// on sets that mix 1e300 with 1e-300: schemes must survive infinite extents too.
struct PointSet {
    const double* axis[3];  // first point's x, y, z
    std::ptrdiff_t stride;  // in doubles
    std::size_t size;
    double scale;
    double low[3], high[3];  // bounding box, scaled

    double coordinate(std::size_t i, int k) const noexcept {
        return axis[k][static_cast<std::ptrdiff_t>(i) * stride] * scale;
    }
    // Asks for the lines of a point.
    void prefetch(std::size_t i) const noexcept {
        for (const double* a : axis) mgdt::prefetch(a + static_cast<std::ptrdiff_t>(i) * stride);
    }
};

// How the points of a path through cells are kept apart: see mgdt.h, MGDT_PARAMETER_SEPARATION.
enum class Separation { none, passes, rounds };

// Every field has its default where 0 is said in mgdt.h to give it.
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

    Buffer<std::uint32_t> order;   // order[k]: the point that goes in k-th; a permutation
    Buffer<std::uint32_t> rounds;  // position where each round begins, ascending; rounds[0] is 0
    // Empty, or for each position an earlier position whose vertex is near and the walk may
    // start from; no_hint starts from the last insertion.
    Buffer<std::uint32_t> hints;
    Allocator& scratch;   // for what is needed only until the schedule is made
    unsigned levels = 0;  // deepest level of the grids or trees built
};

// Fills a schedule with one of the MGDT_ORDER_ schemes. At most 2^32 - 2 points. Deterministic:
// a function of the points, the parameters and nothing else.
void make_schedule(Team& team, const PointSet& points, std::int32_t scheme,
                   const OrderParameters& parameters, Schedule& out);

}  // namespace mgdt
