// SPDX-License-Identifier: MIT
// Fills the part of a mesh that a facet crosses, on each side of the facet.
#pragma once

#include "domain/box_tree.hpp"
#include "domain/facet_walk.hpp"
#include "domain/simplex_pair.hpp"

namespace mgdt {

class CavityFilling {
  public:
    CavityFilling(ConstrainedMesh& mesh, Allocator& allocator)
        : mesh_(mesh),
          boundary_(allocator),
          open_(allocator),
          corners_(allocator),
          candidates_(allocator),
          crossed_(allocator),
          two_sided_(allocator) {}

    // Replaces tetrahedra that a facet crosses and that are connected by faces which it crosses:
    // the constrained Delaunay triangulation of their vertices that has the facet. Marks the faces
    // that are now parts of it.
    void replace(FacetWalk& facet, std::uint32_t number, const Buffer<std::uint32_t>& crossed);

  private:
    // What is behind a face that is a part of a facet and has the cavity on both sides.
    static constexpr std::uint32_t inside = 0xFFFFFFFEu;

    // A face of the cavity, or of the part that is not filled yet. A point inside of that part and
    // the corners are positively oriented: (v[0], v[1], v[2], point).
    struct Face {
        std::uint32_t v[3];
        std::uint32_t behind;  // the code of the face on the other side, no_face, or `inside`
        std::uint32_t facet;   // the facet that the face is a part of, or no_facet
        bool is_above;
        BoundingBox box;
    };

    Face make_face(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t behind,
                   std::uint32_t facet, bool is_above) const;
    void collect(FacetWalk& facet, const Buffer<std::uint32_t>& crossed);
    void fill(FacetWalk& facet, std::uint32_t number, bool above);
    std::uint32_t choose_apex(const Face& face);
    bool fits(const Face& face, std::uint32_t apex) const;
    bool crosses_open_face(const std::uint32_t (&v)[3], const Face& base) const;
    void add_tetrahedron(FacetWalk& facet, std::uint32_t number, const Face& face,
                         std::uint32_t apex);
    void close(std::uint32_t code, const Face& open);
    void join_sides();
    Simplex triangle(const std::uint32_t (&v)[3]) const;

    ConstrainedMesh& mesh_;
    Buffer<Face> boundary_, open_;
    Buffer<std::uint32_t> corners_, candidates_;
    Buffer<std::uint32_t> crossed_;  // the tetrahedra that are replaced, sorted
    // Faces that are parts of facets: `behind` is the code in the new tetrahedron on one side. The
    // list has each of them twice, from both sides.
    Buffer<Face> two_sided_;
};

}  // namespace mgdt
