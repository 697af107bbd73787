// SPDX-License-Identifier: MIT
// The memory of a handle: an allocator that counts and limits, and a growable array that uses it.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

#include "mgdt/mgdt.h"
#include "platform/atomic.hpp"
#include "platform/compiler.hpp"
#include "platform/strict.hpp"

namespace mgdt {

// The size of `count` objects. Throws std::bad_alloc if it overflows.
inline std::size_t bytes_of(std::uint64_t count, std::size_t each) {
    if (count > static_cast<std::size_t>(-1) / each) throw std::bad_alloc();
    return static_cast<std::size_t>(count) * each;
}
// Converts a memory limit to std::size_t; larger values are clamped.
inline std::size_t limit_of(std::int64_t bytes) noexcept {
    constexpr std::uint64_t most = static_cast<std::size_t>(-1);
    const auto wanted = static_cast<std::uint64_t>(bytes);
    return static_cast<std::size_t>(wanted < most ? wanted : most);
}

// All memory of a handle passes through its Allocator. An allocation throws std::bad_alloc if the
// source refuses it, or if it would exceed the limit. Const calls allocate temporary memory on
// several threads at the same time, so counters are atomic.
class Allocator {
  public:
    Allocator() noexcept = default;
    Allocator(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user) noexcept
        : alloc_(alloc), release_(release), user_(user) {}
    Allocator(const Allocator&) = delete;
    Allocator& operator=(const Allocator&) = delete;

    // `remaps` is a hint that the block replaces another block and will probably be replaced by a
    // larger one.
    void* allocate(std::size_t bytes, std::size_t align, bool remaps = false);
    void release(void* p, std::size_t bytes, std::size_t align) noexcept;
    // Grows or shrinks a block. The first `used` bytes keep their values. Blocks of 1 MiB or more
    // from the default allocator move by remapping pages, without a copy, unless they are in the
    // heap of the C library.
    void* reallocate(void* p, std::size_t bytes, std::size_t used, std::size_t new_bytes,
                     std::size_t align);

    // Asks the system to provide all pages of a part of a block at once, which costs a third less
    // than one page fault per page. The call is a hint; it has an effect only for blocks of 1 MiB
    // or more from the default allocator.
    void prefault(void* part, std::size_t part_bytes, std::size_t block_bytes,
                  std::size_t align) const noexcept;

    std::size_t bytes() const noexcept { return bytes_.load(std::memory_order_relaxed); }
    std::size_t peak() const noexcept { return peak_.load(std::memory_order_relaxed); }
    std::size_t limit() const noexcept { return limit_; }
    void set_limit(std::size_t bytes) noexcept { limit_ = bytes; }
    // Counts a block that was obtained elsewhere, such as the handle itself.
    void count(std::size_t bytes);

    // Call the source without counting. The memory of a handle is obtained so, since the handle
    // contains the allocator.
    static void* obtain(mgdt_alloc_fn alloc, void* user, std::size_t bytes, std::size_t align,
                        bool remaps = false) noexcept;
    static void give_back(mgdt_free_fn release, void* user, void* p, std::size_t bytes,
                          std::size_t align) noexcept;
    // Functions for a second allocator that takes its memory from a first one. The first allocator
    // is the `user` of the second.
    static void* allocate_from(std::size_t bytes, std::size_t align, void* allocator) noexcept;
    static void release_to(void* p, std::size_t bytes, std::size_t align, void* allocator) noexcept;
    mgdt_alloc_fn allocate_function() const noexcept { return alloc_; }
    mgdt_free_fn release_function() const noexcept { return release_; }
    void* user() const noexcept { return user_; }

  private:
    void discount(std::size_t bytes) noexcept;

    mgdt_alloc_fn alloc_ = nullptr;
    mgdt_free_fn release_ = nullptr;
    void* user_ = nullptr;
    std::size_t limit_ = 0;
    Atomic<std::size_t> bytes_{0};
    Atomic<std::size_t> peak_{0};
};

// A growable array of trivially copyable elements. New elements are uninitialised.
template <class T>
class Buffer {
    static_assert(std::is_trivially_copyable_v<T>, "Buffer moves elements as bytes");

  public:
    explicit Buffer(Allocator& allocator) noexcept : allocator_(&allocator) {}
    // An array of `size` elements that are about to be written. Its pages are prefaulted.
    Buffer(Allocator& allocator, std::size_t size) : allocator_(&allocator) {
        resize(size);
        prefault(0, size);
    }
    Buffer(Buffer&& other) noexcept
        : allocator_(other.allocator_),
          data_(std::exchange(other.data_, nullptr)),
          size_(std::exchange(other.size_, 0)),
          capacity_(std::exchange(other.capacity_, 0)) {}
    // Both arrays have the same allocator: an array from another one would not outlive it.
    Buffer& operator=(Buffer&& other) noexcept {
        assert(allocator_ == other.allocator_ && "the array belongs to another allocator");
        if (this != &other) {
            reset();
            data_ = std::exchange(other.data_, nullptr);
            size_ = std::exchange(other.size_, 0);
            capacity_ = std::exchange(other.capacity_, 0);
        }
        return *this;
    }
    ~Buffer() { reset(); }

