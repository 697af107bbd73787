// SPDX-License-Identifier: MIT
// A copy of a Delaunay triangulation into which facets are inserted.
#pragma once

#include "core/triangulation.hpp"
#include "solid/linked_tetrahedra.hpp"

namespace mgdt {

struct ConstrainedMesh : LinkedTetrahedra {
    // Copies the tetrahedra of a triangulation. Its points are those of `points`, which stays.
    ConstrainedMesh(const Triangulation& triangulation, const Buffer<double>& points,
                    Allocator& allocator);

    // A mesh without tetrahedra.
    ConstrainedMesh(const Buffer<double>& points, Allocator& allocator)
        : LinkedTetrahedra(allocator), points(points) {}

    const double* point(std::uint32_t v) const noexcept {
        return points.begin() + 3 * std::size_t{v};
    }

    // Whether all faces that are parts of no facet are locally Delaunay, among tetrahedra for which
    // `regions` does not have `outside`. Then the tetrahedra are constrained Delaunay (Shewchuk,
    // Constrained Delaunay tetrahedralizations, 2002).
    bool is_delaunay(const Buffer<std::uint32_t>& regions, std::uint32_t outside) const;

    const Buffer<double>& points;
};

}  // namespace mgdt
