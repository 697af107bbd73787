// SPDX-License-Identifier: MIT
#include "kernel/circumsphere.hpp"

#include "mesh/mesh.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

void set_circumsphere(Tetrahedron& t, const Vertex* vertices) {
    const double* base = vertices[t.v[0]].x;
    const bool ghost =
        t.v[1] == infinite_vertex || t.v[2] == infinite_vertex || t.v[3] == infinite_vertex;
    bool normal = in_normal_range(base);
    for (int i = 1; i < 4; ++i)
        normal = normal && (t.v[i] == infinite_vertex || in_normal_range(vertices[t.v[i]].x));
    if (ghost) {
        // (base, ., ., .) with the vertex at infinity turned to the end keeps its orientation.
        const int slot = t.infinite_slot();
        const VertexId a = t.v[slot % 3 + 1], b = t.v[(slot + 1) % 3 + 1];
        set_normal(relative_to(vertices[a].x, base), relative_to(vertices[b].x, base), t);
    } else {
        set_sphere(relative_to(vertices[t.v[1]].x, base), relative_to(vertices[t.v[2]].x, base),
                   relative_to(vertices[t.v[3]].x, base), t);
    }
    if (!normal) t.e = ghost ? -infinity : infinity;
}

bool is_conflict_exact(const Mesh& mesh, const Tetrahedron& t, const double* q) {
    const double* p[4];
    for (int i = 0; i < 4; ++i) p[i] = mesh.point(t.v[i]);
    if (!t.is_ghost()) return side_of_sphere_perturbed(p[0], p[1], p[2], p[3], q) > 0;

    // A ghost is in conflict with the points beyond its facet's plane. On the plane itself the
    // circle counts, perturbed: that is the sphere of the finite tetrahedron behind the facet.
    const int slot = t.infinite_slot();
    p[slot] = q;
    const int side = orientation(p[0], p[1], p[2], p[3]);
    if (side != 0) return side > 0;
    const Tetrahedron& behind = mesh.tetrahedra[t.n[slot] >> 2];
    if (behind.is_in_cavity()) return true;
    return side_of_sphere_perturbed(mesh.point(behind.v[0]), mesh.point(behind.v[1]),
                                    mesh.point(behind.v[2]), mesh.point(behind.v[3]), q) > 0;
}

VertexId vertex_at(const Mesh& mesh, const Tetrahedron& t, const double* q) {
    for (const VertexId v : t.v) {
        const double* p = mesh.point(v);
        if (v != infinite_vertex && p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) return v;
    }
    return infinite_vertex;
}

}  // namespace mgdt
