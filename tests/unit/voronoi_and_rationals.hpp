// SPDX-License-Identifier: MIT
// Voronoi diagrams beside cells that are cut out of space in rational numbers.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <vector>

#include "core/triangulation.hpp"
#include "dual/face_sums.hpp"
#include "exact_cells.hpp"
#include "unwatched.hpp"
#include "voronoi/voronoi.hpp"

namespace mgdt {

// A diagram and the memory that it is in.
class OwnDiagram {
  public:
    explicit OwnDiagram(const std::vector<double>& xyz, const std::vector<double>& planes = {},
                        unsigned threads = 1, std::int32_t scheme = 0) {
        Triangulation t(nullptr, nullptr, nullptr);
        t.settings().scheme = scheme;
        const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
        t.insert(xyz.size() / 3, axis, 3);
        Team team(threads);
        const MeshView view = {team, t.mesh(), nullptr, allocator_, 0, false};
        const Region region(allocator_, planes.size() / 4, planes.data(), t.mesh(), 0);
        build_voronoi(view, region, xyz.size() / 3, 0, Unwatched(), diagram_);
        diagram_.planes.resize(planes.size());
        std::copy(planes.begin(), planes.end(), diagram_.planes.begin());
    }
    VoronoiDiagram& operator*() { return diagram_; }
    VoronoiDiagram* operator->() { return &diagram_; }

  private:
    Allocator allocator_;
    VoronoiDiagram diagram_{allocator_};
};

// Whether x is a double that is nearest to the rational number.
inline bool is_nearest(double x, const exact_cells::Rational& exact) {
    using exact_cells::Rational;
    // Half a unit of the largest double beyond it, numbers are infinite.
    const Rational largest = Rational(DBL_MAX),
                   end = largest + (largest - Rational(std::nextafter(DBL_MAX, 0))) / 2;
    if (std::isinf(x)) return x > 0 ? exact >= end : exact <= -end;
    const Rational distance = abs(Rational(x) - exact);
    for (const double other : {std::nextafter(x, -HUGE_VAL), std::nextafter(x, HUGE_VAL)})
        if (!std::isinf(other) && abs(Rational(other) - exact) < distance) return false;
    return exact < end && exact > -end;
}

// The face of a cell with this other side, or the number of faces.
inline std::size_t face_with_side(const VoronoiDiagram& d, std::size_t cell, std::uint32_t other) {
    for (std::uint64_t i = d.cell_begin[cell]; i < d.cell_begin[cell + 1]; ++i) {
        const std::uint32_t f = d.cell_faces[i];
        const std::uint32_t a = d.face_sides[2 * f], b = d.face_sides[2 * f + 1];
        if ((a == cell && b == other) || (b == cell && a == other)) return f;
    }
    return d.face_count();
}

// Compares the corners of a face with a polygon that is relative to the point of the cell.
inline void compare_corners(const VoronoiDiagram& d, std::size_t f, bool is_turned,
                            std::vector<exact_cells::V> polygon, const exact_cells::V& origin) {
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    while (polygon.size() > 1 && polygon.back() == polygon.front()) polygon.pop_back();
    if (is_turned) std::reverse(polygon.begin(), polygon.end());
    const std::size_t n = static_cast<std::size_t>(d.face_begin[f + 1] - d.face_begin[f]);
    ASSERT_EQ(n, polygon.size());
    const auto is_corner = [&](std::size_t i, std::size_t of_polygon) {
        const std::uint32_t corner = d.face_corners[d.face_begin[f] + i];
        for (std::size_t k = 0; k < 3; ++k)
            if (!is_nearest(d.vertices[3 * std::size_t{corner} + k],
                            origin[k] + polygon[of_polygon][k]))
                return false;
        return true;
    };
    bool is_same = false;
    for (std::size_t turn = 0; turn < n && !is_same; ++turn) {
        is_same = true;
        for (std::size_t i = 0; i < n && is_same; ++i) is_same = is_corner(i, (i + turn) % n);
    }
    EXPECT_TRUE(is_same);
}

// Compares the area and the centroid of a bounded face. `doubled` is twice the area times the
// length of the normal, which is the vector between the two points of the face if it has two.
inline void compare_measures(const VoronoiDiagram& d, std::size_t f,
                             const std::vector<exact_cells::V>& polygon,
                             const exact_cells::V& normal, const exact_cells::Rational& doubled,
                             const exact_cells::Rational& reach, bool has_two_points,
                             const exact_cells::V& origin) {
    using namespace exact_cells;
    using exact_cells::operator+, exact_cells::operator-, exact_cells::operator*;
    const Rational square = exact_cells::dot(normal, normal),
                   squared_area = doubled * doubled / (4 * square),
                   tiny = has_two_points ? Rational(1e-14) * square : Rational(0);
    const double area = d.areas[f];
    if (std::isinf(area)) {
        EXPECT_GE(squared_area, Rational(DBL_MAX) * Rational(DBL_MAX) * Rational(1 - 1e-12));
    } else {
        const Rational most = Rational(area) + tiny + Rational(DBL_MIN),
                       least = Rational(area) - tiny - Rational(DBL_MIN),
                       part = Rational(1.001e-12);
        EXPECT_GE(most * most, squared_area * (1 - part) * (1 - part)) << area;
        if (least > 0) {
            EXPECT_LE(least * least, squared_area * (1 + part) * (1 + part)) << area;
        }
    }
    if (squared_area <= tiny * tiny) return;
    V moment = {0, 0, 0};
    Rational sum = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const V before = polygon[i] - polygon[0], here = polygon[i + 1] - polygon[0];
        const Rational weight = exact_cells::dot(normal, exact_cells::cross(before, here));
        moment = moment + weight * (before + here);
        sum += weight;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const double x = d.face_centroids[3 * f + k];
        const Rational exact = origin[k] + polygon[0][k] + moment[k] / (3 * sum);
        if (std::isinf(x)) {
            EXPECT_GE(abs(exact) * Rational(1 + 1e-12), Rational(DBL_MAX));
            continue;
        }
        // The coordinate is rounded twice.
        const Rational rounding = Rational(0x1p-51) * abs(exact) + Rational(DBL_MIN);
        EXPECT_LE(abs(Rational(x) - exact), Rational(2 * measure_error) * reach + rounding)
            << "axis " << k << ", area " << area;
    }
}

