// SPDX-License-Identifier: MIT
#include "platform/borrowed_arena.hpp"

namespace mgdt {

void* BorrowedArena::obtain(std::size_t bytes, std::size_t align, void* arena) {
    BorrowedArena& from = *static_cast<BorrowedArena*>(arena);
    std::size_t taken = from.taken_.load(std::memory_order_relaxed), begin;
    do {
        const std::size_t address = reinterpret_cast<std::size_t>(from.begin_) + taken;
        begin = taken + ((0 - address) & (align - 1));
        if (begin > from.bytes_ || bytes > from.bytes_ - begin) {
            try {
                return from.beyond_.allocate(bytes, align);
            } catch (const std::bad_alloc&) {
                return nullptr;
            }
        }
    } while (!from.taken_.compare_exchange_weak(taken, begin + bytes, std::memory_order_acquire,
                                                std::memory_order_relaxed));
    annotate_acquire(&from.taken_);
    return from.begin_ + begin;
}

void BorrowedArena::give_back(void* p, std::size_t bytes, std::size_t align, void* arena) {
    BorrowedArena& from = *static_cast<BorrowedArena*>(arena);
    const auto address = reinterpret_cast<std::size_t>(p),
               begin = reinterpret_cast<std::size_t>(from.begin_);
    if (address - begin >= from.bytes_) {
        from.beyond_.release(p, bytes, align);
        return;
    }
    // Only the last block can be reused.
    std::size_t end = address - begin + bytes;
    annotate_release(&from.taken_);
    from.taken_.compare_exchange_strong(end, address - begin, std::memory_order_release,
                                        std::memory_order_relaxed);
}

}  // namespace mgdt
