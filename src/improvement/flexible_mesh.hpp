// SPDX-License-Identifier: MIT
// A mesh in the form in which improvement changes it.
#pragma once

#include "improvement/change.hpp"
#include "improvement/kept_edges.hpp"
#include "improvement/vertex_class.hpp"
#include "solid/linked_tetrahedra.hpp"
#include "solid/solid_mesh.hpp"
#include "solid/sorted_corners.hpp"

namespace mgdt {

class FlexibleMesh : public LinkedTetrahedra {
  public:
    // Names the facet that a face is a part of, and a side of the face. It is twice the label of
    // the facet if the corners of the facet appear counter-clockwise from that side, and one more
    // otherwise.
    using Side = std::uint32_t;
    static constexpr std::uint32_t label_of(Side side) noexcept { return side / 2; }

    FlexibleMesh(const SolidMesh& from, Team& team, Allocator& allocator);

    Allocator& allocator() const noexcept { return allocator_; }
    const double* point(std::uint32_t v) const noexcept { return x.begin() + 3 * std::size_t{v}; }
    double quality(const std::uint32_t (&v)[4]) const noexcept {
        return quality_of(v[0], v[1], v[2], v[3]);
    }
    double quality_of(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                      std::uint32_t d) const noexcept;

    // Whether a point that moves can be written: subnormal coordinates would be rounded too much.
    bool can_move() const noexcept { return scale_ > -900; }

    // Applies a change. Returns false, and changes nothing, if the new tetrahedra do not have the
    // same outer faces as those that they replace. Faces of facets may differ, also where the mesh
    // ends: the change names those that come, and says how many are lost.
    bool apply(Change& change);

    // Writes the points, and tetrahedra and faces, sorted as those of a domain's mesh are. `to` is
    // the mesh from which this one was made; what else it has stays. If memory runs out, it stays
    // as it was.
    void write(SolidMesh& to) const;
    // The same, into an empty mesh; `from` is the mesh from which this one was made. `number`
    // receives the number that the tetrahedron in each slot has there, or no_index.
    void write(const SolidMesh& from, SolidMesh& made, Buffer<std::uint32_t>& number) const;

    // Changes and moves belong to rounds, which are numbered from 1. The caller begins each.
    std::uint32_t round = 0;
    // Says that the tetrahedra at a vertex have changed in this round.
    void note_change(std::uint32_t v) noexcept { last_change[v] = round; }

    // For tetrahedra, beside the links.
    Buffer<std::uint32_t> regions;
    Buffer<double> qualities;

    Buffer<double> x;  // coordinates times a power of two, so that the largest one is about 1
    Buffer<VertexClass> classes;        // of vertices: all fixed until classify_vertices()
    Buffer<std::uint8_t> is_lost;       // whether a vertex has left the mesh
    Buffer<std::uint32_t> star_sizes;   // the number of tetrahedra at each vertex
    Buffer<std::uint32_t> last_change;  // the round in which tetrahedra at a vertex changed, or 0
    KeptEdges edges;

    struct Label {
        std::uint32_t facet;
        std::int32_t marker;
    };
    Buffer<Label> labels;

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
    void read_tetrahedron(const SolidMesh& from, std::size_t t) noexcept;
    void read_faces(const SolidMesh& from);
    void write_tetrahedra(Buffer<std::uint32_t>& number, SolidMesh& made) const;
    void write_faces(const Buffer<std::uint32_t>& number, const SolidMesh& before,
                     SolidMesh& made) const;
    void write_points(const SolidMesh& before, SolidMesh& made) const;
    void write_edges(SolidMesh& made) const;

    // A link of a new tetrahedron: the code of another new one, or of what is outside.
    struct Link {
        std::uint32_t code;
        bool is_new;
        Side side;
    };
    Team& team_;
    Allocator& allocator_;
    int scale_ = 0;  // x is the coordinates times 2^-scale_
    Buffer<Face> faces_;
    Buffer<Link> links_;
    Buffer<std::uint32_t> slots_;
    std::size_t inner_sides_ = 0;  // of faces of facets between tetrahedra that leave
    Buffer<std::uint8_t> leaves_;  // marks the tetrahedra that leave
};

}  // namespace mgdt
