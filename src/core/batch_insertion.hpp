// SPDX-License-Identifier: MIT
// Inserts one batch of points that span space together with the points before: makes a schedule,
// copies the points into the mesh, and inserts them one after another or by several threads
// (concurrent_insertion.hpp).
#pragma once

#include "core/batch.hpp"
#include "core/state.hpp"
#include "parallel/team.hpp"

namespace mgdt {

// The number of slots to reserve for a number of points. A Poisson set has 6.77 tetrahedra per
// point; ghosts and slots that are temporarily free add a little. The storage grows if a set needs
// more slots.
inline std::size_t expected_tetrahedra(std::size_t points, std::size_t limit) {
    const std::size_t expected = points * 7 - points / 8 + 128;
    return expected < limit ? expected : limit;
}

// Inserts a batch. If `fresh` is set, a mesh of this batch alone replaces the old mesh. If
// `may_stop` is set, the function reports progress and can be cancelled. Throws Error and
// std::bad_alloc; the points that were inserted before the error stay in the mesh.
void insert_batch(State& state, Team& team, const Batch& batch, bool fresh, bool may_stop);

}  // namespace mgdt
