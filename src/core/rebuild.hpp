// SPDX-License-Identifier: MIT
// Triangulates points anew, which is faster than to remove or move many of them one by one. What
// there was is kept until that is done.
#pragma once

#include "core/batch.hpp"
#include "core/removal_budget.hpp"
#include "core/state.hpp"
#include "platform/error.hpp"

namespace mgdt {

// Whether a rebuild is faster than this number of removals or moves, whatever their links.
bool is_rebuild_faster(const State& state, std::size_t points) noexcept;
// The budget of a call that makes removals one by one.
inline RemovalBudget removal_budget(const State& state) noexcept {
    return RemovalBudget(state.mesh.live_count(), state.vertex_count());
}

// Replaces the mesh by one of all points in the batch. Throws Error and std::bad_alloc with nothing
// changed; if it is cancelled, `done` of the caller's `total` points are done.
void rebuild(State& state, const Batch& all, std::size_t done, std::size_t total);

// Runs body(), which rebuilds. Returns false if there is not enough memory for it; where points are
// held there has to be.
template <class Body>
bool try_to_rebuild(const State& state, Body body) {
    const bool is_held = state.mesh.live_count() == 0;
    try {
        body();
        return true;
    } catch (const std::bad_alloc&) {
        if (is_held) throw;
    } catch (const Error& error) {
        // There may be more tetrahedra on the way than at the end.
        if (is_held || error.status != MGDT_ERR_TOO_LARGE) throw;
    }
    return false;
}

}  // namespace mgdt
