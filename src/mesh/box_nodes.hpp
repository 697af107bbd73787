// SPDX-License-Identifier: MIT
// A tree of boxes around items, each of which has a box: the nodes that several kinds of search
// use.
#pragma once

#include <cstdint>

#include "mesh/bounding_box.hpp"
#include "platform/memory.hpp"
#include "platform/stop_request.hpp"

namespace mgdt {

// A node with the items `begin` to `end` - 1. Its first child is the next node.
struct BoxNode {
    BoundingBox box;
    std::uint32_t begin, end;
    std::uint32_t second;  // the other child; 0 in a leaf

    bool is_leaf() const { return second == 0; }
};

// Divides the items `begin` to `end` - 1, which are not none, and appends the nodes of their tree.
// The items are halved along the longest side of their common box, so the depth is logarithmic and
// the time O(n log n). box_of(item) is the box of an item. Returns the number of the root.
template <class Item, class BoxOf>
std::uint32_t make_box_nodes(Buffer<Item>& items, std::uint32_t begin, std::uint32_t end,
                             std::size_t most_in_leaf, const BoxOf& box_of, const StopRequest& stop,
                             Buffer<BoxNode>& nodes) {
    stop.poll_in_step(nodes.size());
    BoundingBox box = box_of(items[begin]);
    for (std::uint32_t i = begin + 1; i < end; ++i) box.include(box_of(items[i]));
    const auto number = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back({box, begin, end, 0});
    if (end - begin <= most_in_leaf) return number;
    const int axis = box.longest_axis();
    const std::uint32_t half = begin + (end - begin) / 2;
    std::nth_element(items.begin() + begin, items.begin() + half, items.begin() + end,
                     [&](const Item& a, const Item& b) {
                         return box_of(a).middle(axis) < box_of(b).middle(axis);
                     });
    make_box_nodes(items, begin, half, most_in_leaf, box_of, stop, nodes);
    const std::uint32_t second =
        make_box_nodes(items, half, end, most_in_leaf, box_of, stop, nodes);
    nodes[number].second = second;
    return number;
}

}  // namespace mgdt
