// SPDX-License-Identifier: MIT
#include "domain/vertex_triangulation.hpp"

#include <algorithm>

#include "mesh/star_traversal.hpp"
#include "predicates/predicates.hpp"
#include "query/locate.hpp"

namespace mgdt {

void VertexTriangulation::set(const ConstrainedMesh& mesh, const Buffer<std::uint32_t>& vertices) {
    clear();
    vertices_ = &vertices;
    xyz_.clear();
    for (const std::uint32_t v : vertices)
        for (int k = 0; k < 3; ++k) xyz_.push_back(mesh.point(v)[k]);
    const double* const axis[3] = {xyz_.begin(), xyz_.begin() + 1, xyz_.begin() + 2};
    triangulation_[0].insert(vertices.size(), axis, 3);
}

void VertexTriangulation::clear() noexcept {
    triangulation_[0].clear();
    vertices_ = nullptr;
}

VertexId VertexTriangulation::vertex(std::uint32_t v) const {
    const std::uint32_t* const at = std::lower_bound(vertices_->begin(), vertices_->end(), v);
    assert(at != vertices_->end() && *at == v && "the vertex is not triangulated");
    return triangulation_[0].point_map()[static_cast<std::size_t>(at - vertices_->begin())];
}

std::uint32_t VertexTriangulation::apex(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Triangulation& t = triangulation_[0];
    const Mesh& mesh = t.mesh();
    const VertexId va = vertex(a), vb = vertex(b), vc = vertex(c);
    const Locator where = {mesh, t.calls(), nullptr};
    VertexId found = infinite_vertex;
    const auto look_at = [&](TetId id) {
        const Tetrahedron& tet = mesh.tetrahedra[id];
        VertexId other = infinite_vertex;
        unsigned common = 0;
        for (const VertexId v : tet.v) {
            if (v == va || v == vb || v == vc)
                ++common;
            else
                other = v;
        }
        if (common == 3 && other != infinite_vertex &&
            orientation(mesh.point(va), mesh.point(vb), mesh.point(vc), mesh.point(other)) > 0)
            found = other;
    };
    star_.clear();
    star_.push(where.tetrahedron_of(va));
    look_at(star_[0]);
    traverse_star(mesh, va, star_, [&](FacetCode facet) {
        if (found != infinite_vertex) return;
        if (star_.push(tetrahedron_of(facet))) look_at(tetrahedron_of(facet));
    });
    return found == infinite_vertex ? no_index : (*vertices_)[mesh.vertices[found].index];
}

}  // namespace mgdt
