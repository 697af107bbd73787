// SPDX-License-Identifier: MIT
// Disjoint sets (union-find) of the numbers 0 to n - 1. The structure is lock-free: several threads
// may join sets at the same time.
#pragma once

#include <cstdint>

#include "parallel/atomic_array.hpp"

namespace mgdt {

class DisjointSets {
  public:
    // n sets of one number each.
    DisjointSets(Allocator& allocator, std::size_t n) : above_(allocator, n) {}

    // Joins the sets of a and b. Returns false if a and b are in the same set already.
    bool join(std::uint32_t a, std::uint32_t b) noexcept {
        for (;;) {
            a = least(a);
            b = least(b);
            if (a == b) return false;
            if (a < b) std::swap(a, b);
            // The exchange fails if another thread has joined a's set to another set in the
            // meantime.
            std::uint32_t alone = 0;
            if (above_[a].compare_exchange_weak(alone, a - b, std::memory_order_relaxed))
                return true;
        }
    }
    // The least number in the set of i. While other threads join sets, the result may be the least
    // number of a subset.
    std::uint32_t least(std::uint32_t i) noexcept {
        for (;;) {
            const std::uint32_t step = above_[i].load(std::memory_order_relaxed);
            if (step == 0) return i;
            const std::uint32_t next = above_[i - step].load(std::memory_order_relaxed);
            // Path halving links i to its grandparent. If another thread has changed the link of i,
            // the new link serves as well.
            std::uint32_t seen = step;
            if (next != 0)
                above_[i].compare_exchange_weak(seen, step + next, std::memory_order_relaxed);
            i -= step + next;
        }
    }

  private:
    // For each number, its difference from its parent, which is a lower number in the same set. The
    // difference of a root is 0.
    AtomicArray<std::uint32_t> above_;
};

}  // namespace mgdt
