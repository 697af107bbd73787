// SPDX-License-Identifier: MIT
// An allocator that gives so many blocks and then refuses.
#pragma once

#include <cstddef>
#include <new>

namespace mgdt_tests {

struct LimitedBlocks {
    std::size_t left;           // blocks until the allocator refuses
    bool refuses_once = false;  // whether it gives more blocks after the first refusal
    std::size_t refused = 0;
    std::size_t held = 0;  // blocks that were not given back

    // Counts anew.
    void refuse_after(std::size_t blocks) {
        left = blocks;
        refused = 0;
    }

    // `user` is the object.
    static void* take(std::size_t size, std::size_t align, void* user) {
        auto& self = *static_cast<LimitedBlocks*>(user);
        if (self.left == 0 && !(self.refuses_once && self.refused > 0)) {
            ++self.refused;
            return nullptr;
        }
        if (self.left > 0) --self.left;
        ++self.held;
        return ::operator new(size, std::align_val_t(align), std::nothrow);
    }
    static void give_back(void* p, std::size_t, std::size_t align, void* user) {
        --static_cast<LimitedBlocks*>(user)->held;
        ::operator delete(p, std::align_val_t(align));
    }
};

}  // namespace mgdt_tests
