// SPDX-License-Identifier: MIT
#include "query/location_tree.hpp"

#include <algorithm>
#include <limits>

namespace mgdt {
namespace {

// The coordinate of unused entries of a leaf.
constexpr float unused = std::numeric_limits<float>::infinity();

double square_distance(const double* a, const double* b) {
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return x * x + y * y + z * z;
}

// Splits a range of at least two vertices along its longest extent, near the median. Vertices with
// the same coordinate go to the same part, since a descent could not find them otherwise. Neither
// part is empty. The first vertex of the second part has the least coordinate of this part.
template <class Sample>
Sample* divide(Sample* begin, Sample* end, std::uint32_t& axis) {
    double low[3], high[3];
    for (int k = 0; k < 3; ++k) low[k] = high[k] = begin->x[k];
    for (const Sample* s = begin + 1; s < end; ++s) {
        for (int k = 0; k < 3; ++k) {
            low[k] = s->x[k] < low[k] ? s->x[k] : low[k];
            high[k] = s->x[k] > high[k] ? s->x[k] : high[k];
        }
    }
    axis = 0;
    for (std::uint32_t k = 1; k < 3; ++k)
        if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
    const auto is_less = [k = axis](const Sample& a, const Sample& b) {
        return a.x[k] < b.x[k] || (a.x[k] == b.x[k] && a.vertex < b.vertex);
    };
    Sample* const middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, is_less);
    const double split = middle->x[axis];
    if (split > low[axis])
        return std::partition(begin, middle,
                              [=, k = axis](const Sample& s) { return s.x[k] < split; });
    // All vertices before the median have the median's coordinate.
    Sample* const above =
        std::partition(middle, end, [=, k = axis](const Sample& s) { return s.x[k] == split; });
    if (above == end) return middle;  // all are at one place: vertices of the tree have changed
    std::iter_swap(above, std::min_element(above, end, is_less));
    return above;
}

}  // namespace

LocationTree::LocationTree(Allocator& allocator, const Mesh& mesh, std::size_t end)
    : nodes_(allocator), leaves_(allocator) {
    Buffer<Sample> samples(allocator, (end - 2) / stride + 1);
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = sample(mesh, static_cast<VertexId>(1 + i * stride));
    // A leaf has at least half of most_in_new_leaf vertices, unless it is the only leaf, or
    // coordinates are equal.
    const std::size_t most_leaves = 2 * samples.size() / most_in_new_leaf + 1;
    nodes_.reserve(most_leaves);
    leaves_.reserve(most_leaves);
    root_ = build(samples.begin(), samples.end());
    made_over_ = samples.size();
}

LocationTree::Sample LocationTree::sample(const Mesh& mesh, VertexId v) {
    const double* const p = mesh.point(v);
    return {{p[0], p[1], p[2]}, v};
}

LocationTree::Leaf::Leaf(const Sample* begin, const Sample* end) {
    const Sample none = {{unused, unused, unused}, infinite_vertex};
    for (std::ptrdiff_t i = 0; i < most_in_leaf; ++i) put(i, i < end - begin ? begin[i] : none);
}

void LocationTree::Leaf::put(std::ptrdiff_t i, const Sample& s) {
    vertices[i] = s.vertex;
    for (int k = 0; k < 3; ++k) x[k][i] = static_cast<float>(s.x[k]);
}

LocationTree::Child LocationTree::build(Sample* begin, Sample* end) {
    if (end - begin <= most_in_new_leaf) {
        leaves_.push_back(Leaf(begin, end));
        return leaf_child(leaves_.size() - 1);
    }
    std::uint32_t axis;
    Sample* const middle = divide(begin, end, axis);
    const std::size_t node = nodes_.size();
    nodes_.push_back({middle->x[axis], axis, {}});
    const Child below = build(begin, middle), above = build(middle, end);
    nodes_[node].child[0] = below;
    nodes_[node].child[1] = above;
    return node_child(node);
}

// The old leaf keeps the vertices below the split.
LocationTree::Child LocationTree::split_leaf(const Mesh& mesh, std::size_t leaf,
                                             const Sample& another) {
    Sample samples[most_in_leaf + 1];
    for (std::ptrdiff_t i = 0; i < most_in_leaf; ++i) {
        // The vertex to be added takes the place of a vertex that no longer exists.
        const VertexId v = leaves_[leaf].vertices[i];
        samples[i] = v < mesh.vertices.size() ? sample(mesh, v) : another;
    }
    samples[most_in_leaf] = another;
    Sample* const end = samples + most_in_leaf + 1;
    std::uint32_t axis;
    const Sample* const middle = divide(samples, end, axis);
    leaves_[leaf] = Leaf(samples, middle);
    leaves_.push_back(Leaf(middle, end));
    nodes_.push_back({middle->x[axis], axis, {leaf_child(leaf), leaf_child(leaves_.size() - 1)}});
    return node_child(nodes_.size() - 1);
}

