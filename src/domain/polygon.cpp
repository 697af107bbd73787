// SPDX-License-Identifier: MIT
#include "domain/polygon.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// A polygon, projected to the plane of two coordinates, from which ears are cut off.
class EarCutter {
  public:
    EarCutter(const double* points, const std::uint32_t* corners, std::size_t size,
              Allocator& allocator)
        : points_(points), left_(allocator, size) {
        for (std::size_t i = 0; i < size; ++i) left_[i] = corners[i];
        choose_axes();
    }

    // Appends the triangles. Returns false if there is no ear.
    bool run(Buffer<std::uint32_t>& triangles) {
        if (is_flat_) return false;
        while (left_.size() > 3) {
            if (remove_spike()) continue;
            const std::size_t ear = best_ear();
            if (ear == left_.size()) return false;
            append(before(ear), ear, after(ear), triangles);
            remove(ear);
        }
        if (left_.size() < 3) return true;
        if (turn(0, 1, 2) <= 0) return false;
        append(0, 1, 2, triangles);
        return true;
    }

  private:
    const double* point(std::size_t i) const { return points_ + 3 * std::size_t{left_[i]}; }
    std::size_t after(std::size_t i) const { return i + 1 < left_.size() ? i + 1 : 0; }
    std::size_t before(std::size_t i) const { return (i > 0 ? i : left_.size()) - 1; }
    void append(std::size_t a, std::size_t b, std::size_t c,
                Buffer<std::uint32_t>& triangles) const {
        for (const std::size_t i : {a, b, c}) triangles.push_back(left_[i]);
    }

    void remove(std::size_t i) {
        for (; i + 1 < left_.size(); ++i) left_[i] = left_[i + 1];
        left_.pop_back();
    }

    // Removes a corner with an edge to it and the same edge back, outside of the polygon on both
    // sides. Ears leave such corners where a hole touches the border. Returns false if there is
    // none.
    bool remove_spike() {
        for (std::size_t i = 0; i < left_.size(); ++i) {
            const std::size_t a = before(i), b = after(i), p = before(a), n = after(b);
            if (!is_same(a, b)) continue;
            const bool is_inside = is_same(p, n) ? false
                                   : turn(p, a, n) > 0
                                       ? turn(a, n, i) > 0 && turn(a, i, p) > 0
                                       : !(turn(a, p, i) >= 0 && turn(a, i, n) >= 0);
            if (is_inside) continue;
            remove(std::max(i, b));
            remove(std::min(i, b));
            return true;
        }
        return false;
    }

    // Chooses the axes so that the polygon turns left: by the largest component of the normal of
    // Newell's formula. The sums are of differences from the first corner, halved against overflow.
    void choose_axes() {
        double normal[3] = {0, 0, 0}, largest = 0;
        const double* const o = point(0);
        for (std::size_t i = 0; i < left_.size(); ++i)
            for (int k = 0; k < 3; ++k)
                largest = std::max(largest, std::fabs(point(i)[k] / 2 - o[k] / 2));
        if (largest == 0) largest = 1;
        for (std::size_t i = 0; i < left_.size(); ++i) {
            double p[3], q[3];
            for (int k = 0; k < 3; ++k) {
                p[k] = (point(i)[k] / 2 - o[k] / 2) / largest;
                q[k] = (point(after(i))[k] / 2 - o[k] / 2) / largest;
            }
            for (int k = 0; k < 3; ++k) {
                const int u = (k + 1) % 3, v = (k + 2) % 3;
                normal[k] += p[u] * q[v] - p[v] * q[u];
            }
        }
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
        u_ = (axis + 1) % 3;
        v_ = (axis + 2) % 3;
        if (normal[axis] < 0) std::swap(u_, v_);
        is_flat_ = normal[axis] == 0;
    }

    // The sign of the area of a triangle in the plane: its orientation with a point above.
    int turn(std::size_t a, std::size_t b, std::size_t c) const {
        const double *const p = point(a), *const q = point(b), *const r = point(c);
        const double pa[3] = {p[u_], p[v_], 0}, pb[3] = {q[u_], q[v_], 0},
                     pc[3] = {r[u_], r[v_], 0}, above[3] = {p[u_], p[v_], 1};
        return orientation(pa, pb, pc, above);
    }
    // Whether two corners have one place in the plane.
    bool is_same(std::size_t a, std::size_t b) const {
        return point(a)[u_] == point(b)[u_] && point(a)[v_] == point(b)[v_];
    }

    // Whether corner k is at corner x of the triangle xyz and an edge of it goes into the triangle.
    bool enters(std::size_t k, std::size_t x, std::size_t y, std::size_t z) const {
        if (!is_same(k, x)) return false;
        for (const std::size_t q : {before(k), after(k)})
            if (turn(x, y, q) > 0 && turn(x, q, z) > 0) return true;
        return false;
    }

    // Whether the triangle at corner i is an ear: no other corner is in it, boundary included.
    bool is_ear(std::size_t i) const {
        const std::size_t a = before(i), c = after(i);
        if (turn(a, i, c) <= 0) return false;
        for (std::size_t k = 0; k < left_.size(); ++k) {
            if (k == a || k == i || k == c) continue;
            if (is_same(k, a) || is_same(k, i) || is_same(k, c)) {
                if (enters(k, a, i, c) || enters(k, i, c, a) || enters(k, c, a, i)) return false;
                continue;
            }
            if (turn(a, i, k) >= 0 && turn(i, c, k) >= 0 && turn(c, a, k) >= 0) return false;
        }
        return true;
    }

    // The ear with the shortest new edge, or left_.size() if there is none.
    std::size_t best_ear() const {
        std::size_t best = left_.size();
        for (std::size_t i = 0; i < left_.size(); ++i) {
            if (best != left_.size() &&
                compare_lengths(point(before(i)), point(after(i)), point(before(best)),
                                point(after(best))) >= 0)
                continue;
            if (is_ear(i)) best = i;
        }
        return best;
    }

    const double* points_;
    Buffer<std::uint32_t> left_;  // the corners that are left
    int u_ = 0, v_ = 1;
    bool is_flat_ = false;  // the corners are on a line, or the polygon crosses itself
};

}  // namespace

bool triangulate_polygon(const double* points, const std::uint32_t* corners, std::size_t size,
                         Buffer<std::uint32_t>& triangles) {
    if (size < 3) return false;
    const std::size_t before = triangles.size();
    if (size == 3) {
        for (int k = 0; k < 3; ++k) triangles.push_back(corners[k]);
        return true;
    }
    if (EarCutter(points, corners, size, triangles.allocator()).run(triangles)) return true;
    triangles.resize(before);
    return false;
}

}  // namespace mgdt
