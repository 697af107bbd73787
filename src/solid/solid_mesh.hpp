// SPDX-License-Identifier: MIT
// A mesh of tetrahedra, as the caller reads it.
#pragma once

#include "platform/no_index.hpp"
#include "solid/rounding_grid.hpp"

namespace mgdt {

struct SolidMesh {
    explicit SolidMesh(Allocator& allocator)
        : points(allocator),
          exact_points(allocator),
          point_origins(allocator),
          tetrahedra(allocator),
          neighbors(allocator),
          regions(allocator),
          region_markers(allocator),
          faces(allocator),
          face_tetrahedra(allocator),
          face_facets(allocator),
          face_markers(allocator),
          edges(allocator),
          edge_segments(allocator),
          edge_markers(allocator),
          steiner_edges(allocator),
          steiner_parameters(allocator),
          unused_points(allocator),
          unused_regions(allocator),
          unused_holes(allocator),
          unused_faces(allocator) {}

    std::size_t tetrahedron_count() const noexcept { return tetrahedra.size() / 4; }
    // The place of a Steiner point in the caller's coordinates: a + t (b - a), where a and b are
    // the caller's coordinates of the ends of its edge. `on_grid` is the point between the rounded
    // ends, in steps; if the ends are on the grid themselves, it is the result.
    static void place_on_segment(const double* a, const double* b, double t, const double* on_grid,
                                 const RoundingGrid& grid, double* x) noexcept;
    // 1 if a place is inside of a tetrahedron, 0 if it is on the boundary, -1 if it is outside. The
    // corners have their places in `coordinates`: `points`, or `exact_points` for a place in steps
    // of the grid.
    int side(const Buffer<double>& coordinates, std::uint32_t t, const double* x) const noexcept;

    // The caller's points come first, then the Steiner points.
    Buffer<double> points;
    Buffer<double> exact_points;  // those on the grid, in steps; or the points themselves
    Buffer<std::uint32_t>
        point_origins;                 // the caller's point, of equal ones the first; or `no_index`
    Buffer<std::uint32_t> tetrahedra;  // 4 corners, positively oriented
    Buffer<std::uint32_t> neighbors;   // 4: the one opposite each corner, or `no_index`
    Buffer<std::uint32_t> regions;     // of each tetrahedron
    Buffer<std::int32_t> region_markers;    // of each region
    Buffer<std::uint32_t> faces;            // 3 corners; oriented like the facet
    Buffer<std::uint32_t> face_tetrahedra;  // 2: the one that the normal points to, and the other
    Buffer<std::uint32_t> face_facets;      // the caller's facet
    Buffer<std::int32_t> face_markers;
    Buffer<std::uint32_t> edges;          // 2 ends of each edge that is a part of a segment
    Buffer<std::uint32_t> edge_segments;  // the caller's segment, or `no_index`
    Buffer<std::int32_t> edge_markers;
    Buffer<std::uint32_t> steiner_edges;  // for each Steiner point the 2 ends of its edge
    Buffer<double> steiner_parameters;    // and its parameter t on the edge
    // Whether a domain made the mesh and nothing has changed it since. Then it has all points of
    // the domain, and `exact_points` are on the grid.
    bool is_of_domain = true;
    bool is_delaunay = true;    // whether it is constrained Delaunay
    bool keeps_facets = false;  // whether each triangle of the domain's facets is one face
    bool is_rounded = false;    // whether the caller's points are rounded to the grid
    RoundingGrid grid{0.0, RoundingGrid::usual_bits};
    // What the caller has set and the mesh does not use, by the caller's numbers: points that are
    // no corner of a tetrahedron and are not equal to one, places of regions, and holes. Also the
    // faces that are at no tetrahedron, by their numbers in the mesh.
    Buffer<std::uint32_t> unused_points, unused_regions, unused_holes, unused_faces;
    // Counts of the build, for statistics.
    std::size_t planar_facets = 0, missing_facets = 0, cavities = 0, largest_cavity = 0;
};

}  // namespace mgdt
