// SPDX-License-Identifier: MIT
// Points that are near each other become one.
#pragma once

#include "cleaning/nearness.hpp"
#include "platform/stop_request.hpp"

namespace mgdt {

// Moves points to others that are near them. In the order of their coordinates, each point moves to
// the nearest of the points that have stayed, of equally near ones the first, or stays if none is
// near. So no point moves farther than the distance, and points that differ afterwards are farther
// apart. Returns how many have moved.
std::size_t weld_points(Buffer<double>& points, const Nearness& near, Allocator& allocator,
                        const StopRequest& stop);

}  // namespace mgdt
