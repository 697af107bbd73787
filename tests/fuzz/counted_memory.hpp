// SPDX-License-Identifier: MIT
// An allocator for a handle that refuses when it is told to and knows what is still held.
#pragma once

#include <cstdlib>
#include <cstring>
#include <mutex>
#include <unordered_map>
#include <utility>

#include "input.hpp"

namespace fuzz {

class CountedMemory {
  public:
    CountedMemory() = default;
    CountedMemory(const CountedMemory&) = delete;
    CountedMemory& operator=(const CountedMemory&) = delete;
    ~CountedMemory() { FUZZ_REQUIRE(live_.empty(), std::to_string(live_.size()) + " blocks leak"); }

    struct Refusal {
        unsigned left = 0;  // requests until one is refused; 0 for never
        bool all = false;   // and those after it
    };

    // The n-th request from now on is refused, and if `all` those after it; 0 for none.
    void refuse(unsigned n, bool all) { refusal_ = {n, all}; }
    bool is_armed() const { return refusal_.left != 0; }
    Refusal pause() { return std::exchange(refusal_, Refusal()); }
    void resume(Refusal refusal) { refusal_ = refusal; }

    // Is called at each request and for each block that comes back, but for the handle's own.
    void set_visitor(void (*visit)(void* user), void* user) {
        visit_ = visit;
        user_ = user;
    }
    void set_handle(const void* handle) { handle_ = handle; }

    static void* obtain(std::size_t size, std::size_t align, void* user) {
        CountedMemory& self = *static_cast<CountedMemory*>(user);
        if (self.visit_) self.visit_(self.user_);
        const std::lock_guard<std::mutex> lock(self.mutex_);
        FUZZ_REQUIRE(align != 0 && (align & (align - 1)) == 0, std::to_string(align));
        if (self.refusal_.left == 1) {
            if (!self.refusal_.all) self.refusal_.left = 0;
            return nullptr;
        }
        if (self.refusal_.left > 1) --self.refusal_.left;
        void* p = nullptr;
        if (posix_memalign(&p, align < sizeof p ? sizeof p : align, size) != 0) return nullptr;
        std::memset(p, 0xA5, size);  // what is read before it is written is a wild number
        self.live_[p] = {size, align};
        return p;
    }

    static void release(void* p, std::size_t size, std::size_t align, void* user) {
        CountedMemory& self = *static_cast<CountedMemory*>(user);
        if (self.visit_ && p != self.handle_) self.visit_(self.user_);
        const std::lock_guard<std::mutex> lock(self.mutex_);
        const auto found = self.live_.find(p);
        FUZZ_REQUIRE(found != self.live_.end(), "a block is freed that was not given");
        FUZZ_REQUIRE(found->second.size == size && found->second.align == align,
                     "a block is freed with another size or alignment");
        self.live_.erase(found);
        std::free(p);
    }

  private:
    struct Block {
        std::size_t size, align;
    };
    std::mutex mutex_;
    std::unordered_map<void*, Block> live_;
    Refusal refusal_;
    void (*visit_)(void* user) = nullptr;
    void* user_ = nullptr;
    const void* handle_ = nullptr;
};

}  // namespace fuzz
