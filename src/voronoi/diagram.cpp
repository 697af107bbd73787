// SPDX-License-Identifier: MIT
#include "voronoi/diagram.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/differences.hpp"

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

void make_empty(std::size_t points, VoronoiDiagram& d) {
    d.points.resize(3 * points, 0.0);
    d.face_begin.resize(1, std::uint64_t{0});
    d.cell_begin.resize(points + 1, std::uint64_t{0});
    d.is_bounded.resize(points, std::uint8_t{0});
    d.volumes.resize(points, 0.0);
    d.cell_centroids.resize(3 * points, 0.0);
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
        if (d.face_images.empty()) continue;
        std::copy_n(d.face_images.begin() + 3 * f, 3, d.face_images.begin() + 3 * to);
        std::copy_n(d.face_normals.begin() + 3 * f, 3, d.face_normals.begin() + 3 * to);
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
    if (!d.face_images.empty()) {
        d.face_images.resize(3 * std::size_t{kept});
        d.face_normals.resize(3 * std::size_t{kept});
    }
    d.cell_faces.resize(static_cast<std::size_t>(listed));
}

}  // namespace mgdt
