// SPDX-License-Identifier: MIT
// An object for each member of a team.
#pragma once

#include <new>

#include "parallel/team.hpp"
#include "platform/memory.hpp"

namespace mgdt {

template <class T>
class PerMember {
  public:
    template <class... Arguments>
    PerMember(const Team& team, Allocator& allocator, const Arguments&... arguments)
        : allocator_(allocator), capacity_(team.size()) {
        items_ = static_cast<T*>(allocator.allocate(capacity_ * sizeof(T), alignof(T)));
        try {
            for (; size_ < capacity_; ++size_) new (items_ + size_) T(arguments...);
        } catch (...) {
            reset();
            throw;
        }
    }
    PerMember(const PerMember&) = delete;
    PerMember& operator=(const PerMember&) = delete;
    ~PerMember() { reset(); }

    T& operator[](unsigned member) noexcept { return items_[member]; }

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
