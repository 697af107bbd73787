// SPDX-License-Identifier: MIT
#include "platform/loan.hpp"

namespace mgdt {

void* Loan::obtain(std::size_t bytes, std::size_t align, void* loan) {
    Loan& from = *static_cast<Loan*>(loan);
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
    receive(&from.taken_);
    return from.begin_ + begin;
}

void Loan::give_back(void* p, std::size_t bytes, std::size_t align, void* loan) {
    Loan& from = *static_cast<Loan*>(loan);
    const auto address = reinterpret_cast<std::size_t>(p),
               begin = reinterpret_cast<std::size_t>(from.begin_);
    if (address - begin >= from.bytes_) {
        from.beyond_.release(p, bytes, align);
        return;
    }
    // The last one serves again.
    std::size_t end = address - begin + bytes;
    hand_over(&from.taken_);
    from.taken_.compare_exchange_strong(end, address - begin, std::memory_order_release,
                                        std::memory_order_relaxed);
}

}  // namespace mgdt
