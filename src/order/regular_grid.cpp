// SPDX-License-Identifier: MIT
#include "order/grid.hpp"
#include "order/schemes.hpp"
#include "order/separation.hpp"

namespace mgdt {

// A counting sort by cell; points of one cell keep their order.
void order_regular_grid(Team& team, const PointSet& points, const OrderParameters& parameters,
                        Schedule& out) {
    const std::size_t n = points.size;
    if (n == 0) return;
    const Grid grid(points, box_of(points), n, parameters.points_per_cell_or(8));
    Buffer<std::uint32_t> cell(out.order.allocator(), n), next(out.order.allocator());
    next.resize(grid.cells() + 1, 0);
    for (std::size_t i = 0; i < n; ++i) {
        cell[i] = grid.path(points, i);
        ++next[cell[i] + std::size_t{1}];
    }
    for (std::size_t c = 1; c < next.size(); ++c) next[c] += next[c - 1];
    for (std::size_t i = 0; i < n; ++i) out.order[next[cell[i]]++] = static_cast<std::uint32_t>(i);
    out.levels = 1;
    if (parameters.separation == Separation::none) return;
    // Each counter has moved on to the end of its cell.
    Buffer<std::uint32_t>& rank = cell;
    std::uint32_t begin = 0;
    for (std::size_t c = 0; c < grid.cells(); ++c) {
        for (std::uint32_t k = begin; k < next[c]; ++k) rank[k] = k - begin;
        begin = next[c];
    }
    separate(team, points, parameters, rank, out);
}

}  // namespace mgdt
