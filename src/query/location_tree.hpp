// SPDX-License-Identifier: MIT
// A kd-tree over a sample of the vertices, several in each leaf. It gives a vertex near a query
// point, where a walk starts. It adapts to the density of the points, and vertices are added as
// they are inserted.
#pragma once

#include "mesh/mesh.hpp"

namespace mgdt {

class LocationTree {
  public:
    // The least number of vertices for a tree. With fewer, every walk is short.
    static constexpr std::size_t smallest = 512;
    // The sample has one in `stride` vertices of a batch, and one in `stride_of_lone` of the
    // vertices that are inserted one by one.
    static constexpr std::size_t stride = 16, stride_of_lone = 4;

    // A tree over the vertices before `end`, of which there is at least one. O(n log n).
    LocationTree(Allocator& allocator, const Mesh& mesh, std::size_t end);

    // Adds vertices `begin` to `end` - 1, as far as memory and the depth limit allow.
    void add(const Mesh& mesh, std::size_t begin, std::size_t end) noexcept;
    // Whether the tree had to leave out so many vertices that it should be made anew, as when
    // points advance along a line.
    bool is_outgrown() const noexcept { return missed_ > made_over_ / 2; }
    // Counts vertices that are removed, moved or renumbered. The tree keeps their old positions, so
    // walks may start far from the query point.
    void count_changes(std::size_t vertices) noexcept { changed_ += vertices; }
    // Whether so many vertices have changed that a new tree is better.
    bool is_stale() const noexcept { return changed_ > stride * made_over_ / 4; }
    // A vertex near q. If vertices have changed it may be far from q, or not exist.
    VertexId near(const double* q) const noexcept;

    // Whether every descent ends at a leaf with a vertex. Unless vertices have changed, each vertex
    // number must be less than `vertices`.
    bool is_sound(std::size_t vertices) const;

  private:
    static constexpr unsigned deepest = 128;
    static constexpr std::ptrdiff_t most_in_leaf = 8, most_in_new_leaf = 6;

    struct Sample {
        double x[3];
        VertexId vertex;
    };
    static Sample sample(const Mesh& mesh, VertexId v);

    // A child is 2 * i for node i, and 2 * i + 1 for leaf i.
    using Child = std::uint32_t;
    static Child node_child(std::size_t i) { return static_cast<Child>(2 * i); }
    static Child leaf_child(std::size_t i) { return static_cast<Child>(2 * i + 1); }
    static bool is_leaf(Child c) { return (c & 1) != 0; }
    static std::size_t index(Child c) { return c / 2; }

    struct Node {
        double split;
        std::uint32_t axis;
        Child child[2];  // child[0] for coordinates below the split, child[1] for the others
        unsigned side(const double* q) const { return q[axis] < split ? 0 : 1; }
    };
    // Unused entries come last and have infinite coordinates. Coordinates only serve to choose the
    // nearest vertex, so floats suffice, and a leaf takes two cache lines.
    struct Leaf {
        Leaf(const Sample* begin, const Sample* end);
        void put(std::ptrdiff_t i, const Sample& s);
        float x[3][most_in_leaf];
        VertexId vertices[most_in_leaf];
    };

    Child build(Sample* begin, Sample* end);
    void add(const Mesh& mesh, const Sample& s) noexcept;
    // Replaces a full leaf by a node with two leaves, and adds the vertex `another`. The buffers
    // have room for one more node and one more leaf.
    Child split_leaf(const Mesh& mesh, std::size_t leaf, const Sample& another);

    Buffer<Node> nodes_;
    Buffer<Leaf> leaves_;
    Child root_;
    std::size_t made_over_ = 0, missed_ = 0, changed_ = 0;  // numbers of vertices
};

// The live tetrahedron where a walk to q starts: near the vertex that the tree gives, or `last` if
// `last` is nearer. `tree` may be nullptr, and `last` may be no_tetrahedron. Without both, the walk
// starts at any live tetrahedron.
TetId start_of_walk(const Mesh& mesh, const LocationTree* tree, TetId last, const double* q);

}  // namespace mgdt
