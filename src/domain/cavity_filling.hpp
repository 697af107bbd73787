// SPDX-License-Identifier: MIT
// Fills the part of a mesh that a facet crosses, on each side of the facet.
#pragma once

#include "boundary/boundary.hpp"
#include "domain/facet_walk.hpp"
#include "domain/open_faces.hpp"
#include "domain/vertex_triangulation.hpp"

namespace mgdt {

class CavityFilling {
  public:
    CavityFilling(ConstrainedMesh& mesh, Allocator& allocator, const StopRequest& stop)
        : mesh_(mesh),
          stop_(stop),
          boundary_(allocator),
          open_(allocator),
          foreign_(allocator),
          corners_(allocator),
          candidates_(allocator),
          inner_(allocator),
          two_sided_(allocator),
          delaunay_(allocator) {}

    // Replaces the tetrahedra of a cavity: tetrahedra that a facet crosses, and that are connected
    // by faces which it crosses. The list is sorted. The new tetrahedra are the constrained
    // Delaunay triangulation of the vertices of the cavity that contains the facet. Marks the new
    // faces that are parts of the facet.
    void replace(FacetWalk& facet, std::uint32_t number, const Buffer<std::uint32_t>& crossed);

  private:
    using Face = OpenFaces::Face;
    // Stands for what is behind a face that is a part of a facet and has the cavity on both sides.
    static constexpr std::uint32_t inside = 0xFFFFFFFEu;
    // Up to this many vertices on one side, each of them is tried as an apex. With more, their
    // Delaunay triangulation proposes tetrahedra.
    static constexpr std::size_t few_candidates = 48;

    // A face of the boundary of the cavity, and the side of the facet on which it is.
    struct BoundaryFace {
        Face face;
        bool is_above;
    };
    // A face that is a part of a facet, and its code in the new tetrahedron on one side.
    struct TwoSidedFace {
        std::uint32_t v[3];  // the corners in ascending order
        std::uint32_t code, facet;
        friend bool operator<(const TwoSidedFace& a, const TwoSidedFace& b) {
            return std::lexicographical_compare(a.v, a.v + 3, b.v, b.v + 3);
        }
    };

    Face make_face(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t behind,
                   std::uint32_t facet) const;
    void collect(FacetWalk& facet, const Buffer<std::uint32_t>& crossed);
    void fill(FacetWalk& facet, std::uint32_t number, bool above);
    void open(const Face& face);
    std::uint32_t choose_apex(const Face& face);
    bool fits(const Face& face, std::uint32_t apex, bool is_delaunay) const;
    bool crosses(const std::uint32_t (&v)[3], const BoundingBox& box, const Face& other) const;
    void add_tetrahedron(FacetWalk& facet, std::uint32_t number, const Face& face,
                         std::uint32_t apex);
    void close(std::uint32_t code, const Face& open);
    void add_two_sided(const std::uint32_t (&v)[3], std::uint32_t code, std::uint32_t facet);
    void join_sides();
    Simplex triangle(const std::uint32_t (&v)[3]) const;

    ConstrainedMesh& mesh_;
    const StopRequest stop_;
    Buffer<BoundaryFace> boundary_;
    OpenFaces open_;
    Buffer<std::uint32_t> foreign_;  // open faces that are not in the Delaunay triangulation
    Buffer<std::uint32_t> corners_, candidates_, inner_;
    Buffer<TwoSidedFace> two_sided_;  // each face twice, from both sides
    VertexTriangulation delaunay_;    // of the candidates, if there are many
    bool has_delaunay_ = false;
};

}  // namespace mgdt
