// SPDX-License-Identifier: MIT
#include "recovery/plane_center.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/tetrahedron.hpp"

namespace mgdt {

void PlaneCenter::add(const double* a, const double* b, const double* c) {
    Plane plane;
    double e[2][3];
    for (int k = 0; k < 3; ++k) {
        e[0][k] = b[k] - a[k];
        e[1][k] = c[k] - a[k];
        plane.origin[k] = a[k];
    }
    for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        plane.normal[k] = e[0][l] * e[1][m] - e[0][m] * e[1][l];
    }
    const double size = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
    for (double& n : plane.normal) n /= size;
    planes_.push_back(plane);
}

double PlaneCenter::distance(const Plane& plane, const double (&x)[3]) const noexcept {
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += plane.normal[k] * (x[k] - plane.origin[k]);
    return sum;
}

bool PlaneCenter::is_inside(const double (&x)[3]) const noexcept {
    return std::all_of(planes_.begin(), planes_.end(),
                       [&](const Plane& plane) { return distance(plane, x) > 0; });
}

// Newton's step for the sum of the logarithms of the distances. Returns false if there is none.
bool PlaneCenter::find_step(const double (&x)[3], double (&step)[3]) const {
    double g[3] = {0, 0, 0}, h[3][3] = {};
    for (const Plane& plane : planes_) {
        const double d = distance(plane, x);
        for (int i = 0; i < 3; ++i) {
            g[i] += plane.normal[i] / d;
            for (int k = 0; k < 3; ++k) h[i][k] += plane.normal[i] / d * (plane.normal[k] / d);
        }
    }
    // Cramer's rule, by cofactors.
    double inverse[3][3], det = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            const int a = (i + 1) % 3, b = (i + 2) % 3, c = (k + 1) % 3, d = (k + 2) % 3;
            inverse[k][i] = h[a][c] * h[b][d] - h[a][d] * h[b][c];
        }
    for (int k = 0; k < 3; ++k) det += h[0][k] * inverse[k][0];
    if (!(det > 0) || !std::isfinite(det)) return false;
    for (int i = 0; i < 3; ++i) {
        step[i] = 0;
        for (int k = 0; k < 3; ++k) step[i] += inverse[i][k] / det * g[k];
        if (!std::isfinite(step[i])) return false;
    }
    return true;
}

bool PlaneCenter::enter(double (&x)[3]) const {
    constexpr int most_steps = 200;
    // A step ends beyond the plane, by half of the distance to the plane. If x is on the plane, the
    // step has this share of the largest distance of x from a plane as its length.
    constexpr double length = 1.5, least_share = 1e-3;
    double largest = 0;
    for (const Plane& plane : planes_) largest = std::max(largest, std::fabs(distance(plane, x)));
    for (int i = 0; i < most_steps; ++i) {
        double least = 0;
        const Plane* worst = nullptr;
        for (const Plane& plane : planes_) {
            const double d = distance(plane, x);
            if (d > least) continue;
            least = d;
            worst = &plane;
        }
        if (worst == nullptr) return true;
        const double step = std::max(-length * least, least_share * largest);
        for (int k = 0; k < 3; ++k) x[k] += step * worst->normal[k];
    }
    return false;
}

void PlaneCenter::approach(double (&x)[3]) const {
    constexpr int most_steps = 40, most_halvings = 10;
    if (!is_inside(x)) return;
    for (int i = 0; i < most_steps; ++i) {
        double step[3];
        if (!find_step(x, step)) return;
        bool is_found = false;
        double share = 1, moved[3];
        for (int k = 0; k < most_halvings && !is_found; ++k, share *= 0.5) {
            for (int c = 0; c < 3; ++c) moved[c] = x[c] + share * step[c];
            is_found = is_inside(moved);
        }
        if (!is_found) return;
        std::copy_n(moved, 3, x);
    }
}

namespace {

// Lists the half-spaces in which tetrahedra of a vertex are positive.
void add_half_spaces(const FlipMesh& mesh, std::uint32_t v,
                     const Buffer<FlipMesh::Corners>& tetrahedra, std::size_t first,
                     PlaneCenter& center) {
    center.clear();
    for (std::size_t i = first; i < tetrahedra.size(); ++i) {
        const std::uint32_t* const t = tetrahedra[i].v;
        const auto at = static_cast<unsigned>(std::find(t, t + 4, v) - t);
        if (at == 4) continue;
        // (a, b, c, v) is positive if the tetrahedron is.
        const unsigned char* const f = outer_face[at];
        center.add(mesh.point(t[f[0]]), mesh.point(t[f[1]]), mesh.point(t[f[2]]));
    }
}

bool move(FlipMesh& mesh, std::uint32_t v, const double (&x)[3],
          const Buffer<FlipMesh::Corners>& tetrahedra, std::size_t first) {
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2])) return false;
    double before[3];
    std::copy_n(mesh.point(v), 3, before);
    mesh.move_point(v, x);
    if (mesh.are_positive(tetrahedra, first)) return true;
    mesh.move_point(v, before);
    return false;
}

}  // namespace

bool enter_half_spaces(FlipMesh& mesh, std::uint32_t v, const Buffer<FlipMesh::Corners>& tetrahedra,
                       std::size_t first, PlaneCenter& center) {
    if (mesh.are_positive(tetrahedra, first)) return true;
    add_half_spaces(mesh, v, tetrahedra, first, center);
    double x[3];
    std::copy_n(mesh.point(v), 3, x);
    return center.enter(x) && move(mesh, v, x, tetrahedra, first);
}

void center_new_point(FlipMesh& mesh, std::uint32_t v, const Buffer<FlipMesh::Corners>& tetrahedra,
                      std::size_t first, PlaneCenter& center) {
    add_half_spaces(mesh, v, tetrahedra, first, center);
    double x[3];
    std::copy_n(mesh.point(v), 3, x);
    center.approach(x);
    move(mesh, v, x, tetrahedra, first);
}

}  // namespace mgdt