// Compares coordinate i of a centroid with the exact one of the cell of a point.
inline void compare_centroid(double x, const exact_cells::Rational& of_point,
                             const exact_cells::Cell& exact, std::size_t i) {
    using exact_cells::Rational;
    const Rational error = Rational(measure_error) * exact.volume * exact.reach;
    if (std::isinf(x)) {
        EXPECT_GE(abs(of_point * exact.volume + exact.moment[i]) + error,
                  Rational(DBL_MAX) * exact.volume);
        return;
    }
    // The coordinate itself is rounded.
    const Rational rounding =
        std::max(Rational(0x1p-52) * abs(Rational(x)), Rational(std::ldexp(1, -1074)));
    EXPECT_LE(abs((Rational(x) - of_point) * exact.volume - exact.moment[i]),
              error + rounding * exact.volume);
}

// Compares cell k with the exact one; `far` is more than the distance of any corner of a bounded
// cell.
inline void compare_cell_of_diagram(const VoronoiDiagram& d, const std::vector<double>& xyz,
                                    std::size_t k, const std::vector<exact_cells::HalfSpace>& all,
                                    const exact_cells::Cell& exact,
                                    const exact_cells::Rational& far) {
    using exact_cells::Rational;
    using exact_cells::V;
    const V origin = {xyz[3 * k], xyz[3 * k + 1], xyz[3 * k + 2]};
    EXPECT_EQ(d.cell_begin[k + 1] - d.cell_begin[k], static_cast<std::size_t>(exact.faces));
    const bool is_bounded = exact.reach <= far;
    EXPECT_EQ(d.is_bounded[k], is_bounded ? 1 : 0);
    if (is_bounded && exact.volume < Rational(DBL_MAX)) {
        EXPECT_LE(abs(Rational(d.volumes[k]) - exact.volume),
                  std::max(Rational(measure_error) * exact.volume, Rational(DBL_MIN)));
        for (std::size_t i = 0; i < 3; ++i)
            compare_centroid(d.cell_centroids[3 * k + i], origin[i], exact, i);
    }
    for (std::size_t j = 0; j < all.size(); ++j) {
        const std::size_t sites = xyz.size() / 3 - 1;
        const auto other = static_cast<std::uint32_t>(
            j < sites ? j + (j >= k ? 1 : 0) : VoronoiDiagram::plane | (j - sites));
        SCOPED_TRACE(testing::Message() << "side " << other);
        const std::size_t f = face_with_side(d, k, other);
        if (f == d.face_count()) continue;
        const std::vector<V> polygon = exact_cells::face(all, j, far);
        Rational doubled = 0, reach = 0;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            doubled += exact_cells::dot(
                all[j].normal, exact_cells::cross(polygon[i], polygon[(i + 1) % polygon.size()]));
            for (const Rational& x : polygon[i]) reach = std::max(reach, Rational(abs(x)));
        }
        EXPECT_GT(doubled, 0);
        if (reach > far) {
            EXPECT_TRUE(std::isinf(d.areas[f]));
            continue;
        }
        const bool is_turned = d.face_sides[2 * f] != k;
        compare_corners(d, f, is_turned, polygon, origin);
        compare_measures(d, f, polygon, all[j].normal, doubled, reach, j < sites, origin);
    }
}

}  // namespace mgdt
