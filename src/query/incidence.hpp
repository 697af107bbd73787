// SPDX-License-Identifier: MIT
// The live tetrahedra around each vertex, ghosts and the vertex at infinity included, as a
// compressed list.
#pragma once

#include "mesh/mesh.hpp"

namespace mgdt {

class Incidence {
  public:
    Incidence(const Mesh& mesh, Allocator& allocator) : ends_(allocator), list_(allocator) {
        ends_.resize(mesh.vertices.size() + 1, 0);
        list_.resize(4 * mesh.live_count());
        // ends_[v + 1] counts, then begins, then ends the list of v.
        for (const Tetrahedron& t : mesh.tetrahedra)
            if (!t.is_dead())
                for (const VertexId v : t.v) ++ends_[v + 1u];
        std::size_t sum = 0;
        for (std::size_t v = 0; v + 1 < ends_.size(); ++v) {
            const std::size_t count = ends_[v + 1];
            ends_[v + 1] = sum;
            sum += count;
        }
        for (TetId t = 0; t < mesh.tetrahedra.size(); ++t)
            if (!mesh.tetrahedra[t].is_dead())
                for (const VertexId v : mesh.tetrahedra[t].v) list_[ends_[v + 1u]++] = t;
    }

    struct Range {
        const TetId* first;
        const TetId* last;
        const TetId* begin() const { return first; }
        const TetId* end() const { return last; }
        std::size_t size() const { return static_cast<std::size_t>(last - first); }
    };
    Range tetrahedra(VertexId v) const {
        return {list_.data() + ends_[v], list_.data() + ends_[v + 1u]};
    }

  private:
    Buffer<std::size_t> ends_;
    Buffer<TetId> list_;
};

}  // namespace mgdt
