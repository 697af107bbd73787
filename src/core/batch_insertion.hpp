// SPDX-License-Identifier: MIT
// The insertion of one batch of points that span space, with those before: schedule, copy, and one
// point after another, or several threads (concurrent_insertion.hpp).
#pragma once

#include "core/batch.hpp"
#include "core/state.hpp"
#include "parallel/team.hpp"

namespace mgdt {

// The number of slots to reserve for a number of points: a Poisson set has 6.77 tetrahedra per
// point; ghosts and slots that are free for a moment take a little. Sets that need more grow.
inline std::size_t expected_tetrahedra(std::size_t points, std::size_t limit) {
    const std::size_t expected = points * 7 - points / 8 + 128;
    return expected < limit ? expected : limit;
}

// Inserts a batch. If it is `fresh`, a mesh of its own replaces what there was. Only if it
// `may_stop` it reports progress, and ends when it is asked to. Throws Error and std::bad_alloc;
// the points before are in then.
void insert_batch(State& state, Team& team, const Batch& batch, bool fresh, bool may_stop);

}  // namespace mgdt
