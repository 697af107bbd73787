// SPDX-License-Identifier: MIT
// The volumes of meshes, in rationals.
#pragma once

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <map>

#include "solid/solid_mesh.hpp"

namespace mgdt {

using Rational = boost::multiprecision::cpp_rational;

inline Rational determinant(const double* a, const double* b, const double* c) {
    const Rational x[3][3] = {{a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {c[0], c[1], c[2]}};
    return x[0][0] * (x[1][1] * x[2][2] - x[1][2] * x[2][1]) -
           x[0][1] * (x[1][0] * x[2][2] - x[1][2] * x[2][0]) +
           x[0][2] * (x[1][0] * x[2][1] - x[1][1] * x[2][0]);
}

// Six times the volume of a tetrahedron.
inline Rational sixfold_volume(const SolidMesh& m, std::size_t t) {
    const std::uint32_t* const v = m.tetrahedra.begin() + 4 * t;
    const auto point = [&](int i) { return m.points.begin() + 3 * std::size_t{v[i]}; };
    return determinant(point(1), point(2), point(3)) - determinant(point(0), point(2), point(3)) +
           determinant(point(0), point(1), point(3)) - determinant(point(0), point(1), point(2));
}

// Six times the volume of each region: by its tetrahedra, and by the faces of its boundary.
inline void expect_equal_volumes(const SolidMesh& m) {
    std::map<std::uint32_t, Rational> inside, around;
    const auto point = [&](std::uint32_t v) { return m.points.begin() + 3 * std::size_t{v}; };
    for (std::size_t t = 0; t < m.tetrahedron_count(); ++t)
        inside[m.regions[t]] += sixfold_volume(m, t);
    for (std::size_t f = 0; f < m.face_facets.size(); ++f) {
        const std::uint32_t* const v = m.faces.begin() + 3 * f;
        const Rational part = determinant(point(v[0]), point(v[1]), point(v[2]));
        const std::uint32_t front = m.face_tetrahedra[2 * f], back = m.face_tetrahedra[2 * f + 1];
        // A normal that points out of a region counts positively.
        if (back != no_index) around[m.regions[back]] += part;
        if (front != no_index) around[m.regions[front]] -= part;
    }
    EXPECT_EQ(inside, around);
}

inline double volume(const SolidMesh& m) {
    Rational sum = 0;
    const auto point = [&](std::uint32_t v) { return m.points.begin() + 3 * std::size_t{v}; };
    for (std::size_t f = 0; f < m.face_facets.size(); ++f) {
        const std::uint32_t* const v = m.faces.begin() + 3 * f;
        const Rational part = determinant(point(v[0]), point(v[1]), point(v[2]));
        if (m.face_tetrahedra[2 * f + 1] != no_index) sum += part;
        if (m.face_tetrahedra[2 * f] != no_index) sum -= part;
    }
    return static_cast<double>(sum / 6);
}

}  // namespace mgdt
