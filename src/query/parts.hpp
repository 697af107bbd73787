// SPDX-License-Identifier: MIT
// Parts that become one another's, by the first member of each.
#pragma once

#include <algorithm>

#include "platform/memory.hpp"

namespace mgdt {

class Parts {
  public:
    Parts(Allocator& allocator, std::size_t members) : parent_(allocator, members) {
        for (std::uint32_t i = 0; i < members; ++i) parent_[i] = i;
    }
    // False if the two are in one part already.
    bool join(std::uint32_t a, std::uint32_t b) noexcept {
        a = first_of(a);
        b = first_of(b);
        if (a == b) return false;
        parent_[std::max(a, b)] = std::min(a, b);
        return true;
    }

  private:
    std::uint32_t first_of(std::uint32_t i) noexcept {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    Buffer<std::uint32_t> parent_;
};

}  // namespace mgdt
