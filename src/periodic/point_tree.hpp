// SPDX-License-Identifier: MIT
// A tree of boxes around points, which finds those in a ball.
#pragma once

#include <cstdint>

#include "mesh/box_nodes.hpp"
#include "periodic/rough_power.hpp"

namespace mgdt {

class PointTree {
  public:
    explicit PointTree(Allocator& allocator, std::size_t most_in_leaf = 8)
        : points_(allocator), nodes_(allocator), most_in_leaf_(most_in_leaf) {}

    void push(std::uint32_t number, const double* x) {
        points_.push_back({{x[0], x[1], x[2]}, number});
    }
    void clear() {
        points_.clear();
        nodes_.clear();
    }
    // Gives the memory back.
    void reset() noexcept {
        points_.reset();
        nodes_.reset();
    }
    std::size_t size() const { return points_.size(); }
    // Makes the tree of all points that were pushed. O(n log n).
    void make(const StopRequest& stop);

    // The number that was given to push() for the i-th point in the order of the leaves.
    std::uint32_t number(std::uint32_t i) const { return points_[i].number; }
    // Calls f(begin, end) for each leaf.
    template <class F>
    void each_leaf(const F& f) const {
        for (const BoxNode& node : nodes_)
            if (node.is_leaf()) f(node.begin, node.end);
    }
    // Finds the point that is deepest in a ball: the one with the least power among those that are
    // certainly inside. Powers are rounded. If that power is less than `least`, it is written
    // there, and the number of the point to `deepest`. `least` starts at 0; as long as it is 0, the
    // function calls unsure(number) for each point that may be in the closed ball. A power that is
    // NaN, because the sphere is too large for doubles, decides nothing.
    template <class F>
    void search(const RoughPower& power, double& least, std::uint32_t& deepest,
                const F& unsure) const {
        if (nodes_.empty()) return;
        const double error = power.error_in(nodes_[0].box);
        if (!(power.least_in(nodes_[0].box) > (least < 0 ? least : error)))
            search_in(0, power, error, least, deepest, unsure);
    }

  private:
    struct Point {
        double x[3];
        std::uint32_t number;
    };
    template <class F>
    void search_in(std::uint32_t number, const RoughPower& power, double error, double& least,
                   std::uint32_t& deepest, const F& unsure) const;

    Buffer<Point> points_;
    Buffer<BoxNode> nodes_;
    const std::size_t most_in_leaf_;
};

template <class F>
void PointTree::search_in(std::uint32_t number, const RoughPower& power, double error,
                          double& least, std::uint32_t& deepest, const F& unsure) const {
    const BoxNode& node = nodes_[number];
    if (node.is_leaf()) {
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            const double value = power.of(points_[i].x);
            if (value > (least < 0 ? least : error)) continue;
            const double own_error = power.error_at(points_[i].x);
            if (value < -own_error && value < least) {
                least = value;
                deepest = points_[i].number;
            } else if (!(least < 0) && !(value > own_error)) {
                unsure(points_[i].number);
            }
        }
        return;
    }
    std::uint32_t children[2] = {number + 1, node.second};
    double bounds[2];
    for (unsigned i = 0; i < 2; ++i) bounds[i] = power.least_in(nodes_[children[i]].box);
    if (bounds[1] < bounds[0]) {
        std::swap(children[0], children[1]);
        std::swap(bounds[0], bounds[1]);
    }
    for (unsigned i = 0; i < 2; ++i)
        if (!(bounds[i] > (least < 0 ? least : error)))
            search_in(children[i], power, error, least, deepest, unsure);
}

}  // namespace mgdt
