// SPDX-License-Identifier: MIT
#include "dual/cell.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "predicates/circumcenter.hpp"

namespace mgdt {

void Cell::make(const Mesh& mesh, VertexId v, const Link& link, Centers centers) {
    set_sides(mesh, v, link);
    radius_ = 0;
    corners_.resize(link.triangles().size());
    for (std::size_t i = 0; i < corners_.size(); ++i) set_corner(mesh, v, link, i, centers);
}

void Cell::set_sides(const Mesh& mesh, VertexId v, const Link& link) {
    const double* const origin = mesh.point(v);
    const std::size_t n = link.neighbor_count();
    sides_.resize(n);
    indices_.resize(n);
    is_bounded_ = true;
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Vertex& neighbor = mesh.vertices[link.neighbor(i)];
        indices_[i] = neighbor.index;
        if (link.neighbor(i) == infinite_vertex) {
            is_bounded_ = false;
            continue;
        }
        sides_[i].normal = difference<double>(neighbor.x, origin);
        for (const double x : sides_[i].normal.x) largest = std::max(largest, std::fabs(x));
    }
    is_ordinary_ = largest <= std::numeric_limits<double>::max();
    factor_ = !is_ordinary_                             ? 0x1p-1022
              : largest < 0x1p-100 || largest > 0x1p100 ? std::ldexp(1.0, -std::ilogb(largest))
                                                        : 1;
    for (std::size_t i = 0; i < n; ++i) {
        if (link.neighbor(i) == infinite_vertex) continue;
        Side& side = sides_[i];
        if (factor_ != 1)
            for (double& x : side.normal.x) x = scaled_by(x, factor_);
        side.offset = scaled_by(dot(side.normal, side.normal), 0.5);
        side.size = std::sqrt(2 * side.offset);
        side.error = 5 * rounding_of<double> * side.offset;
        is_ordinary_ &= side.size > 0x1p-250;
    }
}

// Sets `at` to the cyclic order that begins at the neighbour with the least index, so that the
// result does not depend on the order of the records.
inline void turn(unsigned (&at)[3], const std::uint32_t (&index)[3]) {
    at[0] = index[1] < index[0] ? (index[2] < index[1] ? 2 : 1) : (index[2] < index[0] ? 2 : 0);
    at[1] = at[0] == 2 ? 0 : at[0] + 1;
    at[2] = at[1] == 2 ? 0 : at[1] + 1;
}

bool Cell::set_plain_center(const LinkTriangle& triangle, Corner& corner) const {
    unsigned at[3];
    turn(at, {indices_[triangle.corner[0]], indices_[triangle.corner[1]],
              indices_[triangle.corner[2]]});
    return meet(sides_[triangle.corner[at[0]]], sides_[triangle.corner[at[1]]],
                sides_[triangle.corner[at[2]]], corner);
}

void Cell::set_corner(const Mesh& mesh, VertexId v, const Link& link, std::size_t i,
                      Centers centers) {
    constexpr double u = rounding_of<double>;
    const LinkTriangle& triangle = link.triangles()[i];
    Corner& corner = corners_[i];
    VertexId vertex[3];
    for (unsigned k = 0; k < 3; ++k) vertex[k] = link.neighbor(triangle.corner[k]);
    unsigned ghost = 3;
    if (!is_bounded_)
        for (unsigned k = 0; k < 3; ++k)
            if (vertex[k] == infinite_vertex) ghost = k;
    corner.is_ideal = ghost < 3;
    if (corner.is_ideal) {
        // The corner is the outward normal of the hull facet, which contains the other two
        // neighbours.
        const Side &p = sides_[triangle.corner[ghost == 2 ? 0 : ghost + 1]],
                   &q = sides_[triangle.corner[ghost == 0 ? 2 : ghost - 1]];
        corner.x = cross(p.normal, q.normal);
        corner.size = length(corner.x);
        corner.error = 8 * u * p.size * q.size;
        return;
    }
    if (centers == Centers::corrected || !set_plain_center(triangle, corner)) {
        unsigned at[3];
        turn(at, {indices_[triangle.corner[0]], indices_[triangle.corner[1]],
                  indices_[triangle.corner[2]]});
        double offset[3];
        center_offset({mesh.point(v), mesh.point(vertex[at[0]]), mesh.point(vertex[at[1]]),
                       mesh.point(vertex[at[2]])},
                      offset);
        for (int k = 0; k < 3; ++k) {
            constexpr double most = 0x1p300;
            corner.x.x[k] = std::max(-most, std::min(most, offset[k] * factor_));
        }
        corner.size = length(corner.x);
        // The error is infinite if the corner is too far away for doubles.
        corner.error = corner.size < 0x1p299 ? 2 * center_offset_error * corner.size
                                             : std::numeric_limits<double>::infinity();
    }
    radius_ = std::max(radius_, corner.size);
}

}  // namespace mgdt
