// SPDX-License-Identifier: MIT
// The edges inside of patches, which may be exchanged: the two triangles at such an edge are a
// quadrilateral, and its other diagonal takes the place of the edge.
#pragma once

#include "cleaning/patches.hpp"

namespace mgdt {

class PatchEdges {
  public:
    PatchEdges(SurfacePieces& pieces, const Buffer<Projection>& patches, const Nearness& near,
               Buffer<std::uint8_t>& is_changed, Allocator& allocator);

    // Makes edges of other triangles, and segments, edges of each patch that has both of their ends
    // and in which the way between them crosses only edges that can be exchanged. Returns how many
    // edges patches have got.
    std::size_t take_in_edges(const StopRequest& stop);
    // Exchanges edges of patches until all edges that can be exchanged are locally Delaunay, but
    // for rounding. Returns how many exchanges that took. Patches without new triangles stay as
    // they are, unless `all` is set.
    std::size_t make_delaunay(bool all, const StopRequest& stop);

  private:
    // A triangle and one of its corners or sides: 3 times the triangle plus the corner's position.
    using Corner = std::uint32_t;
    struct Edge {
        std::uint32_t a, b;
    };

    std::uint32_t vertex(Corner c) const noexcept { return pieces_.boundary.triangles[c]; }
    std::uint32_t next(Corner c) const noexcept {
        return pieces_.boundary.triangles[c / 3 * 3 + (c + 1) % 3];
    }
    std::uint32_t last(Corner c) const noexcept {
        return pieces_.boundary.triangles[c / 3 * 3 + (c + 2) % 3];
    }
    std::uint32_t patch_at(Corner c) const noexcept { return pieces_.patch_of_triangle[c / 3]; }
    int turn(std::uint32_t patch, std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

    void enlist(Corner c);
    void delist(Corner c);
    void relink(Corner side, Corner other);
    Corner side_between(std::uint32_t patch, std::uint32_t a, std::uint32_t b) const;
    bool take_in(std::uint32_t patch, std::uint32_t u, std::uint32_t v, const StopRequest& stop);
    Corner first_crossed(std::uint32_t patch, std::uint32_t u, std::uint32_t v) const;
    bool collect_crossed(std::uint32_t patch, std::uint32_t u, std::uint32_t v);
    bool is_convex(Corner side) const;
    void exchange(Corner side);
    bool is_delaunay(Corner side) const;
    void list_patches();
    void list_common_patches(std::uint32_t u, std::uint32_t v, Buffer<std::uint32_t>& common) const;

    SurfacePieces& pieces_;
    const Buffer<Projection>& patches_;
    const Nearness& near_;
    Buffer<std::uint8_t>& is_changed_;
    Allocator& allocator_;
    Buffer<std::uint32_t> links_;  // links_in_patches(), kept up to date
    // The corners at each vertex form a list.
    Buffer<Corner> first_at_, next_at_, last_at_;
    Buffer<std::uint32_t> count_at_;
    // The patches at vertex v are elements first_patch_[v] to first_patch_[v + 1] - 1, sorted.
    Buffer<std::uint32_t> first_patch_, patches_at_;
    Buffer<Edge> crossed_;
};

}  // namespace mgdt
