// SPDX-License-Identifier: MIT
// Finds triangles by their corners.
#pragma once

#include <algorithm>

#include "platform/memory.hpp"
#include "platform/no_index.hpp"

namespace mgdt {

class TriangleTable {
  public:
    // `triangles` has three corners for each, which are less than `vertices`.
    TriangleTable(const Buffer<std::uint32_t>& triangles, std::size_t vertices,
                  Allocator& allocator)
        : first_(allocator, vertices + 1), entries_(allocator, triangles.size() / 3) {
        std::fill(first_.begin(), first_.end(), 0u);
        const auto least = [&](std::size_t i) {
            const std::uint32_t* const v = triangles.begin() + 3 * i;
            return std::min({v[0], v[1], v[2]});
        };
        for (std::size_t i = 0; i < entries_.size(); ++i) ++first_[least(i)];
        // The entries of a corner are filled from the last one to the first.
        for (std::size_t v = 0, sum = 0; v <= vertices; ++v)
            first_[v] = static_cast<std::uint32_t>(sum += first_[v]);
        for (std::size_t i = entries_.size(); i-- > 0;) {
            const std::uint32_t* const v = triangles.begin() + 3 * i;
            const std::uint32_t a = least(i), c = std::max({v[0], v[1], v[2]});
            entries_[--first_[a]] = {v[0] ^ v[1] ^ v[2] ^ a ^ c, c, static_cast<std::uint32_t>(i)};
        }
    }

    // The number of the first triangle with these corners in any order, or no_index.
    std::uint32_t find(std::uint32_t a, std::uint32_t b, std::uint32_t c) const noexcept {
        const std::uint32_t least = std::min({a, b, c}), most = std::max({a, b, c}),
                            middle = a ^ b ^ c ^ least ^ most;
        if (least + std::size_t{1} >= first_.size()) return no_index;
        for (std::uint32_t i = first_[least]; i < first_[least + 1]; ++i)
            if (entries_[i].middle == middle && entries_[i].most == most) return entries_[i].number;
        return no_index;
    }

  private:
    struct Entry {
        std::uint32_t middle, most;  // the other corners
        std::uint32_t number;
    };
    Buffer<std::uint32_t> first_;  // the first entry of each least corner
    Buffer<Entry> entries_;
};

}  // namespace mgdt