    MGDT_ALWAYS_INLINE T* data() noexcept { return data_; }
    MGDT_ALWAYS_INLINE const T* data() const noexcept { return data_; }
    MGDT_ALWAYS_INLINE T& operator[](std::size_t i) noexcept {
        assert(i < size_ && "the index is beyond the array");
        return data_[i];
    }
    MGDT_ALWAYS_INLINE const T& operator[](std::size_t i) const noexcept {
        assert(i < size_ && "the index is beyond the array");
        return data_[i];
    }
    MGDT_ALWAYS_INLINE T* begin() noexcept { return data_; }
    MGDT_ALWAYS_INLINE T* end() noexcept { return data_ + size_; }
    MGDT_ALWAYS_INLINE const T* begin() const noexcept { return data_; }
    MGDT_ALWAYS_INLINE const T* end() const noexcept { return data_ + size_; }
    MGDT_ALWAYS_INLINE T& back() noexcept {
        assert(size_ > 0 && "an empty array has no last element");
        return data_[size_ - 1];
    }
    MGDT_ALWAYS_INLINE const T& back() const noexcept {
        assert(size_ > 0 && "an empty array has no last element");
        return data_[size_ - 1];
    }
    MGDT_ALWAYS_INLINE std::size_t size() const noexcept { return size_; }
    MGDT_ALWAYS_INLINE std::size_t capacity() const noexcept { return capacity_; }
    MGDT_ALWAYS_INLINE bool empty() const noexcept { return size_ == 0; }
    Allocator& allocator() const noexcept { return *allocator_; }

    // Sets the capacity, which is at least the size.
    void set_capacity(std::size_t capacity) {
        if (capacity < size_) capacity = size_;
        if (capacity == capacity_) return;
        if (capacity > static_cast<std::size_t>(-1) / item_size) throw std::bad_alloc();
        data_ = static_cast<T*>(allocator_->reallocate(
            data_, capacity_ * item_size, size_ * item_size, capacity * item_size, alignment));
        capacity_ = capacity;
    }
    void reserve(std::size_t capacity) {
        if (capacity > capacity_) set_capacity(capacity);
    }
    // Makes room for `capacity` elements. The capacity grows by at least half, so that repeated
    // calls take linear time. If that allocation is refused, the capacity grows to exactly
    // `capacity`.
    void grow(std::size_t capacity) {
        if (capacity <= capacity_) return;
        const std::size_t generous = capacity_ + capacity_ / 2;
        if (generous > capacity) {
            try {
                set_capacity(generous);
                return;
            } catch (const std::bad_alloc&) {
            }
        }
        set_capacity(capacity);
    }
    // Prefaults the pages of elements that are about to be written for the first time.
    void prefault(std::size_t begin, std::size_t end) noexcept {
        assert(end <= capacity_ && "pages beyond the array");
        if (begin < end)
            allocator_->prefault(data_ + begin, (end - begin) * item_size, capacity_ * item_size,
                                 alignment);
    }
    void resize(std::size_t size) {
        reserve(size);
        size_ = size;
    }
    // Copies the elements of an array, which may have another allocator.
    void copy(const Buffer& other) {
        resize(other.size_);
        if (size_ > 0) std::memcpy(data_, other.data_, size_ * item_size);
    }
    void resize(std::size_t size, const T& value) {
        const std::size_t old = size_;
        resize(size);
        for (std::size_t i = old; i < size; ++i) data_[i] = value;
    }
    void push_back(const T& value) {
        const T copy = value;
        grow(size_ + 1);
        data_[size_++] = copy;
    }
    // Changes the size, which is at most the capacity. Never allocates.
    MGDT_ALWAYS_INLINE void resize_within_capacity(std::size_t size) noexcept {
        assert(size <= capacity_ && "the size is beyond the capacity");
        size_ = size;
    }
    MGDT_ALWAYS_INLINE void pop_back() noexcept {
        assert(size_ > 0 && "an empty array has no last element");
        --size_;
    }
    void clear() noexcept { size_ = 0; }
    // Gives unused capacity back, if the allocator can shrink the block.
    void shrink() noexcept {
        if (size_ == 0) return reset();
        try {
            set_capacity(size_);
        } catch (const std::bad_alloc&) {
            // The allocator refused a smaller block: keep the larger one.
        }
    }
    void reset() noexcept {
        if (data_) allocator_->release(data_, capacity_ * item_size, alignment);
        data_ = nullptr;
        size_ = capacity_ = 0;
    }

  private:
    // The size of a cache line: records of 32 bytes and vectors do not cross lines.
    static constexpr std::size_t alignment = 64;
    // NOLINTNEXTLINE(bugprone-sizeof-expression): the elements may be pointers
    static constexpr std::size_t item_size = sizeof(T);

    Allocator* allocator_;
    T* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

}  // namespace mgdt
