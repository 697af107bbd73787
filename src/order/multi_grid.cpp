// SPDX-License-Identifier: MIT
// The order scheme of regular grids within the cells of grids.
#include <cstring>

#include "order/curve_sort.hpp"
#include "order/grid.hpp"
#include "order/round_assignment.hpp"
#include "order/schemes.hpp"
#include "order/separation.hpp"

namespace mgdt {
namespace {

// S.H. Lo (2014), section 4.2: a cell with more points than the threshold gets a regular grid of
// its own over the box of its points, and so on. The path of each grid begins at the corner nearest
// to the previous point of the whole path. The time is linear: points are moved once per level, and
// there are few levels.
class MultiGrid {
  public:
    MultiGrid(const PointSet& points, const OrderParameters& parameters, Schedule& out)
        : points_(points),
          per_cell_(parameters.points_per_cell_or(8)),
          threshold_(parameters.threshold_or(200)),
          out_(out),
          rank_(out.scratch, points.size),
          moved_(out.scratch, points.size),
          ends_(out.scratch),
          pending_(out.scratch) {}

    // Sorts out.order along the path through the cells that are not divided further, and sets the
    // rank of each position: the number of points of the same cell before it.
    const Buffer<std::uint32_t>& sort() {
        const std::size_t n = points_.size;
        for (std::size_t i = 0; i < n; ++i) out_.order[i] = static_cast<std::uint32_t>(i);
        if (n > 0) pending_.push_back({0, static_cast<std::uint32_t>(n), 0});
        // Cells are divided in the order of the path, so that the path up to a grid is known when
        // the grid is made.
        while (!pending_.empty()) {
            const Cell cell = pending_.back();
            pending_.pop_back();
            divide(cell);
        }
        moved_.reset();
        ends_.reset();
        return rank_;
    }

  private:
    struct Cell {
        std::uint32_t begin, end, depth;  // begin and end are positions in out.order
    };

    // The largest number of nested grids. Without this limit, exponentially clustered points could
    // have 2000 nested grids, each with nearly all of the points. S.H. Lo (2014) seldom saw more
    // than four.
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
        // A grid of two or more cells separates points, since there are points at both ends of its
        // longest side. A grid of one cell has too few points, or copies of one point.
        if (grid.cells() == 1) {
            if (cell.depth == 0) out_.levels = 1;
            finish(begin, end);
            return;
        }
        if (cell.depth + 1 > out_.levels) out_.levels = cell.depth + 1;

        sort_along_path(grid, points_, end - begin, index, rank_.data() + begin, ends_,
                        moved_.data() + begin);
        std::memcpy(order + begin, moved_.data() + begin, (end - begin) * sizeof(std::uint32_t));

        std::uint32_t last = end;
        for (std::size_t c = grid.cells(); c-- > 0;) {
            const std::uint32_t first = c > 0 ? begin + ends_[c - 1] : begin;
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
    Buffer<std::uint32_t>
        rank_;  // the rank of each position; in cells that are still to be divided, working memory
    Buffer<std::uint32_t> moved_;
    Buffer<std::uint32_t> ends_;
    Buffer<Cell> pending_;
};

// An alternative to the multi-grid of S.H. Lo (2014) for the same purpose: grids of cubes, as fine
// as keys allow, with another grid in each crowded cell; a Hilbert curve through all grids, which
// enters and leaves a nested grid where it enters and leaves the cell; and separation by rounds
// (order/round_assignment.hpp), in which isolated points come first.
void order_in_rounds(Team& team, const PointSet& points, const OrderParameters& parameters,
                     Schedule& out) {
    constexpr double crowd = 8;
    const CurveOrder curve = sort_along_curve(
        team, points, out.scratch, static_cast<std::size_t>(parameters.threshold_or(crowd)));
    out.levels = curve.levels;
    assign_rounds(
        team, parameters.seed, [&](std::size_t k) { return curve.index(k); }, out, &curve);
}

}  // namespace

void order_multi_grid(Team& team, const PointSet& points, const OrderParameters& parameters,
                      Schedule& out) {
    if (parameters.separation == Separation::rounds) {
        order_in_rounds(team, points, parameters, out);
        return;
    }
    MultiGrid grids(points, parameters, out);
    const Buffer<std::uint32_t>& rank = grids.sort();
    if (parameters.separation == Separation::passes) take_in_passes(points, parameters, rank, out);
}

}  // namespace mgdt
