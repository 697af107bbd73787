// SPDX-License-Identifier: MIT
// The order scheme of a kd-tree with a regular grid in each cell.
#include <algorithm>

#include "order/grid.hpp"
#include "order/kd_partition.hpp"
#include "order/schemes.hpp"

namespace mgdt {
namespace {

constexpr double grid_points_per_cell = 8;

// Sorts the points of each kd cell along the path of a regular grid. The path begins at the corner
// nearest to the previous pivot.
class CellOrder {
  public:
    CellOrder(const PointSet& points, const Buffer<KdPoint>& sorted, Schedule& out)
        : points_(points), sorted_(sorted), out_(out), path_(out.scratch), ends_(out.scratch) {}

    void operator()(std::size_t begin, std::size_t end) {
        const std::size_t n = end - begin;
        if (begin > 0) out_.order[begin - 1] = sorted_[begin - 1].index;  // the previous pivot
        if (n == 0) return;
        const auto index = [&](std::size_t j) { return sorted_[begin + j].index; };
        Box box;
        for (int k = 0; k < 3; ++k) box.low[k] = box.high[k] = sorted_[begin].x[k];
        for (std::size_t j = 1; j < n; ++j) box.add(sorted_[begin + j].x);
        const Grid grid(points_, box, n, grid_points_per_cell,
                        begin > 0 ? sorted_[begin - 1].x : nullptr);
        path_.resize(n);
        std::uint32_t* order = out_.order.data() + begin;
        sort_along_path(grid, points_, n, index, path_.data(), ends_, order);
        // Within a grid cell, points keep the order of the input.
        std::uint32_t from = 0;
        for (std::size_t c = 0; c < grid.cells(); ++c) {
            std::sort(order + from, order + ends_[c]);
            from = ends_[c];
        }
    }

  private:
    const PointSet& points_;
    const Buffer<KdPoint>& sorted_;
    Schedule& out_;
    Buffer<std::uint32_t> path_, ends_;
};

}  // namespace

// S.H. Lo (2014), section 3.4: more than 1000 points per cell, and a regular grid inside each.
void order_enhanced_kd_tree(Team& team, const PointSet& points, const OrderParameters& parameters,
                            Schedule& out) {
    const double per_cell = parameters.points_per_cell_or(1000);
    Buffer<KdPoint> sorted = kd_points(team, points, out.scratch);
    const unsigned levels = kd_levels(points.size, per_cell, true);
    kd_partition(team, sorted, box_of(points), levels,
                 [&] { return CellOrder(points, sorted, out); });
    out.levels = levels + 1;
}

}  // namespace mgdt
