// SPDX-License-Identifier: MIT
// Sets of the numbers 0 to n - 1 that several threads join, none waiting for another.
#pragma once

#include <cstdint>

#include "parallel/atomic_array.hpp"

namespace mgdt {

class DisjointSets {
  public:
    // Each number a set of its own.
    DisjointSets(Allocator& allocator, std::size_t n) : above_(allocator, n) {}

    // False if the two are in one set already.
    bool join(std::uint32_t a, std::uint32_t b) noexcept {
        for (;;) {
            a = least(a);
            b = least(b);
            if (a == b) return false;
            if (a < b) std::swap(a, b);
            // Unless another thread has joined a's set to one meanwhile.
            std::uint32_t alone = 0;
            if (above_[a].compare_exchange_weak(alone, a - b, std::memory_order_relaxed))
                return true;
        }
    }
    // The least number of i's set; while others join, of a part of it.
    std::uint32_t least(std::uint32_t i) noexcept {
        for (;;) {
            const std::uint32_t step = above_[i].load(std::memory_order_relaxed);
            if (step == 0) return i;
            const std::uint32_t next = above_[i - step].load(std::memory_order_relaxed);
            // Shortens the way for later calls. If another thread did so first, that serves as
            // well.
            std::uint32_t seen = step;
            if (next != 0)
                above_[i].compare_exchange_weak(seen, step + next, std::memory_order_relaxed);
            i -= step + next;
        }
    }

  private:
    // How far each number lies above one of lower number in its set; 0 for the least.
    AtomicArray<std::uint32_t> above_;
};

}  // namespace mgdt
