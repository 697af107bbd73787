// SPDX-License-Identifier: MIT
#include "domain/constrained_mesh.hpp"

#include <algorithm>

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

}  // namespace mgdt
