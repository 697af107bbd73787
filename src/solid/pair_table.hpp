// SPDX-License-Identifier: MIT
// Numbers for unordered pairs of points, such as the ends of edges.
#pragma once

#include <algorithm>
#include <utility>

#include "platform/hash.hpp"
#include "platform/no_index.hpp"
#include "platform/number_table.hpp"

namespace mgdt {

// Gives pairs the numbers 0, 1, 2, ... in the order in which they are added.
class PairTable {
  public:
    explicit PairTable(Allocator& allocator) : pairs_(allocator), table_(allocator) {
        table_.clear(0);
    }

    std::size_t size() const noexcept { return pairs_.size(); }
    void clear() {
        pairs_.clear();
        table_.clear(0);
    }
    // The number of a pair, which is size() before the call if the pair is new.
    std::uint32_t add(std::uint32_t a, std::uint32_t b) {
        const Pair pair = {std::min(a, b), std::max(a, b)};
        table_.reserve(pairs_.size() + 1);
        pairs_.grow(pairs_.size() + 1);
        const std::uint32_t number =
            table_.number(hash(pair), [&](std::uint32_t i) { return is_same(pairs_[i], pair); });
        if (number == pairs_.size()) pairs_.push_back(pair);
        return number;
    }
    // The pair with a number, the lesser point first.
    std::pair<std::uint32_t, std::uint32_t> pair(std::uint32_t number) const noexcept {
        return {pairs_[number].a, pairs_[number].b};
    }
    // The number of a pair, or `no_index`.
    std::uint32_t find(std::uint32_t a, std::uint32_t b) const noexcept {
        if (pairs_.empty()) return no_index;
        const Pair pair = {std::min(a, b), std::max(a, b)};
        return table_.find(hash(pair), [&](std::uint32_t i) { return is_same(pairs_[i], pair); });
    }

  private:
    struct Pair {
        std::uint32_t a, b;
    };
    static bool is_same(const Pair& one, const Pair& other) noexcept {
        return one.a == other.a && one.b == other.b;
    }
    static std::uint32_t hash(const Pair& pair) noexcept {
        return hash_of_words(std::uint64_t{pair.a} << 32 | pair.b);
    }

    Buffer<Pair> pairs_;
    NumberTable table_;
};

}  // namespace mgdt
