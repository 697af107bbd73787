// SPDX-License-Identifier: MIT
// An array of atomics, which several threads may write at the same time.
#pragma once

#include <memory>
#include <new>

#include "platform/atomic.hpp"
#include "platform/memory.hpp"

namespace mgdt {

template <class T>
class AtomicArray {
  public:
    AtomicArray(Allocator& allocator, std::size_t size)
        : allocator_(allocator),
          bytes_(size * sizeof(Item)),
          items_(static_cast<Item*>(allocator.allocate(bytes_, alignof(Item)))) {
        for (std::size_t i = 0; i < size; ++i) new (&items_[i]) Item(T());
    }
    AtomicArray(const AtomicArray&) = delete;
    AtomicArray& operator=(const AtomicArray&) = delete;
    ~AtomicArray() {
        std::destroy_n(items_, bytes_ / sizeof(Item));
        allocator_.release(items_, bytes_, alignof(Item));
    }

    Atomic<T>& operator[](std::size_t i) noexcept { return items_[i]; }

  private:
    using Item = Atomic<T>;

    Allocator& allocator_;
    const std::size_t bytes_;
    Item* const items_;
};

}  // namespace mgdt
