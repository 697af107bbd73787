// SPDX-License-Identifier: MIT
#include "query/sphere_bound.hpp"

#include "kernel/circumsphere.hpp"
#include "predicates/twofold.hpp"

namespace mgdt {
namespace {

struct TwofoldVector {
    Twofold x[3];

    TwofoldVector(const Twofold& a, const Twofold& b, const Twofold& c) : x{a, b, c} {}
    TwofoldVector(const double* p, const double* base)
        : x{Twofold::sum(p[0], -base[0]), Twofold::sum(p[1], -base[1]),
            Twofold::sum(p[2], -base[2])} {}
    friend Twofold dot(const TwofoldVector& a, const TwofoldVector& b) {
        return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
    }
    friend TwofoldVector cross(const TwofoldVector& a, const TwofoldVector& b) {
        const auto minor = [&](int i, int j) { return a.x[i] * b.x[j] - a.x[j] * b.x[i]; };
        return {minor(1, 2), minor(2, 0), minor(0, 1)};
    }
    double largest() const { return max_magnitude(x[0].high, x[1].high, x[2].high); }
};

bool is_close_enough(const Sphere& s, const Tetrahedron& t, const Vertex* vertices) {
    const double* const base = vertices[t.v[0]].x;
    const TwofoldVector a(vertices[t.v[1]].x, base), b(vertices[t.v[2]].x, base),
        c(vertices[t.v[3]].x, base);
    const TwofoldVector bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const Twofold aa = dot(a, a), bb = dot(b, b), cc = dot(c, c), det = dot(a, bc);
    const double alpha = a.largest(), beta = b.largest(), gamma = c.largest();
    const double product = alpha * beta * gamma;
    const double sum = aa.high * beta * gamma + bb.high * gamma * alpha + cc.high * alpha * beta;
    const double largest = max_magnitude(s.w[0], s.w[1], s.w[2]);
    // A sphere whose bound was computed from these vertices passes both tests. If a test fails, the
    // arithmetic below is not exact enough.
    if (!(det.high > 64 * unit_roundoff * product)) return false;
    if (!(s.e * det.high > 20 * unit_roundoff * (sum + product * largest))) return false;
    for (int i = 0; i < 3; ++i) {
        const Twofold numerator = aa * bc.x[i] + bb * ca.x[i] + cc * ab.x[i];
        const Twofold off = numerator - det * Twofold{s.w[i], 0};
        const double allowed = (s.e - 6 * unit_roundoff * largest) * det.high;
        if (!(std::fabs(off.high) < (1 - 0x1p-40) * allowed)) return false;
    }
    return true;
}

}  // namespace

bool sphere_is_within_bound(const Sphere& s, const Tetrahedron& t, const Vertex* vertices) {
    if (std::isinf(s.e)) return true;
    const Sphere again = circumsphere(t, vertices);
    // `again` is proved to be within 0.981 of its error bound (within 0.8 for the normal of a
    // ghost).
    const double error = (t.is_ghost() ? 0.81 : 0.99) * std::fabs(again.e);
    bool agrees = true;
    for (int i = 0; i < 3; ++i)
        agrees = agrees && std::fabs(s.w[i] - again.w[i]) + error <= std::fabs(s.e);
    if (agrees) return true;
    for (const VertexId v : t.v)
        if (v != infinite_vertex && !in_normal_range(vertices[v].x)) return false;
    return !t.is_ghost() && is_close_enough(s, t, vertices);
}

}  // namespace mgdt
