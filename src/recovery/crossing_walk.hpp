// SPDX-License-Identifier: MIT
// The walk along a missing segment. It lists the faces and edges that the segment crosses.
#pragma once

#include "recovery/flip_mesh.hpp"

namespace mgdt {

// A face or an edge that a segment crosses between its corners.
struct Crossing {
    std::uint32_t tetrahedron;  // from which the walk leaves through it
    std::uint32_t v[3];         // the corners; v[2] is no_index for an edge

    bool is_edge() const noexcept { return v[2] == no_index; }
};

class CrossingWalk {
  public:
    CrossingWalk(FlipMesh& mesh, Allocator& allocator) : mesh_(mesh), crossings_(allocator) {}

    enum class Result {
        is_edge,  // the segment is an edge of the mesh
        crosses,  // crossings() has all that it crosses, in their order
        meets     // vertex() is on the segment
    };

    // Walks from vertex a to vertex b. The segment has to be inside of the mesh.
    Result run(std::uint32_t a, std::uint32_t b);

    const Buffer<Crossing>& crossings() const noexcept { return crossings_; }
    std::uint32_t vertex() const noexcept { return vertex_; }

  private:
    enum class Step { goes_on, ends, meets };

    int turn(std::uint32_t u, std::uint32_t v) const noexcept;
    Step leave_start(std::uint32_t t);
    Step leave_face(const Crossing& from);
    Step leave_edge(const Crossing& from);
    Step cross_edge(std::uint32_t t, std::uint32_t u, std::uint32_t v);
    Step cross_face(std::uint32_t t, std::uint32_t u, std::uint32_t v, std::uint32_t w);
    Step meet(std::uint32_t v);

    FlipMesh& mesh_;
    std::uint32_t a_ = 0, b_ = 0, vertex_ = no_index;
    Buffer<Crossing> crossings_;
};

// About where the segment from a to b crosses a face or an edge.
void find_crossing(const FlipMesh& mesh, std::uint32_t a, std::uint32_t b, const Crossing& c,
                   double (&x)[3]) noexcept;

}  // namespace mgdt
