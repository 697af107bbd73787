// SPDX-License-Identifier: MIT
// The faces that one thread has found, before they are sorted and their corners are numbered.
#pragma once

#include "platform/error.hpp"
#include "voronoi/diagram.hpp"
#include "voronoi/face_measure.hpp"

namespace mgdt {

// Flags of a corner. cut_corner: the corner is no circumcentre, but at the region. ghost_corner:
// the corner is the ray of a ghost. The slots of tetrahedra are smaller than both flags.
inline constexpr std::uint32_t cut_corner = 1u << 30, ghost_corner = 1u << 31;

// A face, and the pyramid whose base it is and whose apex is its first point.
struct FoundFace {
    std::uint32_t sides[2];       // the caller's indices of the points; the second may be a plane
    double area;                  // without the mesh's scale
    Vector<double> centroid;      // relative to the first of the points, without the mesh's scale
    double centroid_error;        // with the mesh's scale
    double volume, volume_error;  // of the pyramid, times 3, with the mesh's scale

    void set_corners(std::size_t begin, std::size_t size) {
        constexpr std::size_t most = 1u << 24;
        if (size >= most) fail(MGDT_ERR_TOO_LARGE, "a face has more than %zu corners", most);
        corners_ = std::uint64_t{begin} << 24 | size;
    }
    std::size_t begin() const { return static_cast<std::size_t>(corners_ >> 24); }
    std::size_t size() const { return static_cast<std::size_t>(corners_ & 0xFFFFFFu); }
    void set_measure(const FaceMeasure& measure, const FacePlane& plane) {
        area = measure.unscaled_area;
        volume = measure.area * plane.distance;
        volume_error = measure.area_error * (std::fabs(plane.distance) + plane.distance_error) +
                       measure.area * plane.distance_error;
        centroid = measure.unscaled_centroid;
        centroid_error = measure.centroid_error;
    }

  private:
    std::uint64_t corners_;  // the position of the first corner, and 24 bits for their number
};

struct FoundFaces {
    explicit FoundFaces(Allocator& allocator) : faces(allocator), corners(allocator) {}

    // Makes room for the faces that tetrahedra of this number usually have. In most sets of points
    // there are 1.16 edges, and so faces, for each tetrahedron; all faces have 6 corners for each
    // tetrahedron.
    void make_room(std::size_t tetrahedra) {
        const std::size_t begin = faces.size(), first_corner = corners.size();
        faces.grow(begin + tetrahedra + tetrahedra / 4);
        faces.prefault(begin, begin + tetrahedra + tetrahedra / 8);
        corners.grow(first_corner + 6 * tetrahedra);
        corners.prefault(first_corner, first_corner + 6 * tetrahedra);
    }

    Buffer<FoundFace> faces;
    // The corners of all faces. A circumcentre is given by Circumcenters::first_equal(), a ray by
    // the slot of its ghost with the flag, and a cut corner by its number with the flag.
    Buffer<std::uint32_t> corners;
};

}  // namespace mgdt
