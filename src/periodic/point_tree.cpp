// SPDX-License-Identifier: MIT
#include "periodic/point_tree.hpp"

namespace mgdt {

void PointTree::make(const StopRequest& stop) {
    nodes_.clear();
    if (points_.empty()) return;
    nodes_.set_capacity(4 * (points_.size() / most_in_leaf_ + 1));
    const auto box_of = [](const Point& p) { return BoundingBox(p.x); };
    make_box_nodes(points_, 0, static_cast<std::uint32_t>(points_.size()), most_in_leaf_, box_of,
                   stop, nodes_);
}

}  // namespace mgdt
