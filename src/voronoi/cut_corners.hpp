// SPDX-License-Identifier: MIT
// The corners of faces that a region cuts. Each point of space is one corner, regardless of the
// number of planes that meet there.
#pragma once

#include "dual/half_spaces.hpp"
#include "dual/region.hpp"
#include "platform/number_table.hpp"
#include "voronoi/circumcenters.hpp"
#include "voronoi/found_faces.hpp"

namespace mgdt {

class CutCorners {
  public:
    // vertex_of is the vertex of each of the caller's points.
    CutCorners(const MeshView& view, const VertexIndices& indices, const Region& region,
               const Circumcenters& centers, const Buffer<VertexId>& vertex_of);

    // The sites and planes that determine a corner: the corner has the same distance from its
    // sites, and is on its planes. A site is the caller's index of a point; a plane of the region
    // has the flag VoronoiDiagram::plane.
    struct Key {
        std::uint32_t of[4];
    };
    // Registers the circumcentre of a tetrahedron. All circumcentres are registered before the
    // first find().
    void add(TetId t);
    // Returns the corner with this key, which has at least one site. If the corner is the
    // circumcentre of a tetrahedron, the result is the slot of that tetrahedron; otherwise it is a
    // number with the flag cut_corner. Throws std::bad_alloc.
    std::uint32_t find(Key key);

    const SplitPoint& operator[](std::uint32_t corner) const noexcept {
        return (corner & cut_corner) != 0 ? points_[corner & ~cut_corner] : centers_[corner];
    }
    // The number of cut corners.
    std::size_t size() const noexcept { return points_.size(); }
    const double* point(std::uint32_t site) const noexcept { return mesh_.point(vertex_of_[site]); }
    // Adds the half-space of a site or of a plane.
    void add_half_space(std::uint32_t of, HalfSpaces& to) const;
    // The coordinates of a cut corner without the mesh's scale, rounded to the nearest doubles.
    void unscaled(std::uint32_t corner, double (&x)[3]);

  private:
    struct Known {
        Key key;
        std::uint32_t corner;
    };
    void set_planes(const Key& key);
    std::uint32_t number_of(const Key& key);
    SplitPoint position(const Key& key);
    bool is_same(const Key& a, const Key& b);

    const Mesh& mesh_;
    const VertexIndices& indices_;
    const Region& region_;
    const Circumcenters& centers_;
    const Buffer<VertexId>& vertex_of_;
    HalfSpaces half_spaces_;
    NumberTable by_key_, by_position_;
    Buffer<Known> keys_;       // the number of a key
    Buffer<Known> positions_;  // the number of a position; the first key of the corner there
    Buffer<SplitPoint> points_;
    Buffer<Key> key_of_point_;
};

}  // namespace mgdt
