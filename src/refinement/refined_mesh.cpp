// SPDX-License-Identifier: MIT
#include "refinement/refined_mesh.hpp"

#include <algorithm>
#include <limits>

namespace mgdt {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

void RefinedMesh::resize() {
    const std::size_t vertices = walled.mesh.vertices.size();
    sizes.resize(vertices, infinite);
    if (!interpolated.empty()) interpolated.resize(vertices, infinite);
    if (!spacings.empty()) spacings.resize(vertices, infinite);
    verdicts.resize(walled.mesh.tetrahedra.size());
}

void RefinedMesh::reserve(std::size_t slots, std::size_t vertices) {
    constexpr std::size_t least_slots = 1024, least_vertices = 128;
    Mesh& mesh = walled.mesh;
    if (mesh.free_slots.size() < slots) {
        const auto first = static_cast<TetId>(mesh.tetrahedra.size());
        const std::size_t count = std::max({slots, least_slots, mesh.tetrahedra.size() / 8});
        walled.add_slots(count);
        mesh.free_slots.grow(mesh.tetrahedra.size());
        // The lowest ones are taken first.
        for (std::size_t i = count; i-- > 0;) {
            const auto slot = first + static_cast<TetId>(i);
            mesh.tetrahedra[slot].kill();
            mesh.free_slots.push_back(slot);
        }
    }
    if (free_vertices.size() < vertices) {
        const auto first = static_cast<VertexId>(mesh.vertices.size());
        const std::size_t count = std::max({vertices, least_vertices, mesh.vertices.size() / 8});
        walled.add_vertices(count);
        free_vertices.grow(free_vertices.size() + count);
        for (std::size_t i = count; i-- > 0;)
            free_vertices.push_back(first + static_cast<VertexId>(i));
    }
    mesh.free_slots.grow(mesh.free_slots.size() + slots);
    resize();
}

void RefinedMesh::find_spacings() {
    const Mesh& mesh = walled.mesh;
    spacings.clear();
    spacings.resize(mesh.vertices.size(), infinite);
    for (TetId t = 0; t < mesh.tetrahedra.size(); ++t) {
        const Tetrahedron& tet = mesh.tetrahedra[t];
        if (tet.is_dead() || tet.is_ghost()) continue;
        for (unsigned i = 0; i < 4; ++i)
            for (unsigned j = 0; j < i; ++j) {
                const Vector<double> d =
                    difference<double>(walled.point(tet.v[i]), walled.point(tet.v[j]));
                const double length = std::sqrt(dot(d, d));
                spacings[tet.v[i]] = std::min(spacings[tet.v[i]], length);
                spacings[tet.v[j]] = std::min(spacings[tet.v[j]], length);
            }
    }
}

}  // namespace mgdt
