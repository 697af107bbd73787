// SPDX-License-Identifier: MIT
// A mesh in the form in which improvement changes it.
#pragma once

#include "improvement/change.hpp"
#include "improvement/vertex_class.hpp"
#include "solid/linked_mesh.hpp"
#include "solid/sorted_corners.hpp"

namespace mgdt {

class FlexibleMesh : public LinkedMesh {
  public:
    FlexibleMesh(const SolidMesh& from, Team& team, Allocator& allocator);

    double quality(const std::uint32_t (&v)[4]) const noexcept {
        return quality_of(v[0], v[1], v[2], v[3]);
    }
    double quality_of(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                      std::uint32_t d) const noexcept;

    // Applies a change. Returns false, and changes nothing, if the new tetrahedra do not have the
    // same outer faces as those that they replace. Faces of facets may differ, also where the mesh
    // ends: the change names those that come, and says how many are lost.
    bool apply(Change& change);

    // Changes and moves belong to rounds, which are numbered from 1. The caller begins each.
    std::uint32_t round = 0;
    // Says that the tetrahedra at a vertex have changed in this round.
    void note_change(std::uint32_t v) noexcept { last_change[v] = round; }

    Buffer<double> qualities;           // of tetrahedra
    Buffer<VertexClass> classes;        // of vertices: all fixed until classify_vertices()
    Buffer<std::uint32_t> star_sizes;   // the number of tetrahedra at each vertex
    Buffer<std::uint32_t> last_change;  // the round in which tetrahedra at a vertex changed, or 0

  private:
    // A face of a tetrahedron that leaves or comes. `corners.from` of a new face is 4 times the
    // number of the new tetrahedron plus the position, that of an outer face is the code behind it,
    // or no_index.
    struct Face {
        SortedCorners<3> corners;
        bool is_new;
        Side side;  // of an outer face, as the tetrahedron that leaves has it

        friend bool operator<(const Face& a, const Face& b) { return a.corners < b.corners; }
    };
    static Face make_face(const std::uint32_t (&v)[4], unsigned position) noexcept;
    void collect_faces(const Change& change);
    bool pair_faces(const Change& change);
    void add_vertex(Change& change);

    // A link of a new tetrahedron: the code of another new one, or of what is outside.
    struct Link {
        std::uint32_t code;
        bool is_new;
        Side side;
    };
    Buffer<Face> faces_;
    Buffer<Link> links_;
    Buffer<std::uint32_t> slots_;
    std::size_t inner_sides_ = 0;  // of faces of facets between tetrahedra that leave
    Buffer<std::uint8_t> leaves_;  // marks the tetrahedra that leave
};

}  // namespace mgdt
