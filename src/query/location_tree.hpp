// SPDX-License-Identifier: MIT
// Where a walk to any place begins: a kd-tree over a sample of the vertices, a few of them in each
// leaf. It follows the points wherever they crowd, and takes vertices in as they are inserted.
#pragma once

#include "mesh/mesh.hpp"

namespace mgdt {

class LocationTree {
  public:
    // Below this many vertices a walk is short from anywhere.
    static constexpr std::size_t smallest = 512;
    // It takes in one of this many vertices that come in a batch, and of those that come alone.
    static constexpr std::size_t stride = 16, stride_of_lone = 4;

    // Over the vertices before `end`, which are in the mesh; at least one.
    // O(n log n).
    LocationTree(Allocator& allocator, const Mesh& mesh, std::size_t end);

    // Takes in the vertices from `begin` to `end`, as far as memory and depth allow.
    void add(const Mesh& mesh, std::size_t begin, std::size_t end) noexcept;
    // Whether it had to leave out too many vertices, as of points that advance along a line, so
    // that another tree should be made.
    bool is_outgrown() const noexcept { return missed_ > made_over_ / 2; }
    // Some vertices leave, move or get other numbers. Those that the tree has stay in it, so that
    // walks may begin elsewhere. Returns whether it is of use yet.
    bool takes_changes(std::size_t vertices) noexcept {
        changed_ += vertices;
        return changed_ <= stride * made_over_ / 4;
    }
    // A vertex near q, unless it has changed; then it may not be there at all.
    VertexId near(const double* q) const noexcept;

    // Whether every descent ends, at a vertex before `vertices` where none have changed.
    bool is_sound(std::size_t vertices) const;

  private:
    static constexpr unsigned deepest = 128;
    static constexpr std::ptrdiff_t most_in_leaf = 8, most_in_new_leaf = 6;

    struct Sample {
        double x[3];
        VertexId vertex;
    };
    static Sample sample(const Mesh& mesh, VertexId v);

    // Twice the number of a node, or of a leaf and one more.
    using Child = std::uint32_t;
    static Child node_child(std::size_t i) { return static_cast<Child>(2 * i); }
    static Child leaf_child(std::size_t i) { return static_cast<Child>(2 * i + 1); }
    static bool is_leaf(Child c) { return (c & 1) != 0; }
    static std::size_t index(Child c) { return c / 2; }

    struct Node {
        double split;
        std::uint32_t axis;
        Child child[2];  // below the split, and not
        unsigned side(const double* q) const { return q[axis] < split ? 0 : 1; }
    };
    // The first places are used, the others are at infinity. Coordinates are to choose by, for
    // which floats will do: so a leaf is on two lines.
    struct Leaf {
        Leaf(const Sample* begin, const Sample* end);
        void put(std::ptrdiff_t i, const Sample& s);
        float x[3][most_in_leaf];
        VertexId vertices[most_in_leaf];
    };

    Child build(Sample* begin, Sample* end);
    void add(const Mesh& mesh, const Sample& s) noexcept;
    // Makes a node of a full leaf and another vertex. There is room.
    Child split_leaf(const Mesh& mesh, std::size_t leaf, const Sample& another);

    Buffer<Node> nodes_;
    Buffer<Leaf> leaves_;
    Child root_;
    std::size_t made_over_ = 0, missed_ = 0, changed_ = 0;  // vertices
};

// The live tetrahedron to start a walk to q from: near the tree's vertex, or `last` where that is
// nearer. Either may be missing, not both.
TetId start_of_walk(const Mesh& mesh, const LocationTree* tree, TetId last, const double* q);

}  // namespace mgdt
