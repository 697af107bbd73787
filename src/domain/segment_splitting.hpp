// SPDX-License-Identifier: MIT
// Divides the segments of a boundary until all parts are edges of the Delaunay triangulation.
#pragma once

#include "core/triangulation.hpp"
#include "platform/no_index.hpp"
#include "platform/stage_progress.hpp"
#include "solid/divided_segment.hpp"

namespace mgdt {

// A part of a segment, from point k0 to point k1 of its DividedSegment.
struct Subsegment {
    std::uint32_t ends[2];  // points; ends[0] is the one at k0
    std::uint32_t segment;
    std::uint32_t k0, k1;
};

// A point that was added to a mesh: point k of the DividedSegment of its segment. If the segment is
// no_index, the point is on none.
struct SteinerPoint {
    std::uint32_t segment, k;
};

// The parts of all segments, sorted by their segment and then from its first end to the second.
struct DividedSegments {
    explicit DividedSegments(Allocator& allocator) : parts(allocator), steiner(allocator) {}

    Buffer<Subsegment> parts;
    Buffer<SteinerPoint> steiner;
    // A segment that has no point left at which it can be divided, or a missing one when the
    // allowed work is used up; no_index if there is none. If there is one, `parts` is not complete.
    std::uint32_t stuck = no_index;
    bool takes_long = false;  // whether the latter was the reason
};

// `points` are integers, three for each point (solid/rounding_grid.hpp), and `triangulation` has
// these points and no others. The function puts points on the segments, in the triangulation and at
// the end of `points`. No two segments meet except in common ends, and no point is inside of one.
//
// The rules are those of Si and Gaertner (Meshing piecewise linear complexes by constrained
// Delaunay tetrahedralizations, 2005), with sets of segments that do not touch in each round,
// except at points where 16 or more have to be divided. The result depends on the points and on the
// segments alone. Their rule that avoids short parts is optional: without it there are fewer
// points, but on few segments the parts become shorter and shorter. On some grids that takes very
// long, so the function gives up when its work exceeds `most_work`. The work of a round is the
// number of tetrahedra at its new points, and 64; it is the same for any number of threads. It also
// gives up when more than `most_points` points are necessary.
DividedSegments split_segments(Triangulation& triangulation, Buffer<double>& points,
                               const Buffer<std::uint32_t>& segments, StageProgress& progress,
                               bool avoids_short_parts, std::size_t most_points,
                               std::uint64_t most_work, const StopRequest& stop);

}  // namespace mgdt
