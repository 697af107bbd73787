// SPDX-License-Identifier: MIT
#include "dual/link.hpp"

namespace mgdt {

void Link::gather(const Mesh& mesh, VertexId v, TetId first) {
    vertices_.clear();
    tetrahedra_.clear();
    triangles_.clear();
    tetrahedra_.number(first);
    // The order of outer_face is counter-clockwise as seen from the vertex. The link has the
    // opposite order.
    const auto slots = [](unsigned of_vertex) {
        const unsigned char* const face = outer_face[of_vertex];
        struct {
            unsigned char slot[3];
        } s = {{face[0], face[2], face[1]}};
        return s;
    };
    const auto corner_of = [](const Tetrahedron& t, VertexId of) {
        return (t.v[1] == of ? 1u : 0u) | (t.v[2] == of ? 2u : 0u) | (t.v[3] == of ? 3u : 0u);
    };
    for (std::uint32_t i = 0; i < tetrahedra_.size(); ++i) {
        const Tetrahedron& t = mesh.tetrahedra[tetrahedra_.name(i)];
        const auto s = slots(corner_of(t, v));
        triangles_.grow(i + 1);
        triangles_.resize_within_capacity(i + 1);
        LinkTriangle& triangle = triangles_[i];
        for (unsigned k = 0; k < 3; ++k) {
            triangle.corner[k] = vertices_.number(t.v[s.slot[k]]);
            triangle.beyond[k] = tetrahedra_.number(tetrahedron_of(t.n[s.slot[k]]));
        }
    }
}

}  // namespace mgdt
