// SPDX-License-Identifier: MIT
// Separation control, S.H. Lo (2014), section 4.2: points that follow each other shall not all be
// neighbours, or long tetrahedra are built, removed and built again next to each of them.
#pragma once

#include "order/schedule.hpp"

namespace mgdt {

// Separates the points of a path through the cells of a grid, which is in out.order: takes one
// point of each cell at a time. rank[k] is the number of points of the same cell before position k.
// The alternative, rounds along the path, is in order/round_assignment.hpp.
void take_in_passes(const PointSet& points, const OrderParameters& parameters,
                    const Buffer<std::uint32_t>& rank, Schedule& out);

}  // namespace mgdt
