// SPDX-License-Identifier: MIT
#include "periodic/point_tree.hpp"

#include <algorithm>

namespace mgdt {

void PointTree::make(const StopRequest& stop) {
    nodes_.clear();
    if (points_.empty()) return;
    nodes_.set_capacity(4 * (points_.size() / most_in_leaf_ + 1));
    make(0, static_cast<std::uint32_t>(points_.size()), stop);
}

std::uint32_t PointTree::make(std::uint32_t begin, std::uint32_t end, const StopRequest& stop) {
    stop.poll_in_step(nodes_.size());
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    Node node = {};
    std::copy_n(points_[begin].x, 3, node.low);
    std::copy_n(points_[begin].x, 3, node.high);
    for (std::uint32_t i = begin; i < end; ++i)
        for (unsigned k = 0; k < 3; ++k) {
            node.low[k] = std::min(node.low[k], points_[i].x[k]);
            node.high[k] = std::max(node.high[k], points_[i].x[k]);
        }
    node.begin = begin;
    node.end = end;
    nodes_.push_back(node);
    if (end - begin <= most_in_leaf_) return number;
    unsigned axis = 0;
    for (unsigned k = 1; k < 3; ++k)
        if (node.high[k] - node.low[k] > node.high[axis] - node.low[axis]) axis = k;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
                     [&](const Point& a, const Point& b) { return a.x[axis] < b.x[axis]; });
    make(begin, middle, stop);
    const std::uint32_t second = make(middle, end, stop);
    nodes_[number].second = second;
    return number;
}

}  // namespace mgdt
