// SPDX-License-Identifier: MIT
// Points are taken out. A vertex at which other points remain gets one of these for its index. With
// its last point the vertex goes, and the hole is filled (core/hole_filling.hpp).
#pragma once

#include "core/removal_budget.hpp"
#include "core/state.hpp"

namespace mgdt {

// Takes points out, given by their indices counted from 0. Throws as Triangulation::remove().
void remove_points(State& state, const Buffer<std::uint32_t>& points);

// Whether some of these points share a vertex with others, or have done so.
bool are_equals_among(const State& state, const Buffer<std::uint32_t>& points) noexcept;
// Whether the hole of the vertex whose link was found is better left as it is, since a rebuild
// without the `left` points that are to go is faster.
bool is_rebuild_better(const State& state, const RemovalBudget& budget, std::size_t left) noexcept;

}  // namespace mgdt
