// SPDX-License-Identifier: MIT
// An array that several threads write at once.
#pragma once

#include <atomic>
#include <new>
#include <type_traits>

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
    ~AtomicArray() { allocator_.release(items_, bytes_, alignof(Item)); }

    std::atomic<T>& operator[](std::size_t i) noexcept { return items_[i]; }

  private:
    using Item = std::atomic<T>;
    static_assert(std::is_trivially_destructible_v<Item>);

    Allocator& allocator_;
    const std::size_t bytes_;
    Item* const items_;
};

}  // namespace mgdt
