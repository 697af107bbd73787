// SPDX-License-Identifier: MIT
#include "domain/constrained_mesh.hpp"

#include <algorithm>

namespace mgdt {

ConstrainedMesh::ConstrainedMesh(const Triangulation& triangulation, const Buffer<double>& xyz,
                                 Allocator& allocator)
    : points(xyz),
      tetrahedra(allocator),
      free_slots(allocator),
      hints(allocator),
      star_(allocator),
      stamp_(allocator) {
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

std::uint32_t ConstrainedMesh::tetrahedron_at(std::uint32_t a, std::uint32_t b) {
    if (hints[a] == no_tetrahedron) return no_tetrahedron;
    stamp_.grow(tetrahedra.size());
    stamp_.resize(tetrahedra.size(), 0u);
    ++search_;
    star_.clear();
    star_.push_back(hints[a]);
    stamp_[hints[a]] = search_;
    for (std::size_t i = 0; i < star_.size(); ++i) {
        const Tetrahedron& t = tetrahedra[star_[i]];
        if (t.has(b)) return star_[i];
        for (unsigned k = 0; k < 4; ++k) {
            const std::uint32_t next = t.n[k];
            if (t.v[k] == a || next == no_index || stamp_[next / 4] == search_) continue;
            stamp_[next / 4] = search_;
            star_.push_back(next / 4);
        }
    }
    return no_tetrahedron;
}

std::uint32_t ConstrainedMesh::add(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                   std::uint32_t d) {
    std::uint32_t t;
    if (free_slots.empty()) {
        t = static_cast<std::uint32_t>(tetrahedra.size());
        if (t >= max_tetrahedra) fail(MGDT_ERR_TOO_LARGE, "there are too many tetrahedra");
        tetrahedra.push_back({});
    } else {
        t = free_slots.back();
        free_slots.pop_back();
    }
    tetrahedra[t] = {{a, b, c, d},
                     {no_index, no_index, no_index, no_index},
                     {no_index, no_index, no_index, no_index}};
    for (const std::uint32_t v : {a, b, c, d}) hints[v] = t;
    return t;
}

void ConstrainedMesh::remove(std::uint32_t tetrahedron) {
    tetrahedra[tetrahedron].v[0] = no_index;
    free_slots.push_back(tetrahedron);
}

}  // namespace mgdt
