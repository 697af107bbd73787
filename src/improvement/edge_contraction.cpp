// SPDX-License-Identifier: MIT
#include "improvement/edge_contraction.hpp"

#include <algorithm>

#include "improvement/quality.hpp"

namespace mgdt {

bool EdgeContraction::find(std::uint32_t t, unsigned i, unsigned j, Change& change) {
    change.clear();
    const std::uint32_t leaving = mesh_.tetrahedra[t].v[i], kept = mesh_.tetrahedra[t].v[j];
    const VertexClass& freedom = mesh_.classes[leaving];
    if (!freedom.may_leave ||
        (freedom.freedom != Freedom::free && freedom.freedom != Freedom::in_plane) ||
        !star_.collect(mesh_, leaving))
        return false;
    double before = above_all, after = above_all;
    for (const std::uint32_t s : star_.tetrahedra) before = std::min(before, mesh_.qualities[s]);
    // If another tetrahedron at the vertex is worse, the vertex is tried for that one.
    if (before < mesh_.qualities[t]) return false;
    bool is_along_facet = false;
    for (const std::uint32_t s : star_.tetrahedra) {
        const FlexibleMesh::Tetrahedron& tetrahedron = mesh_.tetrahedra[s];
        change.removed.push_back(s);
        const unsigned at = tetrahedron.position(leaving);
        // Faces of facets at the vertex. Each is listed once, by its first side if it has two.
        for (unsigned k = 0; k < 4; ++k) {
            const FlexibleMesh::Side side = tetrahedron.facets[k];
            if (k == at || side == no_index || (side % 2 == 1 && tetrahedron.n[k] != no_index))
                continue;
            const unsigned char* const f = outer_face[k];
            Change::Face face = {{tetrahedron.v[f[0]], tetrahedron.v[f[1]], tetrahedron.v[f[2]]},
                                 FlexibleMesh::label_of(side)};
            if (side % 2 == 1) std::swap(face.v[1], face.v[2]);
            if (std::find(face.v, face.v + 3, kept) != face.v + 3) {
                ++change.more.lost_faces;
                is_along_facet = true;
                continue;
            }
            std::replace(face.v, face.v + 3, leaving, kept);
            change.faces.push_back(face);
        }
        if (tetrahedron.has(kept)) continue;
        Change::Tetrahedron moved = {
            {tetrahedron.v[0], tetrahedron.v[1], tetrahedron.v[2], tetrahedron.v[3]},
            mesh_.regions[s],
            0};
        moved.v[at] = kept;
        moved.quality = mesh_.quality(moved.v);
        if (!(moved.quality > before)) return false;
        after = std::min(after, moved.quality);
        change.added.push_back(moved);
    }
    if (freedom.freedom == Freedom::in_plane && !is_along_facet) return false;
    change.more.lost_vertex = leaving;
    change.before = before;
    change.after = after;
    return !change.added.empty();
}

}  // namespace mgdt
