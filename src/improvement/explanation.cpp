// SPDX-License-Identifier: MIT
#include "improvement/explanation.hpp"

#include <algorithm>

#include "improvement/quality.hpp"

namespace mgdt {
namespace {

// The square of the sine of the angle at p between q and r, or 0 if it has none.
double squared_sine(const double* p, const double* q, const double* r) {
    const Vector<double> u = difference<double>(q, p), v = difference<double>(r, p),
                         n = cross(u, v);
    const double product = dot(u, u) * dot(v, v);
    return product > least_product ? dot(n, n) / product : 0;
}

// Whether the angle between two faces of a tetrahedron, opposite corners i and j, is below the
// goal. The angle is that between the heights of corners i and j over the edge that the faces
// share.
bool is_angle_below(const FlexibleMesh& mesh, const std::uint32_t (&v)[4], unsigned i, unsigned j,
                    double goal) {
    unsigned k = 0;
    while (k == i || k == j) ++k;
    const unsigned l = 6 - i - j - k;
    const double* const p = mesh.point(v[k]);
    const Vector<double> edge = difference<double>(mesh.point(v[l]), p);
    const Vector<double> one = cross(edge, difference<double>(mesh.point(v[i]), p)),
                         other = cross(edge, difference<double>(mesh.point(v[j]), p)),
                         both = cross(one, other);
    return dot(one, other) > 0 && dot(both, both) < goal * (dot(one, one) * dot(other, other));
}

}  // namespace

void explain(const FlexibleMesh& mesh, double goal, Buffer<Reason>& reasons) {
    Buffer<std::uint8_t> is_thin(mesh.allocator());  // whether a vertex is at a thin face
    is_thin.resize(mesh.hints.size(), 0);
    for (const FlexibleMesh::Tetrahedron& t : mesh.tetrahedra)
        for (unsigned i = 0; i < 4 && !t.is_dead(); ++i) {
            if (t.facets[i] == no_index) continue;
            const unsigned char* const f = outer_face[i];
            const double* const p[3] = {mesh.point(t.v[f[0]]), mesh.point(t.v[f[1]]),
                                        mesh.point(t.v[f[2]])};
            for (int k = 0; k < 3; ++k)
                if (squared_sine(p[k], p[(k + 1) % 3], p[(k + 2) % 3]) < goal)
                    for (int m = 0; m < 3; ++m) is_thin[t.v[f[m]]] = 1;
        }
    reasons.clear();
    reasons.resize(mesh.tetrahedra.size(), Reason::none);
    for (std::uint32_t t = 0; t < reasons.size(); ++t) {
        const FlexibleMesh::Tetrahedron& tetrahedron = mesh.tetrahedra[t];
        if (tetrahedron.is_dead() || !(mesh.qualities[t] < goal)) continue;
        const std::uint32_t(&v)[4] = tetrahedron.v;
        reasons[t] = Reason::other;
        if (std::all_of(v, v + 4,
                        [&](std::uint32_t p) { return mesh.classes[p].freedom == Freedom::fixed; }))
            reasons[t] = Reason::fixed_corners;
        if (std::any_of(v, v + 4, [&](std::uint32_t p) { return is_thin[p] != 0; }))
            reasons[t] = Reason::thin_face;
        for (unsigned i = 0; i < 4; ++i)
            for (unsigned j = 0; j < i; ++j)
                if (tetrahedron.facets[i] != no_index && tetrahedron.facets[j] != no_index &&
                    is_angle_below(mesh, v, i, j, goal))
                    reasons[t] = Reason::input_angle;
    }
}

}  // namespace mgdt
