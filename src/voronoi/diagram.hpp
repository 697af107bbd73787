// SPDX-License-Identifier: MIT
// A Voronoi diagram as arrays. It is a snapshot, which does not refer to the triangulation.
#pragma once

#include <cstdint>

#include "platform/memory.hpp"

namespace mgdt {

struct VoronoiDiagram {
    explicit VoronoiDiagram(Allocator& allocator)
        : points(allocator),
          planes(allocator),
          vertices(allocator),
          ray_vertices(allocator),
          ray_directions(allocator),
          face_begin(allocator),
          face_corners(allocator),
          face_sides(allocator),
          areas(allocator),
          face_centroids(allocator),
          face_shifts(allocator),
          face_normals(allocator),
          face_distances(allocator),
          cell_begin(allocator),
          cell_faces(allocator),
          is_bounded(allocator),
          volumes(allocator),
          cell_centroids(allocator) {}

    // A flag in face_corners: the entry is the number of a ray.
    static constexpr std::uint32_t ray = 0x80000000u;
    // A flag in face_sides: the entry is the number of a plane of the region.
    static constexpr std::uint32_t plane = 0x80000000u;

    std::size_t face_count() const noexcept { return areas.size(); }
    std::size_t cell_count() const noexcept { return is_bounded.size(); }

    Buffer<double> points;               // 3 for each point given
    Buffer<double> planes;               // 4 for each plane given
    Buffer<double> vertices;             // 3 for each vertex
    Buffer<std::uint32_t> ray_vertices;  // where each ray begins
    Buffer<double> ray_directions;       // 3 for each ray
    Buffer<std::uint64_t> face_begin;    // where the corners of each face begin, and the end
    // The corners of each face, counter-clockwise about the direction from the first side to the
    // second. The two rays of an unbounded face come last.
    Buffer<std::uint32_t> face_corners;
    Buffer<std::uint32_t> face_sides;  // the two points of each face, or a point and a plane
    Buffer<double> areas, face_centroids;
    // For points in a periodic box, otherwise empty. For each face: how many times each of the
    // caller's vectors has to be added to the second side to get its image at the face; the unit
    // normal; and the distance between the first side and that image.
    Buffer<std::int64_t> face_shifts;
    Buffer<double> face_normals, face_distances;
    Buffer<std::uint64_t> cell_begin;  // where the faces of each cell begin, and the end
    Buffer<std::uint32_t> cell_faces;
    Buffer<std::uint8_t> is_bounded;
    Buffer<double> volumes, cell_centroids;
};

// Whether a side of a face is a plane of the region.
inline bool is_plane(std::uint32_t side) noexcept {
    return (side & VoronoiDiagram::plane) != 0;
}

// Sets the arrays of a diagram without cells.
void make_empty(std::size_t points, VoronoiDiagram& diagram);
// Writes a vector divided by its length, whatever its magnitude.
void write_unit_vector(const double (&way)[3], double* out);
// The length of a vector. The squares of its coordinates may be outside of the range of doubles.
double length_in_range(const double (&way)[3]);
// Writes, for each face of each cell, the distance of the cell's point from the other side.
void write_distances(const VoronoiDiagram& diagram, double* out);
// Writes the unit normal of each face, from its first side to the second one.
void write_normals(const VoronoiDiagram& diagram, double* out);
// Removes the faces whose area is less than `area`. Removes also the faces whose area is, for each
// of their cells, less than `relative` times the total area of the bounded faces of the cell.
// Throws std::bad_alloc with nothing changed.
void drop_small_faces(VoronoiDiagram& diagram, double area, double relative);

}  // namespace mgdt
