// SPDX-License-Identifier: MIT
// What a missing segment or triangle of the boundary crosses: recovery makes the number of these
// crossings fall to zero.
#pragma once

#include "mesh/bounding_box.hpp"
#include "platform/hash.hpp"
#include "platform/no_index.hpp"
#include "predicates/predicates.hpp"
#include "recovery/flip_mesh.hpp"

namespace mgdt {

// Counts how often the faces and edges of tetrahedra are crossed by what is missing: a segment
// between two vertices, or the inside of a triangle whose edges are edges of the mesh.
class Crossings {
  public:
    static Crossings of_segment(const FlipMesh& mesh, std::uint32_t a, std::uint32_t b) noexcept {
        return {mesh, a, b, no_index};
    }
    static Crossings of_triangle(const FlipMesh& mesh, const std::uint32_t (&v)[3]) noexcept {
        return {mesh, v[0], v[1], v[2]};
    }

    // Nothing is missing, and nothing is crossed.
    static Crossings of_nothing(const FlipMesh& mesh) noexcept {
        return {mesh, no_index, no_index, no_index};
    }

    // A hash of what is missing.
    std::uint64_t hash() const noexcept { return mixed(mixed(mixed(0, a_), b_), c_); }

    // What the edge that is missing itself counts for: less than nothing, so that it is preferred.
    static constexpr int found = -1000;

    // 1 if the edge is crossed in a point between its ends, which is not an end of the segment or a
    // point of the triangle's border; `found` if it is the segment; otherwise 0.
    int of_edge(std::uint32_t u, std::uint32_t v) const noexcept;
    // 1 if the segment crosses the inside of a face. Crossings of a face by a triangle do not
    // count: they end at edges that are crossed.
    int of_face(std::uint32_t u, std::uint32_t v, std::uint32_t w) const noexcept;
    // The sum of of_face() for the faces of p and q with each of several vertices.
    int of_faces(std::uint32_t p, std::uint32_t q, const Buffer<std::uint32_t>& vertices) const;

  private:
    // For a segment: on which side of the edge from u to v it passes. It crosses a face only if it
    // passes all edges around the face on one side, which is not 0.
    int side(std::uint32_t u, std::uint32_t v) const noexcept {
        return is_corner(u) || is_corner(v) ? 0
                                            : orientation(point(a_), point(b_), point(u), point(v));
    }
    // 1 if the ends of the segment are on different sides of a face.
    int of_plane(std::uint32_t u, std::uint32_t v, std::uint32_t w) const noexcept;
    // Whether faces count, as they do for a segment.
    bool count_faces() const noexcept { return a_ != no_index && c_ == no_index; }
    Crossings(const FlipMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
        : mesh_(mesh), a_(a), b_(b), c_(c), box_(BoundingBox::empty()) {
        for (const std::uint32_t v : {a, b, c})
            if (v != no_index) box_.include(mesh.point(v));
    }
    const double* point(std::uint32_t v) const noexcept { return mesh_.point(v); }
    bool is_corner(std::uint32_t v) const noexcept { return v == a_ || v == b_ || v == c_; }

    const FlipMesh& mesh_;
    std::uint32_t a_, b_, c_;  // c_ is no_index for a segment, all are for nothing
    BoundingBox box_;
};

}  // namespace mgdt
