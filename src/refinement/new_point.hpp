// SPDX-License-Identifier: MIT
// A point that refinement may insert.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "refinement/refined_mesh.hpp"

namespace mgdt {

struct NewPoint {
    double x[3];
    double size;           // of edges at the point, as the caller wants it
    double interpolated;   // the part of it that is between those of vertices
    double spacing;        // of the mesh that was given, see RefinedMesh
    double nearest2 = 16;  // the square of the distance from the nearest vertex of the cavity
    double least2;         // the square of the least distance from a vertex
    double from_wall2;     // and of a distance from a wall below which the star has to be a gain
    TetId start;           // a tetrahedron in conflict with the point
    bool is_on_lattice;
    bool is_last;  // whether no other point is tried if this one is refused

    // Lowers the size as the vertices of the cavity want, and finds what else depends on them:
    // vertex_of(i) for i from 0 to count - 1.
    template <class VertexOf>
    void find_size(const RefinedMesh& mesh, std::uint32_t count,
                   const VertexOf& vertex_of) noexcept {
        nearest2 = 16;
        for (std::uint32_t i = 0; i < count; ++i) {
            const VertexId v = vertex_of(i);
            const double d2 = squared_distance(mesh, v), there = mesh.sizes[v];
            nearest2 = std::min(nearest2, d2);
            if (there < size) size = std::min(size, there + mesh.gradation * std::sqrt(d2));
        }
        if (!mesh.interpolated.empty()) interpolate_size(mesh, count, vertex_of);
        if (!mesh.spacings.empty()) find_spacing(mesh, count, vertex_of);
    }

  private:
    double squared_distance(const RefinedMesh& mesh, VertexId v) const noexcept {
        const Vector<double> d = difference<double>(mesh.walled.point(v), x);
        return dot(d, d);
    }
    // Interpolates between the sizes of vertices, as the gradation allows.
    template <class VertexOf>
    void interpolate_size(const RefinedMesh& mesh, std::uint32_t count,
                          const VertexOf& vertex_of) noexcept {
        double weight = 0, sum = 0;
        double least = 0, most = std::numeric_limits<double>::infinity(), lowest = most,
               highest = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const VertexId v = vertex_of(i);
            const double d2 = squared_distance(mesh, v), there = mesh.interpolated[v];
            const double part = 1 / (d2 + 0x1p-200), change = mesh.gradation * std::sqrt(d2);
            weight += part;
            sum += part * there;
            lowest = std::min(lowest, there);
            highest = std::max(highest, there);
            least = std::max(least, there - change);
            most = std::min(most, there + change);
        }
        // Equal sizes stay as they are, whatever rounding does to their mean.
        const double mean = std::min(std::max(sum / weight, lowest), highest);
        interpolated = std::min(most, std::max(least, mean));
        size = std::min(size, interpolated);
    }
    template <class VertexOf>
    void find_spacing(const RefinedMesh& mesh, std::uint32_t count,
                      const VertexOf& vertex_of) noexcept {
        constexpr double growth = 0.5;
        spacing = std::numeric_limits<double>::infinity();
        for (std::uint32_t i = 0; i < count; ++i) {
            const VertexId v = vertex_of(i);
            spacing =
                std::min(spacing, mesh.spacings[v] + growth * std::sqrt(squared_distance(mesh, v)));
        }
    }
};

}  // namespace mgdt
