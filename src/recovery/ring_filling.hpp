// SPDX-License-Identifier: MIT
// How the place of an edge is filled with tetrahedra when the edge is removed.
#pragma once

#include "recovery/crossings.hpp"

namespace mgdt {

// The ring of an edge from p to q, or a part of it, is a polygon. Each triangle of a triangulation
// of the polygon is the base of two tetrahedra, with apex p and with apex q.
class RingFilling {
  public:
    RingFilling(const FlipMesh& mesh, Allocator& allocator)
        : mesh_(mesh), best_(allocator), parts_(allocator) {}

    // Finds the filling with the fewest crossings and, among these, without flat tetrahedra.
    // Returns false if no filling has positive tetrahedra only and at most `most` crossings. The
    // polygon consists of `n` vertices; it is closed by an edge from the last to the first one.
    bool find(std::uint32_t p, std::uint32_t q, const std::uint32_t* polygon, std::size_t n,
              const Crossings& crossings, int most);
    // The number of crossings of the filling, without those of the polygon's own edges.
    int crossings() const noexcept { return best_[n_ - 1].crossings; }
    // Appends the tetrahedra of the filling.
    void append(Buffer<FlipMesh::Corners>& to);

  private:
    // The best way to fill the polygon from one vertex to a later one. `flatness` is smaller the
    // better the worst tetrahedron is. `middle` is the third corner at the closing edge, or
    // no_index if there is no way.
    struct Part {
        int crossings;
        double flatness;
        std::uint32_t middle;
    };
    Part best_part(std::size_t i, std::size_t j, const Crossings& crossings, int most) const;

    const FlipMesh& mesh_;
    std::uint32_t p_ = 0, q_ = 0;
    const std::uint32_t* v_ = nullptr;
    std::size_t n_ = 0;
    Buffer<Part> best_;  // for the polygon from i to j: element i n + j
    Buffer<std::uint32_t> parts_;
};

}  // namespace mgdt
