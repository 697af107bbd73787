// SPDX-License-Identifier: MIT
#include "order/curve_sort.hpp"

#include <algorithm>

#include "order/hilbert_curve.hpp"
#include "order/lattice.hpp"
#include "order/team_radix.hpp"
#include "order/team_runs.hpp"

namespace mgdt {
namespace {

// A word is a key on top of an index: what is left of 64 bits when the index has its share takes 9
// to 15 levels of the curve, of which up to 16,384 points get fewer than there is room for. Where
// points crowd in one of the finest cells, the curve goes on inside it over the least cube that
// holds them, so its resolution follows the points down to the last bit of their coordinates.
class CurveSorter {
  public:
    CurveSorter(const PointSet& points, std::size_t crowd, CurveOrder& order,
                Buffer<std::uint64_t>& scratch) noexcept
        : points_(points),
          crowd_(crowd),
          order_(order),
          allocator_(order.words.allocator()),
          words_(order.words.data()),
          scratch_(scratch.data()) {
        const unsigned room = (64 - order.index_bits) / (3 * HilbertCurve::levels_per_step);
        // Along an edge a cell for every four points at least, so that few of a line share one.
        const unsigned wanted =
            std::max(least_steps, order.index_bits / HilbertCurve::levels_per_step);
        steps_ = std::min({room, wanted, most_steps});
    }

    // Each call divides the extent by 2^9 at least, so calls nest at most (1024 + 1074) / 9 deep.
    void sort(Team& team, std::size_t begin, std::size_t end, const Box& box, unsigned state,
              unsigned depth) {
        unsigned deepest = levels_;
        while (depth > deepest && !levels_.compare_exchange_weak(deepest, depth)) {
        }
        const unsigned levels = HilbertCurve::levels_per_step * steps_;
        const Lattice lattice = Lattice::cubes(points_, box, 1u << levels);
        std::uint64_t* const words = words_ + begin;
        team.split(end - begin, share, [&](std::size_t first, std::size_t last, unsigned) {
            for (std::size_t k = first; k < last; ++k) {
                unsigned to = state;
                const std::uint64_t index = words[k] & order_.index_mask();
                words[k] = key(lattice, index, to) << order_.index_bits | index;
            }
        });
        radix_sort(team, allocator_, words, scratch_ + begin, end - begin, order_.index_bits,
                   order_.index_bits + 3 * levels);
        for_each_run(
            team, allocator_, end - begin, crowd_ + 1,
            [&](std::size_t i, std::size_t j) {
                return words[i] >> order_.index_bits == words[j] >> order_.index_bits;
            },
            [&](Team& t, std::size_t first, std::size_t last) {
                refine(t, begin + first, begin + last, lattice, state, depth);
            });
    }

    unsigned levels() const noexcept { return levels_; }

  private:
    static constexpr unsigned least_steps = 3, most_steps = 5;
    static constexpr std::size_t share = 32768;

    std::uint64_t key(const Lattice& lattice, std::uint64_t index, unsigned& state) const noexcept {
        const auto i = static_cast<std::size_t>(index);
        return hilbert_curve.key(lattice.step(points_, i, 0), lattice.step(points_, i, 1),
                                 lattice.step(points_, i, 2), steps_, state);
    }

    void refine(Team& team, std::size_t begin, std::size_t end, const Lattice& lattice,
                unsigned state, unsigned depth) {
        const Box box =
            box_of(points_, end - begin, [&](std::size_t j) { return order_.index(begin + j); });
        if (!(box.longest() > 0)) return;  // one point repeated
        key(lattice, order_.index(begin), state);
        sort(team, begin, end, box, state, depth + 1);
    }

    const PointSet& points_;
    const std::size_t crowd_;
    const CurveOrder& order_;
    Allocator& allocator_;
    std::uint64_t* words_;
    std::uint64_t* scratch_;
    unsigned steps_;
    Atomic<unsigned> levels_{0};
};

}  // namespace

CurveOrder sort_along_curve(Team& team, const PointSet& points, Allocator& allocator,
                            std::size_t crowd) {
    const std::size_t n = points.size;
    CurveOrder order{Buffer<std::uint64_t>(allocator), 0, 0};
    if (n == 0) return order;
    Buffer<std::uint64_t> scratch(allocator);
    order.words.resize(n);
    scratch.resize(n);
    order.index_bits = bit_width(n - 1);
    team.split(n, 65536, [&](std::size_t begin, std::size_t end, unsigned) {
        order.words.prefault(begin, end);
        scratch.prefault(begin, end);
        for (std::size_t k = begin; k < end; ++k) order.words[k] = k;
    });
    CurveSorter sorter(points, crowd, order, scratch);
    sorter.sort(team, 0, n, box_of(points), HilbertCurve::first_state, 1);
    order.levels = sorter.levels();
    return order;
}

}  // namespace mgdt
