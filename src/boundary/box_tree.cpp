// SPDX-License-Identifier: MIT
#include "boundary/box_tree.hpp"

namespace mgdt {

BoxTree::BoxTree(Allocator& allocator, const Buffer<BoundingBox>& boxes, const StopRequest& stop)
    : allocator_(allocator), boxes_(boxes), order_(allocator), nodes_(allocator) {
    const auto n = static_cast<std::uint32_t>(boxes.size());
    order_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) order_[i] = i;
    if (n == 0) return;
    const auto box_of = [this](std::uint32_t i) -> const BoundingBox& { return boxes_[i]; };
    make_box_nodes(order_, 0, n, most_in_leaf, box_of, stop, nodes_);
}

bool BoxTree::divide(Pair pair, Buffer<Pair>& into) const {
    const BoxNode &a = nodes_[pair.a], &b = nodes_[pair.b];
    const auto add = [&](std::uint32_t x, std::uint32_t y) {
        if (x == y || nodes_[x].box.overlaps(nodes_[y].box)) into.push_back({x, y});
    };
    const bool divides_a = !a.is_leaf() && (b.is_leaf() || a.end - a.begin >= b.end - b.begin);
    if (!divides_a && b.is_leaf()) return false;
    if (pair.a == pair.b) {
        add(pair.a + 1, pair.a + 1);
        add(a.second, a.second);
        add(pair.a + 1, a.second);
    } else if (divides_a) {
        add(pair.a + 1, pair.b);
        add(a.second, pair.b);
    } else {
        add(pair.a, pair.b + 1);
        add(pair.a, b.second);
    }
    return true;
}

}  // namespace mgdt
