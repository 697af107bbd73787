// SPDX-License-Identifier: MIT
// Whether a boundary can bound: its triangles, segments and points meet in common faces only.
#pragma once

#include "boundary/boundary.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

// Two simplices of a boundary that do not pass, by their numbers. A triangle whose corners are on
// one line, and a segment without length, are paired with themselves.
struct OffendingPair {
    std::uint32_t first, second;

    friend bool operator<(const OffendingPair& a, const OffendingPair& b) {
        return a.first != b.first ? a.first < b.first : a.second < b.second;
    }
};

// All pairs that offend, sorted: flat triangles; triangles with the same corners; and each two
// simplices, neither of them flat, that do not meet in a common face. Repeated segments and
// segments that are edges of triangles pass. The time is that of BoxTree and of a test for each
// pair whose boxes overlap.
Buffer<OffendingPair> offending_pairs(const Boundary& boundary, Team& team, Allocator& allocator,
                                      StageProgress& progress);

}  // namespace mgdt
