// SPDX-License-Identifier: MIT
// Where a walk to any place begins: a kd-tree over a sample of the vertices. It follows the points
// wherever they crowd, and takes vertices in as they are inserted.
#pragma once

#include "mesh/mesh.hpp"

namespace mgdt {

class LocationTree {
  public:
    // Below this many vertices a walk is short from anywhere.
    static constexpr std::size_t smallest = 512;

    // Over one of every `stride` of the vertices before `end`, which are in the mesh; one at least.
    // Linear but for a logarithm.
    LocationTree(Allocator& allocator, const Mesh& mesh, std::size_t end);

    // Takes in one of every `stride` of the vertices from `begin` to `end`, as far as memory and
    // depth allow.
    void add(const Mesh& mesh, std::size_t begin, std::size_t end) noexcept;
    // A vertex near q.
    VertexId near(const double* q) const noexcept;

    // Whether descending it ends, always at one of so many vertices.
    bool is_sound(std::size_t vertices) const;

  private:
    static constexpr std::size_t stride = 16;
    static constexpr unsigned deepest = 64;
    static constexpr std::uint32_t none = 0xFFFFFFFFu;

    struct Node {
        double split;
        VertexId vertex;
        std::uint32_t axis;
        std::uint32_t child[2];  // below the split, and not
    };
    std::uint32_t build(const Mesh& mesh, std::uint32_t begin, std::uint32_t end);

    Buffer<Node> nodes_;
    std::uint32_t root_;
};

// The live tetrahedron to start a walk to q from: near the tree's vertex, or `last` where that is
// nearer. Either may be missing, not both.
TetId start_of_walk(const Mesh& mesh, const LocationTree* tree, TetId last, const double* q);

}  // namespace mgdt
