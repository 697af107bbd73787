// SPDX-License-Identifier: MIT
#include "memory_count.hpp"

#include <malloc.h>

#include <cstdlib>
#include <new>

namespace fuzz {

void MemoryCount::add(void* p) {
    now_ += static_cast<std::ptrdiff_t>(malloc_usable_size(p));
    if (now_ > peak_) peak_ = now_;
}

void MemoryCount::take(void* p) {
    now_ -= static_cast<std::ptrdiff_t>(malloc_usable_size(p));
}

}  // namespace fuzz

// Every form but the aligned ones, since a sanitizer brings those that are not here.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    void* const p = std::malloc(size == 0 ? 1 : size);
    if (p) fuzz::MemoryCount::add(p);
    return p;
}
void* operator new(std::size_t size) {
    void* const p = operator new(size, std::nothrow);
    if (!p) throw std::bad_alloc();
    return p;
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return operator new(size, std::nothrow);
}
void* operator new[](std::size_t size) {
    return operator new(size);
}
void operator delete(void* p) noexcept {
    if (p) fuzz::MemoryCount::take(p);
    std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
    operator delete(p);
}
void operator delete[](void* p) noexcept {
    operator delete(p);
}
void operator delete[](void* p, std::size_t) noexcept {
    operator delete(p);
}
