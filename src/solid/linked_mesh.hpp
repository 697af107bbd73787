// SPDX-License-Identifier: MIT
// A mesh in the form in which it changes: linked tetrahedra with all that a solid mesh knows of
// them.
#pragma once

#include <cmath>

#include "parallel/team.hpp"
#include "solid/kept_edges.hpp"
#include "solid/linked_tetrahedra.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

class LinkedMesh : public LinkedTetrahedra {
  public:
    // Names the facet that a face is a part of, and a side of the face. It is twice the label of
    // the facet if the corners of the facet appear counter-clockwise from that side, and one more
    // otherwise. This is what `facets` of a tetrahedron has.
    using Side = std::uint32_t;
    static constexpr std::uint32_t label_of(Side side) noexcept { return side / 2; }

    LinkedMesh(const SolidMesh& from, Team& team, Allocator& allocator);

    Allocator& allocator() const noexcept { return allocator_; }
    const double* point(std::uint32_t v) const noexcept { return x.begin() + 3 * std::size_t{v}; }

    // Whether new places can be written: subnormal coordinates would be rounded too much.
    bool can_move() const noexcept { return scale_ > -900; }

    // What the caller's lengths are multiplied by in this mesh: a power of two, if can_move().
    double scale() const noexcept { return std::ldexp(1.0, -scale_); }

    // Writes the points, and tetrahedra and faces, sorted as those of a domain's mesh are. `to` is
    // the mesh from which this one was made; what else it has stays. If memory runs out, it stays
    // as it was.
    void write(SolidMesh& to) const;
    // The same, into an empty mesh; `from` is the mesh from which this one was made. `number`
    // receives the number that the tetrahedron in each slot has there, or no_index.
    void write(const SolidMesh& from, SolidMesh& made, Buffer<std::uint32_t>& number) const;

    Buffer<std::uint32_t> regions;  // of tetrahedra
    Buffer<double> x;  // coordinates times a power of two, so that the largest one is about 1
    Buffer<std::uint8_t> is_lost;  // whether a vertex has left the mesh
    KeptEdges edges;

    struct Label {
        std::uint32_t facet;
        std::int32_t marker;
    };
    Buffer<Label> labels;

  protected:
    Team& team_;

  private:
    void read_tetrahedron(const SolidMesh& from, std::size_t t) noexcept;
    void read_faces(const SolidMesh& from);
    void write_tetrahedra(Buffer<std::uint32_t>& number, SolidMesh& made) const;
    void write_faces(const Buffer<std::uint32_t>& number, const SolidMesh& before,
                     SolidMesh& made) const;
    void write_points(const SolidMesh& before, SolidMesh& made) const;
    void write_edges(SolidMesh& made) const;

    Allocator& allocator_;
    int scale_ = 0;  // x is the coordinates times 2^-scale_
};

}  // namespace mgdt
