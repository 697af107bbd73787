// SPDX-License-Identifier: MIT
#include "kernel/location_tree.hpp"

#include <algorithm>

namespace mgdt {
namespace {

double square_distance(const double* a, const double* b) {
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return x * x + y * y + z * z;
}

}  // namespace

LocationTree::LocationTree(Allocator& allocator, const Mesh& mesh, std::size_t end)
    : nodes_(allocator) {
    nodes_.resize((end - 2) / stride + 1);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        nodes_[i] = {0, static_cast<VertexId>(1 + i * stride), 0, {none, none}};
    root_ = build(mesh, 0, static_cast<std::uint32_t>(nodes_.size()));
}

// The root of a range is in its middle.
std::uint32_t LocationTree::build(const Mesh& mesh, std::uint32_t begin, std::uint32_t end) {
    if (begin == end) return none;
    double low[3], high[3];
    for (int k = 0; k < 3; ++k) low[k] = high[k] = mesh.point(nodes_[begin].vertex)[k];
    for (std::uint32_t i = begin + 1; i < end; ++i) {
        const double* p = mesh.point(nodes_[i].vertex);
        for (int k = 0; k < 3; ++k) {
            low[k] = p[k] < low[k] ? p[k] : low[k];
            high[k] = p[k] > high[k] ? p[k] : high[k];
        }
    }
    std::uint32_t axis = 0;
    for (std::uint32_t k = 1; k < 3; ++k)
        if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(nodes_.begin() + begin, nodes_.begin() + middle, nodes_.begin() + end,
                     [&](const Node& a, const Node& b) {
                         const double x = mesh.point(a.vertex)[axis],
                                      y = mesh.point(b.vertex)[axis];
                         return x < y || (x == y && a.vertex < b.vertex);
                     });
    const std::uint32_t below = build(mesh, begin, middle), above = build(mesh, middle + 1, end);
    Node& node = nodes_[middle];
    node.axis = axis;
    node.split = mesh.point(node.vertex)[axis];
    node.child[0] = below;
    node.child[1] = above;
    return middle;
}

void LocationTree::add(const Mesh& mesh, std::size_t begin, std::size_t end) noexcept {
    for (std::size_t v = (begin + stride - 1) / stride * stride; v < end; v += stride) {
        const VertexId vertex = static_cast<VertexId>(v);
        const double* const p = mesh.point(vertex);
        std::uint32_t at = root_;
        for (unsigned depth = 0;; ++depth) {
            if (depth == deepest) break;  // it serves without this vertex
            const Node& node = nodes_[at];
            const unsigned side = p[node.axis] < node.split ? 0 : 1;
            if (node.child[side] == none) {
                const std::uint32_t axis = (node.axis + 1) % 3;
                const std::uint32_t leaf = static_cast<std::uint32_t>(nodes_.size());
                try {
                    nodes_.push_back({p[axis], vertex, axis, {none, none}});
                } catch (const std::bad_alloc&) {
                    return;
                }
                nodes_[at].child[side] = leaf;
                break;
            }
            at = node.child[side];
        }
    }
}

// Each node but the root is the child of one, and all are reached: it is a tree.
bool LocationTree::is_sound(std::size_t vertices) const {
    if (root_ >= nodes_.size()) return false;
    Buffer<std::uint32_t> reached(nodes_.allocator());
    reached.reserve(nodes_.size());
    reached.push_back(root_);
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const Node& node = nodes_[reached[i]];
        if (node.vertex == infinite_vertex || node.vertex >= vertices || node.axis > 2)
            return false;
        for (const std::uint32_t child : node.child) {
            if (child == none) continue;
            if (child >= nodes_.size() || reached.size() == nodes_.size()) return false;
            reached.push_back(child);
        }
    }
    return reached.size() == nodes_.size();
}

VertexId LocationTree::near(const double* q) const noexcept {
    for (std::uint32_t at = root_;;) {
        const Node& node = nodes_[at];
        const std::uint32_t next = node.child[q[node.axis] < node.split ? 0 : 1];
        if (next == none) return node.vertex;
        at = next;
    }
}

TetId start_of_walk(const Mesh& mesh, const LocationTree* tree, TetId last, const double* q) {
    if (!tree) return last == no_tetrahedron ? mesh.live_from(0) : last;
    const VertexId near = tree->near(q);
    if (last != no_tetrahedron && square_distance(mesh.point(mesh.tetrahedra[last].v[0]), q) <=
                                      square_distance(mesh.point(near), q))
        return last;
    return mesh.live_from(mesh.near[near]);
}

}  // namespace mgdt
