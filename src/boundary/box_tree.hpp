// SPDX-License-Identifier: MIT
// A tree of boxes, which finds those that overlap each other or a given one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "mesh/box_nodes.hpp"
#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

class BoxTree {
  public:
    // Makes the tree, in O(n log n). The boxes must not change while the tree is used. A request to
    // stop ends this call.
    BoxTree(Allocator& allocator, const Buffer<BoundingBox>& boxes, const StopRequest& stop);

    // Calls f(i, j, member) for each pair of boxes i < j that overlap, on all members of the team
    // at the same time. The time is usually O(n) plus that of the calls. It is longer if large
    // parts of the tree overlap although their boxes do not, as for crossing layers of wires.
    template <class F>
    void for_each_pair(Team& team, StageProgress& progress, F f) const;

    // Calls f(i) for each box i that overlaps a given one.
    template <class F>
    void for_each_at(const BoundingBox& box, F f) const;

    // Finds the least value of the items in the boxes: calls f(i) for each box i whose items may
    // have a value of at most `bound`. least(box) is a lower bound on the values in a box; f
    // returns the new bound, which never increases.
    template <class Least, class F>
    void for_each_below(double bound, const Least& least, F f) const;

  private:
    static constexpr std::uint32_t most_in_leaf = 6;

    struct Pair {
        std::uint32_t a, b;  // two nodes, or a node with itself
    };
    // Replaces a pair of nodes by pairs of their children. Returns false if both are leaves.
    bool divide(Pair pair, Buffer<Pair>& into) const;
    template <class F>
    void compare_leaves(Pair pair, F f) const;

    Allocator& allocator_;
    const Buffer<BoundingBox>& boxes_;
    Buffer<std::uint32_t> order_;
    Buffer<BoxNode> nodes_;
};

template <class F>
void BoxTree::compare_leaves(Pair pair, F f) const {
    const BoxNode &a = nodes_[pair.a], &b = nodes_[pair.b];
    for (std::uint32_t i = a.begin; i < a.end; ++i)
        for (std::uint32_t j = pair.a == pair.b ? i + 1 : b.begin; j < b.end; ++j)
            if (const std::uint32_t k = order_[i], l = order_[j]; boxes_[k].overlaps(boxes_[l]))
                f(std::min(k, l), std::max(k, l));
}

template <class F>
void BoxTree::for_each_at(const BoundingBox& box, F f) const {
    Buffer<std::uint32_t> stack(allocator_);
    if (!nodes_.empty()) stack.push_back(0);
    while (!stack.empty()) {
        const std::uint32_t number = stack.back();
        const BoxNode& node = nodes_[number];
        stack.pop_back();
        if (!node.box.overlaps(box)) continue;
        if (!node.is_leaf()) {
            stack.push_back(node.second);
            stack.push_back(number + 1);
            continue;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i)
            if (boxes_[order_[i]].overlaps(box)) f(order_[i]);
    }
}

template <class Least, class F>
void BoxTree::for_each_below(double bound, const Least& least, F f) const {
    struct Visit {
        std::uint32_t node;
        double least;
    };
    Buffer<Visit> stack(allocator_);
    if (!nodes_.empty()) stack.push_back({0, least(nodes_[0].box)});
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        if (visit.least > bound) continue;
        const BoxNode& node = nodes_[visit.node];
        if (!node.is_leaf()) {
            // The more promising child comes first.
            Visit first = {visit.node + 1, least(nodes_[visit.node + 1].box)};
            Visit second = {node.second, least(nodes_[node.second].box)};
            if (second.least < first.least) std::swap(first, second);
            stack.push_back(second);
            stack.push_back(first);
            continue;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i)
            if (least(boxes_[order_[i]]) <= bound) bound = f(order_[i]);
    }
}

template <class F>
void BoxTree::for_each_pair(Team& team, StageProgress& progress, F f) const {
    if (nodes_.empty()) return;
    // Divides the pairs of nodes, level by level, until there are enough for the team.
    constexpr std::size_t enough = 4096;
    Buffer<Pair> pairs(allocator_), next(allocator_);
    pairs.push_back({0, 0});
    for (bool is_divided = true; is_divided && pairs.size() < enough;) {
        is_divided = false;
        next.clear();
        for (const Pair& pair : pairs) {
            if (divide(pair, next))
                is_divided = true;
            else
                next.push_back(pair);
        }
        std::swap(pairs, next);
    }
    constexpr std::size_t pairs_per_thread = 64;
    const StopRequest stop = progress.stop_request();
    team.split(
        pairs.size(), pairs_per_thread, [&](std::size_t begin, std::size_t end, unsigned member) {
            Buffer<Pair> stack(allocator_);
            std::size_t steps = 0;
            for (std::size_t p = begin; p < end; ++p) {
                progress.step(p, begin, end, member);
                stack.push_back(pairs[p]);
                while (!stack.empty()) {
                    stop.poll_in_step(steps++);
                    const Pair pair = stack.back();
                    stack.pop_back();
                    if (!divide(pair, stack))
                        compare_leaves(pair,
                                       [&](std::uint32_t i, std::uint32_t j) { f(i, j, member); });
                }
            }
        });
}

}  // namespace mgdt
