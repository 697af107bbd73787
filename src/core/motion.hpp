// SPDX-License-Identifier: MIT
// Moves points one by one, each by a removal and an insertion, or all at once by a rebuild.
#pragma once

#include "core/state.hpp"

namespace mgdt {

// Moves points to the places in `xyz`. Throws as Triangulation::move().
void move_points(State& state, const Buffer<std::uint32_t>& points, const double* xyz);

}  // namespace mgdt
