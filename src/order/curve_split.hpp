// SPDX-License-Identifier: MIT
// Divides many places among the members of a team, so that each member goes from place to near
// place.
#pragma once

#include <algorithm>

#include "order/curve_sort.hpp"
#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

// Calls visit(count, index, progress, member) for shares of the places, which are contiguous. The
// k-th place of a share has the number index(k); places of a share are sorted along a curve. The
// caller counts its steps in `progress`. Places are sorted in blocks, which limits the memory.
template <class Visit>
void split_along_curve(Team& team, const PointSet& places, Allocator& allocator,
                       std::size_t places_per_thread, const StageProgress& progress,
                       const Visit& visit) {
    constexpr std::size_t most = std::size_t{1} << 20;
    for (std::size_t begin = 0; begin < places.size; begin += most) {
        PointSet block = places;
        block.size = std::min(most, places.size - begin);
        for (const double*& axis : block.axis) axis += 3 * begin;
        StageProgress of_block = progress.within_items(begin, begin + block.size, places.size);
        const CurveOrder order = sort_along_curve(team, block, allocator);
        team.split(block.size, places_per_thread,
                   [&](std::size_t first, std::size_t last, unsigned member) {
                       visit(
                           last - first,
                           [&](std::size_t k) { return begin + order.index(first + k); }, of_block,
                           member);
                   });
    }
}

}  // namespace mgdt
