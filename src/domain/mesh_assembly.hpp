// SPDX-License-Identifier: MIT
// Makes the mesh of a domain of the results of the stages of a build.
#pragma once

#include "boundary/complex.hpp"
#include "boundary/planar_facets.hpp"
#include "domain/regions.hpp"
#include "domain/segment_splitting.hpp"
#include "parallel/team.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

// The results of the stages of a build.
struct DomainParts {
    const DomainInput& input;
    const Complex& complex;
    const PlanarFacets& facets;
    const RoundingGrid& grid;
    const ConstrainedMesh& mesh;
    const Buffer<Subsegment>& subsegments;
    const Buffer<SteinerPoint>& steiner;
    const Regions& regions;
};

// Writes the tetrahedra inside of the domain, the faces and the edges, sorted by their corners. The
// result depends on the points, facets and segments alone. Points have the caller's coordinates if
// all tetrahedra are positive with them and `rounds` is not set; otherwise they are rounded.
void assemble(const DomainParts& parts, bool rounds, Team& team, Allocator& allocator,
              SolidMesh& out);

}  // namespace mgdt
