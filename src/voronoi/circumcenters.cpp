// SPDX-License-Identifier: MIT
#include "voronoi/circumcenters.hpp"

#include <algorithm>
#include <cmath>

#include "parallel/watched_split.hpp"
#include "predicates/differences.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

Circumcenters::Circumcenters(const MeshView& view, const VertexIndices& indices,
                             StageProgress& progress)
    : centers_(view.allocator, view.mesh.tetrahedra.size()) {
    set_factor(view);
    progress.enter(0, 0.6);
    set_centers(view, indices, progress);
    const std::size_t slots = view.mesh.tetrahedra.size();
    DisjointSets sets(view.allocator, slots);
    progress.enter(0.6, 1);
    watched_split(
        view.team, progress, slots, slots_per_thread,
        [&](std::size_t begin, std::size_t end) { join_tetrahedra(view.mesh, sets, begin, end); });
    watched_split(
        view.team, progress, slots, slots_per_thread,
        [&](std::size_t begin, std::size_t end) { join_ghosts(view.mesh, sets, begin, end); });
    watched_split(view.team, progress, slots, slots_per_thread,
                  [&](std::size_t begin, std::size_t end) {
                      for (std::size_t id = begin; id < end; ++id)
                          centers_[id].first = sets.least(static_cast<TetId>(id));
                  });
}

void Circumcenters::set_factor(const MeshView& view) {
    double largest = 0;
    for (VertexId v = 1; v < view.mesh.vertices.size(); ++v)
        largest = std::max(largest, exact::largest_of<0, 3>(view.mesh.point(v)));
    constexpr int most = 1000;
    factor_ = std::ldexp(1.0, -std::max(-most, std::min(most, std::ilogb(largest))));
}

// The corrections depend on the order of the vertices, so the vertices are in canonical order.
void Circumcenters::set_centers(const MeshView& view, const VertexIndices& indices,
                                StageProgress& progress) {
    const Mesh& mesh = view.mesh;
    watched_split(view.team, progress, mesh.tetrahedra.size(), slots_per_thread,
                  [&](std::size_t begin, std::size_t end) {
                      for (std::size_t id = begin; id < end; ++id) {
                          const Tetrahedron& t = mesh.tetrahedra[id];
                          mesh.tetrahedra.prefetch(id + ahead);
                          if (t.is_dead() || t.is_ghost()) continue;
                          unsigned at[4];
                          Numbering::canonical_positions(t, indices, at);
                          static_cast<SplitPoint&>(centers_[id]) =
                              split_circumcenter({mesh.point(t.v[at[0]]), mesh.point(t.v[at[1]]),
                                                  mesh.point(t.v[at[2]]), mesh.point(t.v[at[3]])},
                                                 factor_);
                      }
                  });
}

// Two adjacent tetrahedra have the same circumcentre if all five vertices are on one sphere. Then
// the rounded coordinates are equal too, which is tested first.
void Circumcenters::join_tetrahedra(const Mesh& mesh, DisjointSets& sets, std::size_t begin,
                                    std::size_t end) {
    for (std::size_t id = begin; id < end; ++id) {
        const Tetrahedron& t = mesh.tetrahedra[id];
        mesh.tetrahedra.prefetch(id + ahead);
        if (t.is_dead() || t.is_ghost()) continue;
        const double(&x)[3] = centers_[id].x;
        for (const FacetCode code : t.n) {
            const TetId beyond = tetrahedron_of(code);
            if (beyond < id) continue;
            const Tetrahedron& other = mesh.tetrahedra[beyond];
            if (other.is_ghost()) continue;
            const double(&y)[3] = centers_[beyond].x;
            if (x[0] != y[0] || x[1] != y[1] || x[2] != y[2]) continue;
            if (side_of_sphere(mesh.point(t.v[0]), mesh.point(t.v[1]), mesh.point(t.v[2]),
                               mesh.point(t.v[3]), mesh.point(other.v[face_of(code)])) == 0)
                sets.join(static_cast<TetId>(id), beyond);
        }
    }
}

// Two adjacent ghosts have the same ray if their hull facets are in one plane and the tetrahedra at
// these facets have the same circumcentre.
void Circumcenters::join_ghosts(const Mesh& mesh, DisjointSets& sets, std::size_t begin,
                                std::size_t end) {
    const auto inner = [&](const Tetrahedron& ghost) {
        return sets.least(tetrahedron_of(ghost.n[ghost.infinite_slot()]));
    };
    for (std::size_t id = begin; id < end; ++id) {
        const Tetrahedron& t = mesh.tetrahedra[id];
        if (t.is_dead() || !t.is_ghost()) continue;
        const auto infinite = static_cast<unsigned>(t.infinite_slot());
        const unsigned char* const of_facet = outer_face[infinite];
        for (unsigned face = 0; face < 4; ++face) {
            const TetId beyond = tetrahedron_of(t.n[face]);
            if (face == infinite || beyond < id) continue;
            const Tetrahedron& other = mesh.tetrahedra[beyond];
            if (inner(t) != inner(other)) continue;
            if (orientation(mesh.point(t.v[of_facet[0]]), mesh.point(t.v[of_facet[1]]),
                            mesh.point(t.v[of_facet[2]]),
                            mesh.point(other.v[face_of(t.n[face])])) == 0)
                sets.join(static_cast<TetId>(id), beyond);
        }
    }
}

}  // namespace mgdt
