// SPDX-License-Identifier: MIT
// An array of a fixed number of objects that cannot be moved.
#pragma once

#include <new>

#include "platform/memory.hpp"

namespace mgdt {

template <class T>
class Objects {
  public:
    // Constructs each object from the same arguments.
    template <class... Arguments>
    Objects(Allocator& allocator, std::size_t count, const Arguments&... arguments)
        : allocator_(allocator), capacity_(count) {
        if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_alloc();
        items_ = static_cast<T*>(allocator.allocate(capacity_ * sizeof(T), alignof(T)));
        try {
            for (; size_ < capacity_; ++size_) new (items_ + size_) T(arguments...);
        } catch (...) {
            reset();
            throw;
        }
    }
    Objects(const Objects&) = delete;
    Objects& operator=(const Objects&) = delete;
    ~Objects() { reset(); }

    T& operator[](std::size_t i) noexcept { return items_[i]; }
    const T& operator[](std::size_t i) const noexcept { return items_[i]; }
    std::size_t size() const noexcept { return size_; }
    T* begin() noexcept { return items_; }
    T* end() noexcept { return items_ + size_; }
    const T* begin() const noexcept { return items_; }
    const T* end() const noexcept { return items_ + size_; }

  private:
    void reset() noexcept {
        while (size_ > 0) items_[--size_].~T();
        allocator_.release(items_, capacity_ * sizeof(T), alignof(T));
    }

    Allocator& allocator_;
    T* items_;
    std::size_t size_ = 0;
    const std::size_t capacity_;
};

}  // namespace mgdt
