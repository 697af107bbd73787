// SPDX-License-Identifier: MIT
#include "core/degenerate_points.hpp"

namespace mgdt {
namespace {

std::size_t hash(const double* p) {
    std::uint64_t h = 0;
    for (int k = 0; k < 3; ++k) {
        std::uint64_t bits;
        std::memcpy(&bits, &p[k], sizeof bits);
        h = (h ^ bits) * 0x9E3779B97F4A7C15u;
        h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
}

}  // namespace

void DegeneratePoints::put(const Mesh& mesh, VertexId v) noexcept {
    const std::size_t mask = table_.size() - 1;
    std::size_t h = hash(mesh.point(v)) & mask;
    while (table_[h] != infinite_vertex) h = (h + 1) & mask;
    table_[h] = v;
}

void DegeneratePoints::reserve(Mesh& mesh, std::size_t count) {
    const std::size_t most = mesh.vertices.size() + count;
    mesh.vertices.grow(most);
    if (table_.size() >= 2 * most) return;
    std::size_t size = 64;
    while (size < 3 * most) size *= 2;
    Buffer<VertexId> table(table_.allocator());
    table.resize(size, infinite_vertex);
    table_ = std::move(table);
    for (VertexId v = 1; v < mesh.vertices.size(); ++v) put(mesh, v);
}

VertexId DegeneratePoints::add(Mesh& mesh, const double* p, std::uint32_t index) noexcept {
    const std::size_t mask = table_.size() - 1;
    for (std::size_t h = hash(p) & mask; table_[h] != infinite_vertex; h = (h + 1) & mask) {
        const double* there = mesh.point(table_[h]);
        if (there[0] == p[0] && there[1] == p[1] && there[2] == p[2]) return table_[h];
    }
    const VertexId v = static_cast<VertexId>(mesh.vertices.size());
    mesh.vertices.push_back(Vertex{{p[0], p[1], p[2]}, index, 0});
    put(mesh, v);
    return v;
}

}  // namespace mgdt
