// SPDX-License-Identifier: MIT
#include "order/curve_sort.hpp"
#include "order/rounds.hpp"
#include "order/schemes.hpp"

namespace mgdt {

// All points are sorted along one curve, then dealt into the rounds from there, so that each
// round follows the curve too.
void order_brio(Team& team, const PointSet& points, const OrderParameters& parameters,
                Schedule& out) {
    const std::size_t n = points.size;
    const RandomRounds rounds(n, parameters.round_ratio, parameters.seed);
    const unsigned count = rounds.count();
    Buffer<std::uint32_t> next(out.order.allocator());
    next.resize(count, 0);
    for (std::size_t i = 0; i < n; ++i) ++next[rounds.of(static_cast<std::uint32_t>(i))];
    std::uint32_t begin = 0;
    for (unsigned r = 0; r < count; ++r) {
        const std::uint32_t size = next[r];
        if (size > 0) out.rounds.push_back(begin);
        next[r] = begin;
        begin += size;
    }
    const CurveOrder curve = sort_along_curve(team, points, out.order.allocator());
    for (std::size_t k = 0; k < n; ++k) {
        const std::uint32_t i = curve.index(k);
        out.order[next[rounds.of(i)]++] = i;
    }
    out.levels = curve.levels;
}

}  // namespace mgdt
