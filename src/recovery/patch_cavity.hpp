// SPDX-License-Identifier: MIT
// A cavity around a patch of the boundary, of which two points see all faces.
#pragma once

#include <algorithm>

#include "recovery/boundary_patch.hpp"
#include "recovery/edge_ring.hpp"

namespace mgdt {

// The cavity begins with all tetrahedra that the patch crosses. The border of the patch divides the
// faces of the cavity in two sides. Wherever a new point of a side does not see a face of that
// side, the tetrahedron behind the face is taken in too. Then the point of each side is joined to
// the faces of the side and to the triangles of the patch.
class PatchCavity {
  public:
    // The edges `kept` stay, and so do the vertices before `first_added`.
    PatchCavity(FlipMesh& mesh, const PairTable& kept, std::uint32_t first_added,
                Allocator& allocator)
        : mesh_(mesh),
          kept_(kept),
          first_added_(first_added),
          ring_(allocator),
          tetrahedra_(allocator),
          is_inside_(allocator),
          side_of_(allocator),
          entries_(allocator),
          changes_(allocator),
          faces_(allocator),
          edges_(allocator),
          lost_(allocator),
          vanishing_(allocator) {}

    enum Side : std::uint8_t { neither, above, below };

    // Makes the cavity empty.
    void clear() noexcept;
    void take_in(std::uint32_t t);
    // Takes in the tetrahedra around an edge.
    void take_in_ring(std::uint32_t a, std::uint32_t b);
    // Takes in what the insides of the triangles of a patch cross, and finds the two sides. What
    // the edges of the patch cross has to be in the cavity already. Returns false if the border of
    // the patch does not divide the faces of the cavity in two sides.
    bool divide(const BoundaryPatch& patch);
    // Takes in tetrahedra until a point sees all faces of a side. Returns false, with the cavity as
    // it was, if it would reach a face of the other side or the hull of the mesh, if it would
    // become too large, or if it would lose something.
    bool grow(Side side, std::uint32_t point, const BoundaryPatch& patch);
    // Whether all that stays is at the faces of the cavity or in the patch. Finds what is lost()
    // and vanishing() otherwise.
    bool loses_nothing(const BoundaryPatch& patch);
    // The edges that stay but were neither at the faces nor in the patch, and those of such
    // triangles.
    const PairTable& lost() const noexcept { return lost_; }
    void forget_lost() { lost_.clear(); }
    // Collects the vertices of the faces of a side.
    void collect_vertices(Side side, Buffer<std::uint32_t>& vertices) const;
    // Calls use(t) for the tetrahedra that join a point to the faces of a side which do not have
    // it, until one of these calls returns false. Returns whether none does.
    template <class Use>
    bool for_each_on_side(Side side, std::uint32_t point, const Use& use) const;

    const Buffer<std::uint32_t>& tetrahedra() const noexcept { return tetrahedra_; }
    // The vertices that are in no tetrahedron when the cavity has been filled.
    const Buffer<std::uint32_t>& vanishing() const noexcept { return vanishing_; }

  private:
    struct Change {
        std::uint32_t face;
        Side before;
    };

    bool is_inside(std::uint32_t face) const noexcept {
        return face != no_index && is_inside_[face / 4] != 0;
    }
    bool is_kept(std::uint32_t a, std::uint32_t b) const noexcept {
        return kept_.find(a, b) != no_index;
    }
    bool take_in_border(const BoundaryPatch& patch);
    void spread(std::uint32_t face, Side side, const BoundaryPatch& patch);
    std::uint32_t next_face(std::uint32_t face, unsigned opposite,
                            std::uint32_t border) const noexcept;
    static std::uint64_t entry(std::uint32_t border, std::uint32_t t) noexcept {
        return std::uint64_t{border} << 32 | t;
    }
    double area(std::uint32_t face, const BoundaryPatch& patch) const noexcept;
    void set_side(std::uint32_t face, Side side);
    bool take_in_behind(std::uint32_t face, Side side);

    FlipMesh& mesh_;
    const PairTable& kept_;
    const std::uint32_t first_added_;
    EdgeRing ring_;
    Buffer<std::uint32_t> tetrahedra_;
    Buffer<std::uint8_t> is_inside_;  // for each tetrahedron of the mesh
    Buffer<Side> side_of_;            // of each face of the cavity; neither for other faces
    // The tetrahedra at edges of the border into which the patch runs: the number of the edge and
    // that of the tetrahedron.
    Buffer<std::uint64_t> entries_;
    Buffer<Change> changes_;  // of sides, while the cavity grows
    Buffer<std::uint32_t> faces_;
    PairTable edges_, lost_;
    Buffer<std::uint32_t> vanishing_;
};

template <class Use>
bool PatchCavity::for_each_on_side(Side side, std::uint32_t point, const Use& use) const {
    for (const std::uint32_t t : tetrahedra_)
        for (std::uint32_t face = 4 * t; face < 4 * t + 4; ++face) {
            if (side_of_[face] != side) continue;
            FlipMesh::Corners corners;
            std::copy_n(mesh_.tetrahedra[t].v, 4, corners.v);
            corners.v[face % 4] = no_index;
            if (std::find(corners.v, corners.v + 4, point) != corners.v + 4) continue;
            corners.v[face % 4] = point;
            if (!use(corners)) return false;
        }
    return true;
}

}  // namespace mgdt
