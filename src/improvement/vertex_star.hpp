// SPDX-License-Identifier: MIT
// The tetrahedra at a vertex.
#pragma once

#include "improvement/flexible_mesh.hpp"

namespace mgdt {

class VertexStar {
  public:
    explicit VertexStar(Allocator& allocator) : tetrahedra(allocator) {}

    // Collects the tetrahedra at a vertex, in an order that depends on the mesh alone. Returns
    // false if there are more than most_tetrahedra, or if they are not connected by faces at the
    // vertex, as where two solids touch.
    bool collect(const FlexibleMesh& mesh, std::uint32_t v) {
        constexpr std::size_t most_tetrahedra = slots / 2;
        tetrahedra.clear();
        ++search_;
        visit(mesh.hints[v]);
        for (std::size_t k = 0; k < tetrahedra.size(); ++k) {
            const FlexibleMesh::Tetrahedron& t = mesh.tetrahedra[tetrahedra[k]];
            for (unsigned i = 0; i < 4; ++i) {
                if (t.v[i] == v || t.n[i] == no_index) continue;
                visit(t.n[i] / 4);
                if (tetrahedra.size() > most_tetrahedra) return false;
            }
        }
        return tetrahedra.size() == mesh.star_sizes[v];
    }

    Buffer<std::uint32_t> tetrahedra;

  private:
    static constexpr std::size_t slots = 1024;

    // Adds a tetrahedron unless it is in the list: a hash table with linear probing.
    void visit(std::uint32_t t) {
        std::size_t slot = (std::size_t{t} * 0x9E3779B1u >> 12) % slots;
        for (; stamp_[slot] == search_; slot = (slot + 1) % slots)
            if (key_[slot] == t) return;
        stamp_[slot] = search_;
        key_[slot] = t;
        tetrahedra.push_back(t);
    }

    std::uint32_t search_ = 0;
    std::uint32_t stamp_[slots] = {}, key_[slots];
};

}  // namespace mgdt
