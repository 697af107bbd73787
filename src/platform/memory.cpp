// SPDX-License-Identifier: MIT
#include "platform/memory.hpp"

#include <cstdlib>

#include "platform/callback.hpp"

#if defined(__linux__)
#include <sys/mman.h>
#define MGDT_HAVE_MREMAP 1
#endif
#if defined(_WIN32)
#include <malloc.h>
#endif

namespace mgdt {
namespace {

#if MGDT_HAVE_MREMAP
// There are three kinds of blocks. Small blocks come from aligned_alloc(). Large blocks are mapped
// pages: they grow by remapping without a copy, and their memory returns to the system when they
// are freed. Medium blocks come from malloc(), since glibc keeps freed memory for the next handle.
// But a medium block is mapped if it replaces another block or if there is a memory limit, so that
// it can grow without a second block.
constexpr std::size_t page = 4096;
constexpr std::size_t medium = std::size_t{1} << 20, large = std::size_t{1} << 25;
// Medium blocks from malloc() begin at this offset from the beginning of a page, where no mapped
// block begins. The pointer that free() needs is stored before the block.
constexpr std::size_t heap_offset = 64;

constexpr std::size_t page_round(std::size_t bytes) {
    return (bytes + page - 1) & ~(page - 1);
}
constexpr bool is_small(std::size_t bytes, std::size_t align) {
    return bytes < medium || align > page;
}
bool is_mapped(const void* p, std::size_t bytes, std::size_t align) {
    return !is_small(bytes, align) && reinterpret_cast<std::uintptr_t>(p) % page == 0;
}

void* map(std::size_t bytes) noexcept {
    void* const p = mmap(nullptr, page_round(bytes), PROT_READ | PROT_WRITE,
                         MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return p == MAP_FAILED ? nullptr : p;
}

// The function calls malloc(), not aligned_alloc(). When glibc frees a mapped block, it raises its
// threshold for mapping to the size of that block, so malloc() reuses heap memory the next time.
// aligned_alloc() requests more than this size, so it would map new pages each time.
void* obtain_medium(std::size_t bytes) noexcept {
    void* const whole = std::malloc(bytes + page + heap_offset);
    if (!whole) return nullptr;
    const std::uintptr_t at = page_round(reinterpret_cast<std::uintptr_t>(whole)) + heap_offset;
    void** const p = reinterpret_cast<void**>(at);
    p[-1] = whole;
    return p;
}

// Whether malloc() mapped pages for this block alone, so that realloc() remaps the pages. With
// glibc such a block begins 16 or 8 bytes after the beginning of a page. A block in the heap may
// begin there by chance; realloc() copies it then.
bool is_remapped_by_library(const void* p) {
    const void* const whole = static_cast<void* const*>(p)[-1];
    const std::uintptr_t behind = reinterpret_cast<std::uintptr_t>(whole) % page;
    return behind == 8 || behind == 16;
}

// Grows a medium block by realloc(). Returns null if realloc() refuses; the block is unchanged
// then.
void* regrow_medium(void* p, std::size_t used, std::size_t new_bytes) noexcept {
    if (new_bytes > static_cast<std::size_t>(-1) - 2 * page) return nullptr;
    char* const whole = static_cast<char*>(static_cast<void**>(p)[-1]);
    const std::ptrdiff_t offset = static_cast<char*>(p) - whole;
    char* const moved = static_cast<char*>(std::realloc(whole, new_bytes + page + heap_offset));
    if (!moved) return nullptr;
    const std::uintptr_t at = page_round(reinterpret_cast<std::uintptr_t>(moved)) + heap_offset;
    void** const q = reinterpret_cast<void**>(at);
    // Remapping keeps the offset from the beginning of a page.
    if (static_cast<void*>(q) != moved + offset) std::memmove(q, moved + offset, used);
    q[-1] = moved;
    return q;
}
#endif

void* default_obtain(std::size_t bytes, std::size_t align, bool remaps) noexcept {
#if MGDT_HAVE_MREMAP
    if (!is_small(bytes, align)) {
        if (remaps || bytes >= large || align > heap_offset) return map(bytes);
        return obtain_medium(bytes);
    }
#else
    static_cast<void>(remaps);
#endif
#if defined(_WIN32)
    return _aligned_malloc(bytes, align);
#else
    // aligned_alloc() requires a size that is a multiple of the alignment.
    return std::aligned_alloc(align, (bytes + align - 1) & ~(align - 1));
#endif
}

void default_give_back(void* p, std::size_t bytes, std::size_t align) noexcept {
#if MGDT_HAVE_MREMAP
    if (is_mapped(p, bytes, align)) {
        munmap(p, page_round(bytes));
        return;
    }
    if (!is_small(bytes, align)) p = static_cast<void**>(p)[-1];
#endif
    static_cast<void>(bytes);
    static_cast<void>(align);
#if defined(_WIN32)
    _aligned_free(p);
#else
    std::free(p);
#endif
}

}  // namespace

void* Allocator::obtain(mgdt_alloc_fn alloc, void* user, std::size_t bytes, std::size_t align,
                        bool remaps) noexcept {
    if (!alloc) return default_obtain(bytes, align, remaps);
    return call_back<void*>(nullptr, [&] { return alloc(bytes, align, user); });
}

void Allocator::give_back(mgdt_free_fn release, void* user, void* p, std::size_t bytes,
                          std::size_t align) noexcept {
    if (!release) {
        default_give_back(p, bytes, align);
        return;
    }
    call_back(0, [&] {
        release(p, bytes, align, user);
        return 0;
    });
}

void Allocator::count(std::size_t bytes) {
    const std::size_t now = bytes_.fetch_add(bytes, std::memory_order_relaxed) + bytes;
    if (now < bytes || (limit_ != 0 && now > limit_)) {
        discount(bytes);
        throw std::bad_alloc();
    }
    std::size_t peak = peak_.load(std::memory_order_relaxed);
    while (peak < now && !peak_.compare_exchange_weak(peak, now, std::memory_order_relaxed)) {
    }
}

void Allocator::discount(std::size_t bytes) noexcept {
    bytes_.fetch_sub(bytes, std::memory_order_relaxed);
}

void Allocator::prefault(void* part, std::size_t part_bytes, std::size_t block_bytes,
                         std::size_t align) const noexcept {
#if MGDT_HAVE_MREMAP && defined(MADV_POPULATE_WRITE)
    // For a few pages, the call costs more than the page faults.
    constexpr std::size_t least = 65536;
    if (alloc_ || part_bytes < least || is_small(block_bytes, align)) return;
    // madvise() takes whole pages, from the page where the part begins. Pages that exist keep their
    // contents.
    const std::size_t begin = reinterpret_cast<std::size_t>(part) & ~(page - 1);
    const std::size_t end = reinterpret_cast<std::size_t>(part) + part_bytes;
    madvise(reinterpret_cast<void*>(begin), page_round(end - begin), MADV_POPULATE_WRITE);
#else
    static_cast<void>(part);
    static_cast<void>(part_bytes);
    static_cast<void>(block_bytes);
    static_cast<void>(align);
#endif
}

void* Allocator::allocate(std::size_t bytes, std::size_t align, bool remaps) {
    if (bytes == 0) return nullptr;
    count(bytes);
    void* p = obtain(alloc_, user_, bytes, align, remaps || limit_ != 0);
    if (!p) {
        discount(bytes);
        throw std::bad_alloc();
    }
    return p;
}

void Allocator::release(void* p, std::size_t bytes, std::size_t align) noexcept {
    if (!p) return;
    give_back(release_, user_, p, bytes, align);
    discount(bytes);
}

void* Allocator::reallocate(void* p, std::size_t bytes, std::size_t used, std::size_t new_bytes,
                            std::size_t align) {
    if (!p) return allocate(new_bytes, align);
    if (new_bytes == 0) {
        release(p, bytes, align);
        return nullptr;
    }
#if MGDT_HAVE_MREMAP
    if (!alloc_ && is_mapped(p, bytes, align) && !is_small(new_bytes, align)) {
        if (new_bytes > bytes) count(new_bytes - bytes);
        void* moved = mremap(p, page_round(bytes), page_round(new_bytes), MREMAP_MAYMOVE);
        if (moved == MAP_FAILED) {
            if (new_bytes > bytes) discount(new_bytes - bytes);
            throw std::bad_alloc();
        }
        if (new_bytes < bytes) discount(bytes - new_bytes);
        return moved;
    }
    if (!alloc_ && new_bytes > bytes && !is_small(bytes, align) && align <= heap_offset &&
        is_remapped_by_library(p)) {
        count(new_bytes - bytes);
        void* const moved = regrow_medium(p, used, new_bytes);
        if (!moved) {
            discount(new_bytes - bytes);
            throw std::bad_alloc();
        }
        return moved;
    }
#endif
    void* fresh = allocate(new_bytes, align, true);
    std::memcpy(fresh, p, used < new_bytes ? used : new_bytes);
    release(p, bytes, align);
    return fresh;
}

void* Allocator::allocate_from(std::size_t bytes, std::size_t align, void* allocator) noexcept {
    try {
        return static_cast<Allocator*>(allocator)->allocate(bytes, align);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

void Allocator::release_to(void* p, std::size_t bytes, std::size_t align,
                           void* allocator) noexcept {
    static_cast<Allocator*>(allocator)->release(p, bytes, align);
}

}  // namespace mgdt
