// SPDX-License-Identifier: MIT
// The order scheme BRIO: random rounds of growing size.
#include "order/curve_sort.hpp"
#include "order/rounds.hpp"
#include "order/schemes.hpp"
#include "parallel/team_lists.hpp"

namespace mgdt {

// All points are sorted along a curve and then distributed to rounds in that order, so each round
// follows the curve, too.
void order_brio(Team& team, const PointSet& points, const OrderParameters& parameters,
                Schedule& out) {
    const std::size_t n = points.size;
    Allocator& allocator = out.scratch;
    const RandomRounds rounds(n, parameters.round_ratio, parameters.seed);
    const CurveOrder curve = sort_along_curve(team, points, allocator);
    Buffer<std::uint32_t> ends(allocator, rounds.count() + std::size_t{1});
    constexpr std::size_t min_items_per_thread = 65536;
    make_lists(
        team, allocator, n, min_items_per_thread, rounds.count(), ends.data(),
        [&](std::size_t begin, std::size_t end, auto f) {
            for (std::size_t k = begin; k < end; ++k) {
                const std::uint32_t point = curve.index(k);
                f(rounds.of(point), point);
            }
        },
        [](std::size_t) {},
        [&](std::size_t position, std::uint32_t point) { out.order[position] = point; });
    for (unsigned r = 0; r < rounds.count(); ++r)
        if (ends[r] < ends[r + 1]) out.rounds.push_back(ends[r]);
    out.levels = curve.levels;
}

}  // namespace mgdt
