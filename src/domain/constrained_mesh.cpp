// SPDX-License-Identifier: MIT
#include "domain/constrained_mesh.hpp"

#include <algorithm>

#include "predicates/predicates.hpp"

namespace mgdt {

ConstrainedMesh::ConstrainedMesh(const Triangulation& triangulation, const Buffer<double>& xyz,
                                 Allocator& allocator)
    : LinkedTetrahedra(allocator), points(xyz) {
    const Mesh& mesh = triangulation.mesh();
    const std::size_t slots = mesh.tetrahedra.size();
    Buffer<std::uint32_t> number(allocator, slots);
    std::uint32_t count = 0;
    for (TetId t = 0; t < slots; ++t) {
        const mgdt::Tetrahedron& from = mesh.tetrahedra[t];
        number[t] = from.is_dead() || from.is_ghost() ? no_tetrahedron : count++;
    }
    tetrahedra.resize(count);
    hints.resize(points.size() / 3, no_tetrahedron);
    for (TetId t = 0; t < slots; ++t) {
        if (number[t] == no_tetrahedron) continue;
        const mgdt::Tetrahedron& from = mesh.tetrahedra[t];
        Tetrahedron& to = tetrahedra[number[t]];
        for (unsigned i = 0; i < 4; ++i) {
            to.v[i] = mesh.vertices[from.v[i]].index;
            const std::uint32_t next = number[tetrahedron_of(from.n[i])];
            to.n[i] = next == no_tetrahedron ? no_index : 4 * next + face_of(from.n[i]);
            to.facets[i] = no_index;
            hints[to.v[i]] = number[t];
        }
    }
}

bool ConstrainedMesh::is_delaunay(const Buffer<std::uint32_t>& regions,
                                  std::uint32_t outside) const {
    for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
        const Tetrahedron& tet = tetrahedra[t];
        if (tet.is_dead() || regions[t] == outside) continue;
        for (unsigned k = 0; k < 4; ++k) {
            // Each face is seen from the lesser one of its two tetrahedra.
            if (tet.facets[k] != no_index || tet.n[k] == no_index || tet.n[k] / 4 < t) continue;
            if (side_of_sphere_perturbed(point(tet.v[0]), point(tet.v[1]), point(tet.v[2]),
                                         point(tet.v[3]), point(apex(tet.n[k]))) > 0)
                return false;
        }
    }
    return true;
}

}  // namespace mgdt
