// SPDX-License-Identifier: MIT
// Separation control, S.H. Lo (2014), section 4.2: points that follow each other shall not all be
// neighbours, or long tetrahedra are built, removed and built again next to each of them.
#pragma once

#include "order/schedule.hpp"

namespace mgdt {

// One point of a cell at a time, along a path through the cells of a grid, which is in out.order.
// rank[k]: how many points of the same cell come before the one at place k. (To deal the path into
// rounds is the other way: order/round_assignment.hpp.)
void take_in_passes(const PointSet& points, const OrderParameters& parameters,
                    const Buffer<std::uint32_t>& rank, Schedule& out);

}  // namespace mgdt
