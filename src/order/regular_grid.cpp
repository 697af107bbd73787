// SPDX-License-Identifier: MIT
// The order scheme along a path through a regular grid.
#include "order/grid.hpp"
#include "order/round_assignment.hpp"
#include "order/schemes.hpp"
#include "order/separation.hpp"
#include "parallel/team_lists.hpp"

namespace mgdt {

// A counting sort by cell; points of one cell keep their order.
void order_regular_grid(Team& team, const PointSet& points, const OrderParameters& parameters,
                        Schedule& out) {
    const std::size_t n = points.size;
    if (n == 0) return;
    const Grid grid(points, box_of(points), n, parameters.points_per_cell_or(8));
    Allocator& allocator = out.scratch;
    Buffer<std::uint32_t> cell(allocator, n), ends(allocator, grid.cells() + 1);
    constexpr std::size_t min_items_per_thread = 65536;
    team.split(n, min_items_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t i = begin; i < end; ++i) cell[i] = grid.path(points, i);
    });
    make_lists(
        team, allocator, n, min_items_per_thread, grid.cells(), ends.data(),
        [&](std::size_t begin, std::size_t end, auto f) {
            for (std::size_t i = begin; i < end; ++i) f(cell[i], static_cast<std::uint32_t>(i));
        },
        [](std::size_t) {},
        [&](std::size_t position, std::uint32_t point) { out.order[position] = point; });
    out.levels = 1;
    if (parameters.separation == Separation::rounds) assign_rounds(team, parameters.seed, out);
    if (parameters.separation != Separation::passes) return;
    Buffer<std::uint32_t>& rank = cell;
    team.split(grid.cells(), min_items_per_thread,
               [&](std::size_t first, std::size_t last, unsigned) {
                   for (std::size_t c = first; c < last; ++c)
                       for (std::uint32_t k = ends[c]; k < ends[c + 1]; ++k) rank[k] = k - ends[c];
               });
    take_in_passes(points, parameters, rank, out);
}

}  // namespace mgdt
