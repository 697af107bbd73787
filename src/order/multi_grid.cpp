// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstring>
#include <utility>

#include "order/grid.hpp"
#include "order/rounds.hpp"
#include "order/schemes.hpp"

namespace mgdt {
namespace {

// S.H. Lo (2014), section 4.2: a cell with more points than the threshold gets a regular grid of
// its own over the box of its points, and so on. Each grid's path begins at the corner next to
// where the path came from. Linear: points are moved once a level, and levels are few.
class MultiGrid {
  public:
    MultiGrid(const PointSet& points, const OrderParameters& parameters, Schedule& out)
        : points_(points),
          per_cell_(parameters.points_per_cell > 0 ? parameters.points_per_cell : 8),
          threshold_(parameters.threshold),
          out_(out),
          rank_(out.order.allocator(), points.size),
          moved_(out.order.allocator(), points.size),
          next_(out.order.allocator()),
          pending_(out.order.allocator()) {}

    // Puts out.order in the order of the path through the cells that were not divided further,
    // and sets the rank of each position: how many points of the same cell come before it.
    const Buffer<std::uint32_t>& sort() {
        const std::size_t n = points_.size;
        for (std::size_t i = 0; i < n; ++i) out_.order[i] = static_cast<std::uint32_t>(i);
        if (n > 0) pending_.push_back({0, static_cast<std::uint32_t>(n), 0});
        // From left to right, so that the path before a grid is known when its turn comes.
        while (!pending_.empty()) {
            const Cell cell = pending_.back();
            pending_.pop_back();
            divide(cell);
        }
        moved_.reset();
        next_.reset();
        return rank_;
    }

  private:
    struct Cell {
        std::uint32_t begin, end, depth;  // positions in out.order
    };

    // Points that crowd exponentially could ask for 2000 grids, one inside the other, each with
    // all the points but a few. The paper seldom saw more than four.
    static constexpr std::uint32_t most_levels = 64;

    void divide(const Cell& cell) {
        std::uint32_t* order = out_.order.data();
        const std::uint32_t begin = cell.begin, end = cell.end;
        const auto index = [&](std::size_t j) { return order[begin + j]; };
        const Box box = cell.depth == 0 ? box_of(points_) : box_of(points_, end - begin, index);
        double from[3];
        if (begin > 0) {
            for (int k = 0; k < 3; ++k) from[k] = points_.coordinate(order[begin - 1], k);
        }
        const Grid grid(points_, box, end - begin, per_cell_, begin > 0 ? from : nullptr);
        // A grid with two cells or more separates points: they lie on both ends of its longest
        // side. With one cell there are too few points, or one point repeated.
        if (grid.cells() == 1) {
            if (cell.depth == 0) out_.levels = 1;
            finish(begin, end);
            return;
        }
        if (cell.depth + 1 > out_.levels) out_.levels = cell.depth + 1;

        std::uint32_t* path = rank_.data();
        next_.clear();
        next_.resize(grid.cells() + 1, 0);
        for (std::uint32_t k = begin; k < end; ++k) {
            path[k] = grid.path(points_, order[k]);
            ++next_[path[k] + std::size_t{1}];
        }
        for (std::size_t c = 1; c < next_.size(); ++c) next_[c] += next_[c - 1];
        for (std::uint32_t k = begin; k < end; ++k) moved_[begin + next_[path[k]]++] = order[k];
        std::memcpy(order + begin, moved_.data() + begin, (end - begin) * sizeof(std::uint32_t));

        // Each counter has moved on to the end of its cell.
        std::uint32_t last = end;
        for (std::size_t c = grid.cells(); c-- > 0;) {
            const std::uint32_t first = c > 0 ? begin + next_[c - 1] : begin;
            if (last - first > threshold_ && cell.depth + 1 < most_levels) {
                pending_.push_back({first, last, cell.depth + 1});
            } else {
                finish(first, last);
            }
            last = first;
        }
    }

    void finish(std::uint32_t begin, std::uint32_t end) noexcept {
        for (std::uint32_t k = begin; k < end; ++k) rank_[k] = k - begin;
    }

    const PointSet& points_;
    double per_cell_, threshold_;
    Schedule& out_;
    Buffer<std::uint32_t> rank_;  // where a cell is still to be divided, room for its path
    Buffer<std::uint32_t> moved_;
    Buffer<std::uint32_t> next_;
    Buffer<Cell> pending_;
};

// Separation control: "taking one point from a cell at a time". Pass r takes the point of rank r
// of every cell that has one, along the whole path through all levels of grids. The first pass
// alone is still a sorted sweep, which builds long tetrahedra between its front and what is there
// and removes them again, so it is dealt into random rounds, the same path with cells left out.
// From the second pass on a point's hint is the nearest of the last points of its own cell.
class Separation {
  public:
    Separation(const PointSet& points, const OrderParameters& parameters, Schedule& out,
               const Buffer<std::uint32_t>& rank)
        : points_(points),
          out_(out),
          rank_(rank),
          rounds_(count_cells(rank), parameters.round_ratio, parameters.seed) {}

    void apply() {
        const std::size_t n = points_.size;
        Allocator& allocator = out_.order.allocator();
        Buffer<std::uint32_t> next(allocator), order(allocator, n);
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

    // The first position of each pass; those that have points are the schedule's rounds.
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

    // Called for the positions of the path in turn: remembers the last points of the cell.
    std::uint32_t hint(std::size_t k, std::uint32_t position) noexcept {
        const std::uint32_t rank = rank_[k];
        Earlier self;
        for (int a = 0; a < 3; ++a) self.x[a] = points_.coordinate(out_.order[k], a);
        self.position = position;
        std::uint32_t best = no_hint;
        double least = 0;
        for (std::uint32_t c = 0; c < candidates && c < rank; ++c) {
            // Sums of absolute differences: squares may leave the range of doubles.
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

void order_multi_grid(Team&, const PointSet& points, const OrderParameters& parameters,
                      Schedule& out) {
    MultiGrid grids(points, parameters, out);
    const Buffer<std::uint32_t>& rank = grids.sort();
    if (parameters.separation) Separation(points, parameters, out, rank).apply();
}

}  // namespace mgdt
