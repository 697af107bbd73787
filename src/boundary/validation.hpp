// SPDX-License-Identifier: MIT
// The validation of a boundary: whether its triangles, segments and points meet in common faces
// only.
#pragma once

#include "boundary/boundary.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

// The numbers of two simplices of a boundary that meet elsewhere than in a common face. A triangle
// whose corners are on one line, and a segment without length, are paired with themselves.
struct OffendingPair {
    std::uint32_t first, second;

    friend bool operator<(const OffendingPair& a, const OffendingPair& b) {
        return a.first != b.first ? a.first < b.first : a.second < b.second;
    }
};

// All offending pairs, sorted: flat triangles; triangles with the same corners; and pairs of
// simplices, neither of them flat, that do not meet in a common face. Repeated segments, and
// segments that are edges of triangles, pass. The time is that of BoxTree plus one test for each
// pair whose boxes overlap.
Buffer<OffendingPair> offending_pairs(const Boundary& boundary, Team& team, Allocator& allocator,
                                      StageProgress& progress);

}  // namespace mgdt
