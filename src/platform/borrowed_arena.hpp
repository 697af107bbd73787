// SPDX-License-Identifier: MIT
// Scratch memory out of a block that is there already and idle for a while, so that no page is
// asked of the system, and given back to it, for a moment's use.
#pragma once

#include "platform/memory.hpp"

namespace mgdt {

class BorrowedArena {
  public:
    // `bytes` at `block`, which is aligned as Buffers are; what does not fit comes from `beyond`.
    BorrowedArena(void* block, std::size_t bytes, Allocator& beyond) noexcept
        : begin_(static_cast<unsigned char*>(block)), bytes_(bytes), beyond_(beyond) {}

    // Serves several threads at once, as every Allocator. Its blocks end with the arena.
    Allocator& allocator() noexcept { return allocator_; }

  private:
    static void* obtain(std::size_t bytes, std::size_t align, void* arena);
    static void give_back(void* p, std::size_t bytes, std::size_t align, void* arena);

    unsigned char* const begin_;
    const std::size_t bytes_;
    Allocator& beyond_;
    Atomic<std::size_t> taken_{0};
    Allocator allocator_{obtain, give_back, this};
};

}  // namespace mgdt
