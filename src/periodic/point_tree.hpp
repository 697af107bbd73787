// SPDX-License-Identifier: MIT
// A tree of boxes around points, which finds those in a ball.
#pragma once

#include <cstdint>

#include "periodic/rough_power.hpp"
#include "platform/memory.hpp"
#include "platform/stop_request.hpp"

namespace mgdt {

class PointTree {
  public:
    explicit PointTree(Allocator& allocator) : points_(allocator), nodes_(allocator) {}

    void push(std::uint32_t number, const double* x) {
        points_.push_back({{x[0], x[1], x[2]}, number});
    }
    std::size_t size() const { return points_.size(); }
    // Makes the tree of all points that were pushed. O(n log n).
    void make(const StopRequest& stop);

    // The point with the least power, if that is less than `least`, which becomes its power.
    // Otherwise `point` stays as it is. Powers are rounded.
    void find_least(const RoughPower& power, double& least, std::uint32_t& point) const {
        if (!nodes_.empty()) find_least_in(0, power, least, point);
    }
    // Calls f(number) for each point that may be in the closed ball of the power.
    template <class F>
    void for_each_inside(const RoughPower& power, const F& f) const {
        if (!nodes_.empty()) for_each_in(0, power, f);
    }

  private:
    static constexpr std::size_t most_in_leaf = 8;

    struct Point {
        double x[3];
        std::uint32_t number;
    };
    // A node has points_[begin] to points_[end - 1]. Its first child is the next node.
    struct Node {
        double low[3], high[3];
        std::uint32_t begin, end;
        std::uint32_t second;  // the other child; 0 in a leaf
    };
    std::uint32_t make(std::uint32_t begin, std::uint32_t end, const StopRequest& stop);
    void find_least_in(std::uint32_t number, const RoughPower& power, double& least,
                       std::uint32_t& point) const;
    template <class F>
    void for_each_in(std::uint32_t number, const RoughPower& power, const F& f) const;

    Buffer<Point> points_;
    Buffer<Node> nodes_;
};

template <class F>
void PointTree::for_each_in(std::uint32_t number, const RoughPower& power, const F& f) const {
    const Node& node = nodes_[number];
    if (!power.may_meet(node.low, node.high)) return;
    if (node.second != 0) {
        for_each_in(number + 1, power, f);
        for_each_in(node.second, power, f);
        return;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i)
        if (power.may_be_inside(points_[i].x)) f(points_[i].number);
}

}  // namespace mgdt