void LocationTree::add(const Mesh& mesh, std::size_t begin, std::size_t end) noexcept {
    const std::size_t step = end - begin == 1 ? stride_of_lone : stride;
    for (std::size_t v = (begin + step - 1) / step * step; v < end; v += step)
        add(mesh, sample(mesh, static_cast<VertexId>(v)));
}

void LocationTree::add(const Mesh& mesh, const Sample& s) noexcept {
    constexpr std::size_t none = ~std::size_t{0};
    std::size_t parent = none;
    unsigned side = 0, depth = 0;
    Child child = root_;
    for (; !is_leaf(child); ++depth) {
        parent = index(child);
        side = nodes_[parent].side(s.x);
        child = nodes_[parent].child[side];
    }
    Leaf& leaf = leaves_[index(child)];
    const std::ptrdiff_t free =
        std::find(leaf.vertices, leaf.vertices + most_in_leaf, infinite_vertex) - leaf.vertices;
    if (free < most_in_leaf) {
        leaf.put(free, s);
        return;
    }
    if (depth == deepest) {
        ++missed_;
        return;
    }
    try {
        nodes_.grow(nodes_.size() + 1);
        leaves_.grow(leaves_.size() + 1);
    } catch (const std::bad_alloc&) {
        return;  // the tree serves without this vertex
    }
    const Child made = split_leaf(mesh, index(child), s);
    (parent == none ? root_ : nodes_[parent].child[side]) = made;
}

// Checks that each node and leaf is reached exactly once.
bool LocationTree::is_sound(std::size_t vertices) const {
    const std::size_t counts[2] = {nodes_.size(), leaves_.size()};
    Buffer<Child> reached(nodes_.allocator());
    reached.reserve(counts[0] + counts[1]);
    Buffer<bool> is_reached(nodes_.allocator());
    is_reached.resize(2 * std::max(counts[0], counts[1]), false);
    const auto reach = [&](Child child) {
        if (index(child) >= counts[is_leaf(child)] || is_reached[child]) return false;
        is_reached[child] = true;
        reached.push_back(child);
        return true;
    };
    if (!reach(root_)) return false;
    for (std::size_t i = 0; i < reached.size(); ++i) {
        if (!is_leaf(reached[i])) {
            const Node& node = nodes_[index(reached[i])];
            if (node.axis > 2 || !reach(node.child[0]) || !reach(node.child[1])) return false;
            continue;
        }
        const Leaf& leaf = leaves_[index(reached[i])];
        if (leaf.vertices[0] == infinite_vertex) return false;
        for (std::ptrdiff_t k = 0; k < most_in_leaf; ++k) {
            const VertexId v = leaf.vertices[k];
            if ((v >= vertices && changed_ == 0) ||
                (v == infinite_vertex && leaf.x[0][k] != unused))
                return false;
        }
    }
    return reached.size() == counts[0] + counts[1];
}

VertexId LocationTree::near(const double* q) const noexcept {
    Child child = root_;
    while (!is_leaf(child)) {
        const Node& node = nodes_[index(child)];
        child = node.child[node.side(q)];
    }
    const Leaf& leaf = leaves_[index(child)];
    const float x = static_cast<float>(q[0]), y = static_cast<float>(q[1]),
                z = static_cast<float>(q[2]);
    float squares[most_in_leaf];
    for (std::ptrdiff_t i = 0; i < most_in_leaf; ++i) {
        const float a = leaf.x[0][i] - x, b = leaf.x[1][i] - y, c = leaf.x[2][i] - z;
        squares[i] = a * a + b * b + c * c;
    }
    // If several vertices are equally near in float arithmetic, the first one is taken.
    std::ptrdiff_t nearest = 0;
    for (std::ptrdiff_t i = 1; i < most_in_leaf; ++i)
        nearest = squares[i] < squares[nearest] ? i : nearest;
    return leaf.vertices[nearest];
}

TetId start_of_walk(const Mesh& mesh, const LocationTree* tree, TetId last, const double* q) {
    const TetId anywhere = last == no_tetrahedron ? mesh.live_from(0) : last;
    if (!tree) return anywhere;
    const VertexId near = tree->near(q);
    // If vertices were removed, `near` may be the number of a new vertex that is not inserted yet.
    if (near >= mesh.vertex_hint.size() || mesh.vertex_hint[near] == no_tetrahedron)
        return anywhere;
    if (last != no_tetrahedron && square_distance(mesh.point(mesh.tetrahedra[last].v[0]), q) <=
                                      square_distance(mesh.point(near), q))
        return last;
    return mesh.live_from(mesh.vertex_hint[near]);
}

}  // namespace mgdt
