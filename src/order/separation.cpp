// SPDX-License-Identifier: MIT
#include "order/separation.hpp"

#include <cmath>
#include <utility>

#include "order/rounds.hpp"

namespace mgdt {
namespace {

// Separation control: "taking one point from a cell at a time". Pass r takes the point of rank r of
// every cell that has one, along the whole path through all levels of grids. The first pass alone
// would be a sorted sweep, which builds long tetrahedra between its front and earlier points and
// removes them again. So the points of the first pass are divided into random rounds; each follows
// the same path with cells left out. From the second pass on, the hint of a point is the nearest of
// the last points of its own cell.
class Passes {
  public:
    Passes(const PointSet& points, const OrderParameters& parameters, Schedule& out,
           const Buffer<std::uint32_t>& rank)
        : points_(points),
          out_(out),
          rank_(rank),
          rounds_(count_cells(rank), parameters.round_ratio, parameters.seed) {}

    void apply() {
        const std::size_t n = points_.size;
        Buffer<std::uint32_t> next(out_.scratch), order(out_.order.allocator(), n);
        count_passes(next);
        out_.hints.resize(n);
        for (std::size_t k = 0; k < n; ++k) {
            const std::uint32_t position = next[pass(k)]++;
            order[position] = out_.order[k];
            out_.hints[position] = hint(k, position);
        }
        out_.order = std::move(order);
    }

  private:
    static constexpr std::uint32_t candidates = 8;

    struct Earlier {
        double x[3];
        std::uint32_t position;
    };

    static std::size_t count_cells(const Buffer<std::uint32_t>& rank) noexcept {
        std::size_t cells = 0;
        for (const std::uint32_t r : rank) cells += r == 0;
        return cells;
    }

    std::size_t pass(std::size_t k) const noexcept {
        if (rank_[k] == 0) return rounds_.of(out_.order[k]);
        return std::size_t{rounds_.count()} - 1 + rank_[k];
    }

    // Computes the first position of each pass. The passes that have points are the rounds of the
    // schedule.
    void count_passes(Buffer<std::uint32_t>& first) {
        std::uint32_t most = 0;
        for (const std::uint32_t r : rank_) {
            if (r > most) most = r;
        }
        first.resize(std::size_t{rounds_.count()} + most, 0);
        for (std::size_t k = 0; k < rank_.size(); ++k) ++first[pass(k)];
        std::uint32_t sum = 0;
        for (std::uint32_t& f : first) {
            const std::uint32_t size = f;
            if (size > 0) out_.rounds.push_back(sum);
            f = sum;
            sum += size;
        }
    }

    // The hint of the k-th point of the path. The function is called for each k in turn and
    // remembers the last points of the cell.
    std::uint32_t hint(std::size_t k, std::uint32_t position) noexcept {
        const std::uint32_t rank = rank_[k];
        Earlier self;
        for (int a = 0; a < 3; ++a) self.x[a] = points_.coordinate(out_.order[k], a);
        self.position = position;
        std::uint32_t best = no_hint;
        double least = 0;
        for (std::uint32_t c = 0; c < candidates && c < rank; ++c) {
            // The distance is the sum of absolute differences, since squares may overflow.
            double d = 0;
            for (int a = 0; a < 3; ++a) d += std::fabs(self.x[a] - earlier_[c].x[a]);
            if (best == no_hint || d < least) {
                best = earlier_[c].position;
                least = d;
            }
        }
        earlier_[rank % candidates] = self;
        return best;
    }

    const PointSet& points_;
    Schedule& out_;
    const Buffer<std::uint32_t>& rank_;
    RandomRounds rounds_;
    Earlier earlier_[candidates];
};

}  // namespace

void take_in_passes(const PointSet& points, const OrderParameters& parameters,
                    const Buffer<std::uint32_t>& rank, Schedule& out) {
    Passes(points, parameters, out, rank).apply();
}

}  // namespace mgdt
