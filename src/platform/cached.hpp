// SPDX-License-Identifier: MIT
// An object that const calls make on demand. Several threads may ask for it at the same time.
#pragma once

#include "platform/atomic.hpp"
#include "platform/memory.hpp"

namespace mgdt {

template <class T>
class Cached {
  public:
    explicit Cached(Allocator& allocator) noexcept : allocator_(allocator) {}
    Cached(const Cached&) = delete;
    Cached& operator=(const Cached&) = delete;
    ~Cached() { forget(); }

    // Returns the object; makes a T from (allocator, arguments...) if there is none. If several
    // threads make an object, the first object that is published stays, and the other threads
    // destroy their objects.
    template <class... Arguments>
    const T& get(const Arguments&... arguments) {
        T* made = peek();
        if (made) return *made;
        T* mine = nullptr;
        try {
            mine = make(arguments...);
        } catch (const std::bad_alloc&) {
            // Memory may not suffice for the objects of two threads. Use the other thread's object.
            made = peek();
            if (made) return *made;
            throw;
        }
        annotate_release(&value_);
        if (value_.compare_exchange_strong(made, mine, std::memory_order_acq_rel)) return *mine;
        annotate_acquire(&value_);
        destroy(mine);
        return *made;
    }
    // Destroys the object. No other thread may use it.
    void forget() noexcept {
        T* made = value_.exchange(nullptr, std::memory_order_acq_rel);
        if (made) destroy(made);
    }
    // The object, or nullptr if there is none.
    T* peek() noexcept {
        T* made = value_.load(std::memory_order_acquire);
        annotate_acquire(&value_);
        return made;
    }

  private:
    template <class... Arguments>
    T* make(const Arguments&... arguments) {
        void* memory = allocator_.allocate(sizeof(T), alignof(T));
        try {
            return new (memory) T(allocator_, arguments...);
        } catch (...) {
            allocator_.release(memory, sizeof(T), alignof(T));
            throw;
        }
    }
    void destroy(T* value) noexcept {
        value->~T();
        allocator_.release(value, sizeof(T), alignof(T));
    }

    Allocator& allocator_;
    Atomic<T*> value_{nullptr};
};

}  // namespace mgdt
