// SPDX-License-Identifier: MIT
// The positive numbers by which the elements of a file refer to its nodes. Usually they are 1 to n,
// which takes no memory. Others are sorted, so that no choice of numbers makes the search slow.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace mgdt::cli {

class NodeNumbers {
  public:
    // `what` has the numbers, for messages.
    explicit NodeNumbers(const char* what = "node") : what_(what) {}

    // Adds the number of the next node. Calls fail(message), which throws, if the number was added
    // before.
    template <class Fail>
    void add(std::int64_t number, const Fail& fail) {
        const std::int64_t node = count_++;
        if (rising_.empty() && late_.empty() && number == node + 1) {
            ++dense_;
            return;
        }
        if (find_if(number) >= 0) fail(fmt::format("{} {} comes twice", what_, number));
        if (rising_.empty() || rising_.back().first < number)
            rising_.emplace_back(number, node);
        else
            late_.emplace(number, node);
    }
    // The node with a number. Calls fail(message) if there is none.
    template <class Fail>
    std::int64_t find(std::int64_t number, const Fail& fail) const {
        const std::int64_t node = find_if(number);
        if (node < 0) fail(fmt::format("there is no {} {}", what_, number));
        return node;
    }
    // The node with a number, or -1.
    std::int64_t find_if(std::int64_t number) const {
        if (number > 0 && number <= dense_) return number - 1;
        const auto found =
            std::lower_bound(rising_.begin(), rising_.end(), std::make_pair(number, INT64_MIN));
        if (found != rising_.end() && found->first == number) return found->second;
        const auto late = late_.find(number);
        return late == late_.end() ? -1 : late->second;
    }

  private:
    const char* what_;
    std::int64_t count_ = 0, dense_ = 0;  // the first numbers are 1 to dense_
    // Numbers that are greater than all before them.
    std::vector<std::pair<std::int64_t, std::int64_t>> rising_;
    std::map<std::int64_t, std::int64_t> late_;  // all other numbers
};

}  // namespace mgdt::cli
