// SPDX-License-Identifier: MIT
// The numbers by which a file's elements name its nodes, all positive. They are mostly 1 to n,
// which takes no memory; others are sorted, so that no choice of numbers makes the search slow.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace mgdt::cli {

class NodeNumbers {
  public:
    // Takes the number of the next node. fail(message), which throws, is called if it is seen at
    // once that it came before; settle() sees all of them.
    template <class Fail>
    void add(std::int64_t number, const Fail& fail) {
        const std::int64_t index = count_++;
        if (others_.empty() && number == index + 1) {
            ++dense_;
            return;
        }
        const bool follows = others_.empty() || others_.back().first < number;
        if (number <= dense_ || (!follows && others_.back().first == number)) twice(number, fail);
        is_sorted_ = is_sorted_ && follows;
        others_.emplace_back(number, index);
    }
    // To be called between add() and find().
    template <class Fail>
    void settle(const Fail& fail) {
        if (is_sorted_) return;
        std::sort(others_.begin(), others_.end());
        is_sorted_ = true;
        for (std::size_t i = 1; i < others_.size(); ++i)
            if (others_[i].first == others_[i - 1].first) twice(others_[i].first, fail);
    }
    // Which node has a number; fails if there is none.
    template <class Fail>
    std::int64_t find(std::int64_t number, const Fail& fail) const {
        if (number > 0 && number <= dense_) return number - 1;
        const auto found =
            std::lower_bound(others_.begin(), others_.end(), std::make_pair(number, INT64_MIN));
        if (found == others_.end() || found->first != number)
            fail(fmt::format("there is no node {}", number));
        return found->second;
    }

  private:
    template <class Fail>
    static void twice(std::int64_t number, const Fail& fail) {
        fail(fmt::format("node {} comes twice", number));
    }
    std::int64_t count_ = 0, dense_ = 0;                         // 1 to dense_ came first
    std::vector<std::pair<std::int64_t, std::int64_t>> others_;  // and their nodes
    bool is_sorted_ = true;
};

}  // namespace mgdt::cli
