// SPDX-License-Identifier: MIT
// Records which calls are inside a handle: a readers-writer lock that never waits. A call that
// changes the handle enters alone, calls that only read it enter together, and a call that cannot
// enter is refused. So a call from a callback, or from a second thread against the thread rule,
// gets a status and does no harm.
#pragma once

#include <cstdint>
#include <thread>

#include "platform/atomic.hpp"

namespace mgdt {

class CallLock {
  public:
    // Enters for a call that changes the handle. `name` is the name of the called function, a
    // static string.
    bool try_enter_alone(const char* name) noexcept {
        std::uint32_t expected = 0;
        if (!inside_.compare_exchange_strong(expected, alone, std::memory_order_acquire,
                                             std::memory_order_relaxed))
            return false;
        annotate_acquire(&inside_);
        name_.store(name, std::memory_order_relaxed);
        return true;
    }
    void leave_alone() noexcept {
        annotate_release(&inside_);
        inside_.store(0, std::memory_order_release);
    }

    // Lets other calls read the handle for a while. The caller is a call that changes the handle.
    void let_read() noexcept {
        annotate_release(&inside_);
        inside_.store(1, std::memory_order_release);
    }
    // Ends the effect of let_read(): waits for the calls that are still reading, and is alone then.
    void be_alone_again() noexcept {
        std::uint32_t expected = 1;
        while (!inside_.compare_exchange_weak(expected, alone, std::memory_order_acquire,
                                              std::memory_order_relaxed)) {
            expected = 1;
            std::this_thread::yield();
        }
        annotate_acquire(&inside_);
    }

    // Enters for a call that only reads the handle.
    bool try_enter_together() noexcept {
        std::uint32_t inside = inside_.load(std::memory_order_relaxed);
        do {
            if (inside == alone) return false;
        } while (!inside_.compare_exchange_weak(inside, inside + 1, std::memory_order_acquire,
                                                std::memory_order_relaxed));
        annotate_acquire(&inside_);
        return true;
    }
    void leave_together() noexcept {
        annotate_release(&inside_);
        inside_.fetch_sub(1, std::memory_order_release);
    }

    // Whether a call that changes the handle is inside. Calls that read the handle too briefly to
    // be counted use this function: it does not write `inside_`, so the word stays in the caches of
    // all threads.
    bool is_held_alone() const noexcept {
        const bool is_held = inside_.load(std::memory_order_acquire) == alone;
        annotate_acquire(&inside_);
        return is_held;
    }
    // The name of the call that entered alone; nullptr if there is none.
    const char* name() const noexcept {
        return is_held_alone() ? name_.load(std::memory_order_relaxed) : nullptr;
    }

  private:
    static constexpr std::uint32_t alone = 0xFFFFFFFFu;

    Atomic<std::uint32_t> inside_{0};  // the number of calls that read, or `alone`
    Atomic<const char*> name_{nullptr};
};

}  // namespace mgdt
