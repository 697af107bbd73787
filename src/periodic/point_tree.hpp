// SPDX-License-Identifier: MIT
// A tree of boxes around points, which finds those near a place.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

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

    // The point nearest to a place, if the square of its distance is less than `square`, which
    // becomes that of the point. Otherwise `nearest` stays as it is. Distances are rounded.
    void find_nearest(const double* place, double& square, std::uint32_t& nearest) const {
        if (!nodes_.empty()) find_nearest_in(0, place, square, nearest);
    }
    // Calls f(number) for each point whose squared distance from a place is at most `square`.
    template <class F>
    void for_each_near(const double* place, double square, F f) const {
        if (!nodes_.empty()) for_each_in(0, place, square, f);
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
    static double square_to(const double* x, const double* place) {
        const double d[3] = {x[0] - place[0], x[1] - place[1], x[2] - place[2]};
        return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    }
    static double square_to(const Node& node, const double* place) {
        double sum = 0;
        for (unsigned k = 0; k < 3; ++k) {
            const double d = std::max({node.low[k] - place[k], place[k] - node.high[k], 0.0});
            sum += d * d;
        }
        return sum;
    }
    std::uint32_t make(std::uint32_t begin, std::uint32_t end, const StopRequest& stop);
    void find_nearest_in(std::uint32_t number, const double* place, double& square,
                         std::uint32_t& nearest) const;
    template <class F>
    void for_each_in(std::uint32_t number, const double* place, double square, F f) const;

    Buffer<Point> points_;
    Buffer<Node> nodes_;
};

template <class F>
void PointTree::for_each_in(std::uint32_t number, const double* place, double square, F f) const {
    const Node& node = nodes_[number];
    if (!(square_to(node, place) <= square)) return;
    if (node.second != 0) {
        for_each_in(number + 1, place, square, f);
        for_each_in(node.second, place, square, f);
        return;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i)
        if (square_to(points_[i].x, place) <= square) f(points_[i].number);
}

}  // namespace mgdt
