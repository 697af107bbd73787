// SPDX-License-Identifier: MIT
// Checks that a triangulation is valid, by local tests in linear time: adjacency, orientation, the
// Delaunay property, ties. That these tests suffice is proved in docs/theory.md, "What the check
// proves".
#pragma once

#include "mesh/mesh.hpp"
#include "mesh/scale.hpp"
#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"
#include "query/location_tree.hpp"

namespace mgdt {

// The state of a triangulation that the check verifies.
struct CheckInput {
    const Mesh& mesh;
    const Buffer<VertexId>& point_map;
    int dimension;
    std::uint64_t points_inserted, duplicates;
    ExponentRange exponents;   // of the caller's coordinates
    bool exponents_are_wide;   // `exponents` includes coordinates of points that are gone
    TetId last;                // where the next walk starts
    const LocationTree* tree;  // nullptr if there is none
};

// Throws MGDT_ERR_CHECK_FAILED with a message that says what is wrong and where. `level` is an
// MGDT_CHECK_ value; `base` numbers points in messages. Every index in the mesh is checked before
// it is used.
void check_triangulation(Team& team, const CheckInput& input, Allocator& allocator,
                         std::int32_t level, std::int32_t base, StageProgress& progress);

}  // namespace mgdt
