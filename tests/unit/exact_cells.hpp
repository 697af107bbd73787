// SPDX-License-Identifier: MIT
// The Voronoi cell of a point as the intersection of all half-spaces, in rational numbers. Neither
// the triangulation nor anything of src/dual has a part in it.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <vector>

namespace exact_cells {

using Rational = boost::multiprecision::cpp_rational;
using V = std::array<Rational, 3>;

inline Rational dot(const V& a, const V& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline V cross(const V& a, const V& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline V operator-(const V& a, const V& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline V operator+(const V& a, const V& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline V operator*(const Rational& s, const V& a) {
    return {s * a[0], s * a[1], s * a[2]};
}

struct HalfSpace {  // normal . x <= offset
    V normal;
    Rational offset;
};

// Whether the normals are positively oriented; then x is where the planes meet.
inline bool meet(const HalfSpace& p, const HalfSpace& q, const HalfSpace& r, V& x) {
    const V qr = cross(q.normal, r.normal), rp = cross(r.normal, p.normal),
            pq = cross(p.normal, q.normal);
    const Rational det = dot(p.normal, qr);
    if (det <= 0) return false;
    x = 1 / det * (p.offset * qr + q.offset * rp + r.offset * pq);
    return true;
}

struct Cell {
    Rational volume = 0;
    V moment = {0, 0, 0};  // volume times the centroid
    double area = 0;
    int faces = 0;
    Rational reach = 0;  // the largest coordinate of a corner
};

// Relative to point k.
inline std::vector<HalfSpace> half_spaces(const std::vector<double>& xyz, std::size_t k,
                                          const std::vector<double>& planes) {
    const V origin = {xyz[3 * k], xyz[3 * k + 1], xyz[3 * k + 2]};
    std::vector<HalfSpace> all;
    for (std::size_t i = 0; 3 * i < xyz.size(); ++i) {
        const V p = V{xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]} - origin;
        if (i != k) all.push_back({p, dot(p, p) / 2});
    }
    for (std::size_t i = 0; i < planes.size(); i += 4) {
        const V normal = {planes[i], planes[i + 1], planes[i + 2]};
        all.push_back({normal, planes[i + 3] - dot(normal, origin)});
    }
    return all;
}

// The face in plane k: what the others leave of a triangle, `far` being more than the distance of
// any corner.
inline std::vector<V> face(const std::vector<HalfSpace>& all, std::size_t k, const Rational& far) {
    const V& normal = all[k].normal;
    std::size_t least = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (abs(normal[i]) < abs(normal[least])) least = i;
    V axis = {0, 0, 0};
    axis[least] = 1;
    V first = cross(normal, axis), second = cross(normal, first);
    const auto largest = [](const V& v) {
        return std::max(std::max(Rational(abs(v[0])), Rational(abs(v[1]))), Rational(abs(v[2])));
    };
    first = 8 * far / largest(first) * first;
    second = 8 * far / largest(second) * second;
    const V middle = all[k].offset / dot(normal, normal) * normal;
    std::vector<V> polygon = {middle + first, middle + second, middle - (first + second)}, kept;
    for (std::size_t j = 0; j < all.size() && !polygon.empty(); ++j) {
        if (j == k) continue;
        kept.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const V &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const Rational ha = dot(all[j].normal, a) - all[j].offset,
                           hb = dot(all[j].normal, b) - all[j].offset;
            if (ha <= 0) kept.push_back(a);
            if ((ha < 0 && hb > 0) || (ha > 0 && hb < 0))
                kept.push_back(a + ha / (ha - hb) * (b - a));
        }
        polygon.swap(kept);
    }
    return polygon;
}

// Whether two half-spaces are one.
inline bool are_equal(const HalfSpace& a, const HalfSpace& b) {
    return dot(a.normal, b.normal) > 0 && cross(a.normal, b.normal) == V{0, 0, 0} &&
           a.offset * dot(a.normal, b.normal) == b.offset * dot(a.normal, a.normal);
}

inline Cell cell(const std::vector<HalfSpace>& given, const Rational& far) {
    Cell cell;
    std::vector<HalfSpace> all;
    for (const HalfSpace& h : given)
        if (std::none_of(all.begin(), all.end(),
                         [&](const HalfSpace& other) { return are_equal(h, other); }))
            all.push_back(h);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::vector<V> polygon = face(all, k, far);
        const V& normal = all[k].normal;
        const Rational square = dot(normal, normal);
        const V foot = all[k].offset / square * normal;
        Rational doubled = 0;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const V &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const Rational along = dot(normal, cross(a, b)),
                           volume = along * all[k].offset / square / 6;
            doubled += along;
            for (const Rational& x : a) cell.reach = std::max(cell.reach, Rational(abs(x)));
            cell.volume += volume;
            cell.moment = cell.moment + volume / 4 * (foot + a + b);
        }
        if (doubled == 0) continue;
        ++cell.faces;
        cell.area += static_cast<double>(doubled) / std::sqrt(static_cast<double>(square)) / 2;
    }
    return cell;
}

}  // namespace exact_cells
