// SPDX-License-Identifier: MIT
#include "domain/box_tree.hpp"

namespace mgdt {

BoxTree::BoxTree(Allocator& allocator, const Buffer<BoundingBox>& boxes, const StopRequest& stop)
    : allocator_(allocator), boxes_(boxes), stop_(stop), order_(allocator), nodes_(allocator) {
    const auto n = static_cast<std::uint32_t>(boxes.size());
    order_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) order_[i] = i;
    if (n > 0) make(0, n);
}

// Halves the boxes along the longest side of their common box. The depth is logarithmic.
std::uint32_t BoxTree::make(std::uint32_t begin, std::uint32_t end) {
    stop_.poll_in_step(nodes_.size());
    BoundingBox box = boxes_[order_[begin]];
    for (std::uint32_t i = begin + 1; i < end; ++i) box.include(boxes_[order_[i]]);
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({box, begin, end, 0});
    if (end - begin <= most_in_leaf) return number;
    int axis = 0;
    // Halves, because a sum of two coordinates may overflow.
    const auto side = [&](int k) { return box.high[k] / 2 - box.low[k] / 2; };
    for (int k = 1; k < 3; ++k)
        if (side(k) > side(axis)) axis = k;
    const auto middle = [&](std::uint32_t i) {
        return boxes_[i].low[axis] / 2 + boxes_[i].high[axis] / 2;
    };
    const std::uint32_t half = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return middle(a) < middle(b); });
    make(begin, half);
    const std::uint32_t second = make(half, end);
    nodes_[number].second = second;
    return number;
}

bool BoxTree::divide(Pair pair, Buffer<Pair>& into) const {
    const Node &a = nodes_[pair.a], &b = nodes_[pair.b];
    const auto add = [&](std::uint32_t x, std::uint32_t y) {
        if (x == y || nodes_[x].box.overlaps(nodes_[y].box)) into.push_back({x, y});
    };
    const bool divides_a = a.second != 0 && (b.second == 0 || a.end - a.begin >= b.end - b.begin);
    if (!divides_a && b.second == 0) return false;
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
