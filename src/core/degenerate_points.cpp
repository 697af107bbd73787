// SPDX-License-Identifier: MIT
#include "core/degenerate_points.hpp"

#include "platform/hash.hpp"

namespace mgdt {

std::uint32_t DegeneratePoints::number(const Mesh& mesh, const double* p) noexcept {
    return table_.number(hash_of_coordinates(p), [&](std::uint32_t i) {
        const double* const there = mesh.point(i + 1);
        return there[0] == p[0] && there[1] == p[1] && there[2] == p[2];
    });
}

void DegeneratePoints::reserve(Mesh& mesh, std::size_t count) {
    const std::size_t most = mesh.vertices.size() + count;
    mesh.vertices.grow(most);
    table_.reserve(most);
    // The hash table is empty after clear() and after a change of scale.
    for (VertexId v = table_.size() + 1; v < mesh.vertices.size(); ++v) number(mesh, mesh.point(v));
}

VertexId DegeneratePoints::add(Mesh& mesh, const double* p, std::uint32_t index) noexcept {
    const VertexId v = number(mesh, p) + 1;
    if (v == mesh.vertices.size()) mesh.vertices.push_back(Vertex{{p[0], p[1], p[2]}, index, 0});
    return v;
}

}  // namespace mgdt
