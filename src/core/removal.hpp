// SPDX-License-Identifier: MIT
// Removes points. If other points remain at the vertex of a removed point, the vertex gets the
// index of one of them. Otherwise the vertex is removed, and its hole is filled
// (core/hole_filling.hpp).
#pragma once

#include "core/removal_budget.hpp"
#include "core/state.hpp"

namespace mgdt {

// Removes the points with these indices, counted from 0. Throws as Triangulation::remove().
void remove_points(State& state, const Buffer<std::uint32_t>& points);

// Whether a rebuild without the `left` points that are still to be removed is faster than filling
// the hole of the vertex whose link was found.
bool is_rebuild_better(const State& state, const RemovalBudget& budget, std::size_t left) noexcept;

}  // namespace mgdt
