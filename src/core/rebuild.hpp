// SPDX-License-Identifier: MIT
// Triangulates points anew, which is faster than to remove or move many of them one by one. The old
// mesh is kept until the new one is complete.
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
// changed. If the call is cancelled, the message says that `done` of the caller's `total` points
// are done.
void rebuild(State& state, const Batch& all, std::size_t done, std::size_t total);

// Runs body(), which rebuilds. Returns false if memory does not suffice for the rebuild. If points
// are held, the function throws instead, since only a rebuild can move held points.
template <class Body>
bool try_to_rebuild(const State& state, Body body) {
    const bool is_held = state.mesh.live_count() == 0;
    try {
        body();
        return true;
    } catch (const std::bad_alloc&) {
        if (is_held) throw;
    } catch (const Error& error) {
        // A rebuild may exceed the limit although its final mesh would not.
        if (is_held || error.status != MGDT_ERR_TOO_LARGE) throw;
    }
    return false;
}

}  // namespace mgdt
