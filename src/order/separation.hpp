// SPDX-License-Identifier: MIT
// Separation control, S.H. Lo (2014), section 4.2: consecutive points should not all be neighbours;
// otherwise long tetrahedra are built, removed and built again next to each point.
#pragma once

#include "order/schedule.hpp"

namespace mgdt {

// Reorders out.order, which is a path through the cells of a grid, so that one point of each cell
// is taken at a time. rank[k] is the number of points of the same cell before position k. The
// alternative, rounds along the path, is in order/round_assignment.hpp.
void take_in_passes(const PointSet& points, const OrderParameters& parameters,
                    const Buffer<std::uint32_t>& rank, Schedule& out);

}  // namespace mgdt
