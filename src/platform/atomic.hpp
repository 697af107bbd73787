// SPDX-License-Identifier: MIT
// Atomics, and annotations for tools that detect data races. ThreadSanitizer understands atomics;
// Helgrind understands locks alone. A build with the option `helgrind` tells Helgrind which
// variables are atomic, and where an atomic publishes data to another thread. In all other builds
// the annotations are empty.
#pragma once

#include <atomic>
#include <cstdint>

#if MGDT_HELGRIND
#include <valgrind/helgrind.h>
#endif

#if defined(__has_feature)
#define MGDT_HAS_FEATURE(name) __has_feature(name)
#else
#define MGDT_HAS_FEATURE(name) 0
#endif
#if defined(__SANITIZE_THREAD__) || MGDT_HAS_FEATURE(thread_sanitizer)
#define MGDT_NO_SANITIZE_THREAD __attribute__((no_sanitize_thread, noinline))
#else
#define MGDT_NO_SANITIZE_THREAD
#endif

namespace mgdt {

#if MGDT_HELGRIND
template <class T>
class Atomic : public std::atomic<T> {
  public:
    Atomic(T value) noexcept : std::atomic<T>(value) {
        VALGRIND_HG_DISABLE_CHECKING(this, sizeof *this);
    }
    ~Atomic() {
        ANNOTATE_HAPPENS_BEFORE_FORGET_ALL(this);
        VALGRIND_HG_ENABLE_CHECKING(this, sizeof *this);
    }
    using std::atomic<T>::operator=;
};
#else
template <class T>
using Atomic = std::atomic<T>;
#endif

// annotate_release() comes before a store that publishes data, annotate_acquire() after the load
// that receives it.
inline void annotate_release([[maybe_unused]] const void* atomic) noexcept {
#if MGDT_HELGRIND
    ANNOTATE_HAPPENS_BEFORE(atomic);
#endif
}
inline void annotate_acquire([[maybe_unused]] const void* atomic) noexcept {
#if MGDT_HELGRIND
    ANNOTATE_HAPPENS_AFTER(atomic);
#endif
}

// Reads two words that another thread may be writing: an intentional race, of which ThreadSanitizer
// and Helgrind are informed.
MGDT_NO_SANITIZE_THREAD inline void read_racing(const volatile std::uint32_t* from,
                                                std::uint32_t to[2]) noexcept {
#if MGDT_HELGRIND
    // Valgrind runs this call natively, so that Helgrind does not see the loads.
    const auto read = [](unsigned, const volatile std::uint32_t* source,
                         std::uint32_t* target) -> long {
        target[0] = source[0];
        target[1] = source[1];
        return 0;
    };
    VALGRIND_NON_SIMD_CALL2(+read, from, to);
#else
    to[0] = from[0];
    to[1] = from[1];
#endif
}

}  // namespace mgdt
