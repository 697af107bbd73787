// SPDX-License-Identifier: MIT
#include "kernel/circumsphere.hpp"

#include "mesh/mesh.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

Sphere circumsphere(const Tetrahedron& t, const Vertex* vertices) {
    const VertexId v[4] = {t.v[0], unmarked(t.v[1]), t.v[2], t.v[3]};
    const double* base = vertices[v[0]].x;
    const bool ghost = t.is_ghost();
    bool normal = true;
    for (const VertexId u : v)
        normal = normal && (u == infinite_vertex || in_normal_range(vertices[u].x));
    const auto corner = [&](int i) { return relative_to(vertices[v[i]].x, base); };
    Sphere s;
    if (ghost) {
        // The base vertex stays first, and the vertex at infinity is rotated to the end, which
        // keeps the orientation.
        const int slot = t.infinite_slot();
        set_normal(corner(slot % 3 + 1), corner((slot + 1) % 3 + 1), s);
    } else {
        set_sphere(corner(1), corner(2), corner(3), s);
    }
    if (!normal) s.e = ghost ? -infinity : infinity;
    return s;
}

bool is_conflict_exact(const Mesh& mesh, const Tetrahedron& t, const double* q) {
    const double* p[4];
    for (int i = 0; i < 4; ++i) p[i] = mesh.point(t.v[i]);
    if (!t.is_ghost()) return side_of_sphere_perturbed(p[0], p[1], p[2], p[3], q) > 0;

    // A ghost is in conflict with the points beyond the plane of its facet. For a point in the
    // plane, the circumcircle of the facet decides, with perturbation: it is the circumsphere of
    // the finite tetrahedron behind the facet.
    const int slot = t.infinite_slot();
    p[slot] = q;
    const int side = orientation(p[0], p[1], p[2], p[3]);
    if (side != 0) return side > 0;
    const Tetrahedron& behind = mesh.tetrahedra[tetrahedron_of(t.n[slot])];
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
