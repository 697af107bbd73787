// SPDX-License-Identifier: MIT
#include "voronoi/diagram.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/differences.hpp"
#include "predicates/twofold.hpp"

namespace mgdt {

void write_unit_vector(const double (&way)[3], double* out) {
    const double largest = exact::largest_of<0, 3>(way);
    const int shift = -std::ilogb(largest);
    double x[3], squares = 0;
    for (int k = 0; k < 3; ++k) {
        x[k] = std::ldexp(way[k], shift);
        squares += x[k] * x[k];
    }
    for (int k = 0; k < 3; ++k) out[k] = x[k] / std::sqrt(squares);
}

double length_in_range(const double (&way)[3]) {
    const double largest = exact::largest_of<0, 3>(way);
    if (!(largest > 0) || std::isinf(largest)) return largest;
    const int exponent = std::ilogb(largest);
    double squares = 0;
    for (const double of : way) {
        const double x = std::ldexp(of, -exponent);
        squares += x * x;
    }
    return std::ldexp(std::sqrt(squares), exponent);
}

void make_empty(std::size_t points, VoronoiDiagram& d) {
    d.points.resize(3 * points, 0.0);
    d.face_begin.resize(1, std::uint64_t{0});
    d.cell_begin.resize(points + 1, std::uint64_t{0});
    d.is_bounded.resize(points, std::uint8_t{0});
    d.volumes.resize(points, 0.0);
    d.cell_centroids.resize(3 * points, 0.0);
}

namespace {

double distance_of_points(const double* a, const double* b) {
    double way[3];
    for (int k = 0; k < 3; ++k) way[k] = b[k] - a[k];
    if (std::isfinite(way[0] + way[1] + way[2])) return length_in_range(way);
    // Halves do not overflow.
    for (int k = 0; k < 3; ++k) way[k] = 0.5 * b[k] - 0.5 * a[k];
    return 2 * length_in_range(way);
}

// The distance of a point from the plane a x + b y + c z = d, which is not on the other side.
double distance_from_plane(const double* point, const double* plane) {
    const double normal[3] = {plane[0], plane[1], plane[2]};
    const int of_normal = std::ilogb(exact::largest_of<0, 3>(normal));
    // Brings the largest coordinate of the normal and the largest of the other terms near to 1.
    const double offset = std::ldexp(plane[3], -of_normal);
    const double terms[4] = {point[0], point[1], point[2], offset};
    double largest = 0, unit[3];
    for (const double x : terms) largest = std::max(largest, std::fabs(x));
    if (!(largest > 0) || std::isinf(largest)) return largest;
    const int of_terms = std::ilogb(largest);
    Twofold sum = {std::ldexp(offset, -of_terms), 0};
    for (int k = 0; k < 3; ++k) {
        unit[k] = std::ldexp(normal[k], -of_normal);
        sum = sum - Twofold::product(unit[k], std::ldexp(point[k], -of_terms));
    }
    const double height = std::fabs(sum.high + sum.low);
    return std::ldexp(height / length_in_range(unit), of_terms);
}

}  // namespace

void write_distances(const VoronoiDiagram& d, double* out) {
    for (std::size_t cell = 0; cell < d.cell_count(); ++cell) {
        const double* const point = d.points.begin() + 3 * cell;
        for (std::uint64_t i = d.cell_begin[cell]; i < d.cell_begin[cell + 1]; ++i) {
            const std::size_t face = d.cell_faces[i];
            const std::uint32_t* const sides = d.face_sides.begin() + 2 * face;
            const std::uint32_t other = sides[0] == cell ? sides[1] : sides[0];
            if (!d.face_distances.empty())
                *out++ = d.face_distances[face];
            else if (is_plane(other))
                *out++ = distance_from_plane(
                    point, d.planes.begin() + 4 * std::size_t{other & ~VoronoiDiagram::plane});
            else
                *out++ = distance_of_points(point, d.points.begin() + 3 * std::size_t{other});
        }
    }
}

void write_normals(const VoronoiDiagram& d, double* out) {
    if (!d.face_normals.empty()) {
        std::copy_n(d.face_normals.begin(), d.face_normals.size(), out);
        return;
    }
    for (std::size_t f = 0; f < d.face_count(); ++f) {
        const std::uint32_t other = d.face_sides[2 * f + 1];
        double way[3];
        if (is_plane(other)) {
            std::copy_n(d.planes.begin() + 4 * std::size_t{other & ~VoronoiDiagram::plane}, 3, way);
        } else {
            const double *const a = d.points.begin() + 3 * std::size_t{d.face_sides[2 * f]},
                                *const b = d.points.begin() + 3 * std::size_t{other};
            // Halves do not overflow.
            for (int k = 0; k < 3; ++k) {
                way[k] = b[k] - a[k];
                if (std::isinf(way[k])) {
                    for (int i = 0; i < 3; ++i) way[i] = 0.5 * b[i] - 0.5 * a[i];
                    break;
                }
            }
        }
        write_unit_vector(way, out + 3 * f);
    }
}

void drop_small_faces(VoronoiDiagram& d, double area, double relative) {
    const std::size_t cells = d.cell_count(), faces = d.face_count();
    Allocator& allocator = d.areas.allocator();
    // `relative` times the area of the bounded faces of each cell. The products do not overflow.
    Buffer<double> share(allocator);
    share.resize(cells, 0.0);
    for (std::size_t c = 0; c < cells; ++c) {
        for (std::uint64_t i = d.cell_begin[c]; i < d.cell_begin[c + 1]; ++i) {
            const double of_face = d.areas[d.cell_faces[i]];
            if (std::isfinite(of_face)) share[c] += relative * of_face;
        }
    }
    const auto least = [&](std::uint32_t a, std::uint32_t b) {
        return std::max(area, is_plane(b) ? share[a] : std::min(share[a], share[b]));
    };
    // The new number of each face.
    constexpr std::uint32_t dropped = 0xFFFFFFFFu;
    Buffer<std::uint32_t> number(allocator);
    number.resize(faces, dropped);
    std::uint32_t kept = 0;
    for (std::size_t f = 0; f < faces; ++f) {
        const std::uint32_t a = d.face_sides[2 * f], b = d.face_sides[2 * f + 1];
        if (d.areas[f] < least(a, b)) continue;
        number[f] = kept++;
    }
    // Nothing is allocated from here on.
    std::uint64_t corners = 0;
    for (std::size_t f = 0; f < faces; ++f) {
        const std::uint64_t begin = d.face_begin[f], end = d.face_begin[f + 1];
        if (number[f] == dropped) continue;
        const std::size_t to = number[f];
        std::copy(d.face_corners.begin() + begin, d.face_corners.begin() + end,
                  d.face_corners.begin() + corners);
        d.face_begin[to] = corners;
        corners += end - begin;
        std::copy_n(d.face_sides.begin() + 2 * f, 2, d.face_sides.begin() + 2 * to);
        d.areas[to] = d.areas[f];
        std::copy_n(d.face_centroids.begin() + 3 * f, 3, d.face_centroids.begin() + 3 * to);
        if (d.face_shifts.empty()) continue;
        std::copy_n(d.face_shifts.begin() + 3 * f, 3, d.face_shifts.begin() + 3 * to);
        std::copy_n(d.face_normals.begin() + 3 * f, 3, d.face_normals.begin() + 3 * to);
        d.face_distances[to] = d.face_distances[f];
    }
    d.face_begin[kept] = corners;
    std::uint64_t listed = 0;
    for (std::size_t c = 0; c < cells; ++c) {
        const std::uint64_t begin = d.cell_begin[c], end = d.cell_begin[c + 1];
        d.cell_begin[c] = listed;
        for (std::uint64_t i = begin; i < end; ++i)
            if (number[d.cell_faces[i]] != dropped)
                d.cell_faces[listed++] = number[d.cell_faces[i]];
    }
    d.cell_begin[cells] = listed;
    d.face_begin.resize(kept + std::size_t{1});
    d.face_corners.resize(static_cast<std::size_t>(corners));
    d.face_sides.resize(2 * std::size_t{kept});
    d.areas.resize(kept);
    d.face_centroids.resize(3 * std::size_t{kept});
    if (!d.face_shifts.empty()) {
        d.face_shifts.resize(3 * std::size_t{kept});
        d.face_normals.resize(3 * std::size_t{kept});
        d.face_distances.resize(kept);
    }
    d.cell_faces.resize(static_cast<std::size_t>(listed));
}

}  // namespace mgdt
