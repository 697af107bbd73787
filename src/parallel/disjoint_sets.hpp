// SPDX-License-Identifier: MIT
// Disjoint sets (union-find) of the numbers 0 to n - 1, lock-free: several threads may join them.
#pragma once

#include <cstdint>

#include "parallel/atomic_array.hpp"

namespace mgdt {

class DisjointSets {
  public:
    // n sets of one number each.
    DisjointSets(Allocator& allocator, std::size_t n) : above_(allocator, n) {}

    // Joins the sets of a and b. Returns false if they are the same set already.
    bool join(std::uint32_t a, std::uint32_t b) noexcept {
        for (;;) {
            a = least(a);
            b = least(b);
            if (a == b) return false;
            if (a < b) std::swap(a, b);
            // This fails if another thread has joined a's set to another one meanwhile.
            std::uint32_t alone = 0;
            if (above_[a].compare_exchange_weak(alone, a - b, std::memory_order_relaxed))
                return true;
        }
    }
    // The least number in the set of i. While other threads join, it may be that of a subset.
    std::uint32_t least(std::uint32_t i) noexcept {
        for (;;) {
            const std::uint32_t step = above_[i].load(std::memory_order_relaxed);
            if (step == 0) return i;
            const std::uint32_t next = above_[i - step].load(std::memory_order_relaxed);
            // Path halving. If another thread has changed the entry, its value serves as well.
            std::uint32_t seen = step;
            if (next != 0)
                above_[i].compare_exchange_weak(seen, step + next, std::memory_order_relaxed);
            i -= step + next;
        }
    }

  private:
    // The difference of each number to its parent, a lower number in its set; 0 for the root.
    AtomicArray<std::uint32_t> above_;
};

}  // namespace mgdt
