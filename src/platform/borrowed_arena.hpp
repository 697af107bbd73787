// SPDX-License-Identifier: MIT
// An arena in a block of memory that exists already and is not used for a while. Temporary arrays
// then need no new pages from the system.
#pragma once

#include "platform/memory.hpp"

namespace mgdt {

class BorrowedArena {
  public:
    // An arena of `bytes` at `block`, which has the alignment of a Buffer. Requests that do not fit
    // go to `beyond`.
    BorrowedArena(void* block, std::size_t bytes, Allocator& beyond) noexcept
        : begin_(static_cast<unsigned char*>(block)), bytes_(bytes), beyond_(beyond) {}

    // The allocator of the arena. Several threads may use it, like every Allocator. The blocks that
    // it returns must not outlive the arena.
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
