// SPDX-License-Identifier: MIT
#include "improvement/edge_contraction.hpp"

#include <algorithm>

#include "improvement/quality.hpp"

namespace mgdt {

// Finds the ends of the edge that is left of two on one line, if they have one origin.
bool EdgeContraction::find_ends(std::uint32_t leaving, std::uint32_t kept,
                                std::uint32_t (&ends)[2]) const {
    ends[0] = kept;
    ends[1] = no_index;
    for (const std::uint32_t t : star_.tetrahedra)
        for (const std::uint32_t v : mesh_.tetrahedra[t].v)
            if (v != leaving && v != kept && mesh_.edges.has(leaving, v)) ends[1] = v;
    if (ends[1] == no_index || mesh_.edges.has(kept, ends[1])) return false;
    const KeptEdges::Origin one = mesh_.edges.origin(leaving, kept),
                            other = mesh_.edges.origin(leaving, ends[1]);
    return one.segment == other.segment && one.marker == other.marker;
}

bool EdgeContraction::find(std::uint32_t t, unsigned i, unsigned j, Change& change) {
    change.clear();
    const std::uint32_t leaving = mesh_.tetrahedra[t].v[i], kept = mesh_.tetrahedra[t].v[j];
    const VertexClass& freedom = mesh_.classes[leaving];
    if (!freedom.may_leave || freedom.freedom == Freedom::fixed ||
        (freedom.freedom == Freedom::on_line && !mesh_.edges.has(leaving, kept)) ||
        !star_.collect(mesh_, leaving))
        return false;
    double before = above_all, after = above_all;
    for (const std::uint32_t s : star_.tetrahedra) {
        before = std::min(before, mesh_.qualities[s]);
        // If another tetrahedron at the edge is worse, the edge is tried for that one.
        if (mesh_.qualities[s] < mesh_.qualities[t] && mesh_.tetrahedra[s].has(kept)) return false;
    }
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
    if (freedom.freedom == Freedom::on_line && !find_ends(leaving, kept, change.more.ends))
        return false;
    change.more.lost_vertex = leaving;
    change.before = before;
    change.after = after;
    return !change.added.empty();
}

}  // namespace mgdt
