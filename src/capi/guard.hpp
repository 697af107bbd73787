// SPDX-License-Identifier: MIT
// The guards of the entry points of the C interface. They refuse a call that conflicts with another
// call on the same handle, disable thread cancellation, set up the floating-point environment, and
// convert every exception to a status and a message.
#pragma once

#include <cstdio>
#include <cstring>
#include <limits>
#include <new>

#include "capi/call_lock.hpp"
#include "mgdt/mgdt.h"
#include "platform/atomic.hpp"
#include "platform/call_settings.hpp"
#include "platform/cancellation.hpp"
#include "platform/compiler.hpp"
#include "platform/error.hpp"
#include "platform/fp_environment.hpp"

namespace mgdt {

// The base class of every handle. A callback may call the handle while the derived class is being
// destroyed; the members of the base class still exist then.
class HandleBase {
  public:
    mutable CallLock calls;

    // Remembers why a call cannot enter, and returns its status. `other` is the name of the call
    // that the handle is busy in, if it is known.
    mgdt_status refuse(const char* name, const char* other = nullptr) const noexcept {
        char message[Error::message_size];
        if (!other) other = calls.name();
        if (other)
            std::snprintf(message, sizeof message, "%s() is refused: the handle is busy in %s()",
                          name, other);
        else
            std::snprintf(message, sizeof message,
                          "%s() is refused: the handle is busy in calls that read it", name);
        remember(message);
        return MGDT_ERR_BUSY;
    }

    // The message of the last failure. Const calls on several threads may fail at once.
    void remember(const char* message) const noexcept {
        const Lock lock(message_lock_);
        copy(message, message_, sizeof message_);
    }
    void recall(char* to, std::size_t capacity) const noexcept {
        const Lock lock(message_lock_);
        copy(message_, to, capacity);
    }

  private:
    static void copy(const char* from, char* to, std::size_t capacity) noexcept {
        const std::size_t length = std::strlen(from);
        const std::size_t kept = length < capacity ? length : capacity - 1;
        std::memcpy(to, from, kept);
        to[kept] = '\0';
    }
    struct Lock {
        explicit Lock(Atomic<bool>& flag) noexcept : flag_(flag) {
            while (flag_.exchange(true, std::memory_order_acquire)) {
            }
            annotate_acquire(&flag_);
        }
        ~Lock() {
            annotate_release(&flag_);
            flag_.store(false, std::memory_order_release);
        }
        Atomic<bool>& flag_;
    };
    mutable Atomic<bool> message_lock_{false};
    mutable char message_[Error::message_size] = {};
};

// Refers to a function object and hides its type, so that each guard is compiled once.
class Body {
  public:
    template <class F>
    explicit Body(F& f) noexcept : call_([](void* of) { (*static_cast<F*>(of))(); }), of_(&f) {}
    void operator()() const { call_(of_); }

  private:
    void (*call_)(void*);
    void* of_;
};

// Run a body within a handle, and return its status: alone; together with others that read; and
// without being counted (guard.cpp).
mgdt_status guard_alone(HandleBase* t, const Body& body, const char* name);
mgdt_status guard_together(const HandleBase* t, const Body& body, const char* name);
mgdt_status guard_uncounted(const HandleBase* t, const Body& body, const char* name);

// Runs a call that changes the handle.
template <class F>
mgdt_status guard(HandleBase* t, F body, const char* name = __builtin_FUNCTION()) {
    return guard_alone(t, Body(body), name);
}

// Runs a call that reads the handle and may take long. Calls that change the handle are refused
// meanwhile.
template <class F>
mgdt_status guard(const HandleBase* t, F body, const char* name = __builtin_FUNCTION()) {
    return guard_together(t, Body(body), name);
}

// Runs a call that reads the handle for about a microsecond. Such a call is not counted, since with
// many threads counting would take a large part of its time. A call that runs callbacks is counted,
// because callbacks may call the handle.
template <class Handle, class F>
mgdt_status guard_short(const Handle* t, F body, const char* name = __builtin_FUNCTION()) {
    return t && t->has_callbacks() ? guard_together(t, Body(body), name)
                                   : guard_uncounted(t, Body(body), name);
}

// The progress function of a long call that reads a handle. While it runs, guard_together() refuses
// calls that its thread makes on the same handle. Otherwise a progress function that made such a
// call would call itself without end.
class ProgressOfRead {
  public:
    // Calls the function that `settings` names now.
    ProgressOfRead(const HandleBase* handle, const char* name,
                   const CallSettings& settings) noexcept
        : handle_(handle), name_(name), tell_(settings.progress), user_(settings.progress_user) {}
    ProgressOfRead(const ProgressOfRead&) = delete;
    ProgressOfRead& operator=(const ProgressOfRead&) = delete;

    // Settings whose progress function is this one.
    CallSettings settings() noexcept;
    // The name of the call that reads the handle and whose progress function runs on this thread;
    // nullptr if there is none.
    static const char* running_for(const HandleBase* handle) noexcept;

  private:
    class Running;
    static thread_local const Running* innermost;

    const HandleBase* handle_;
    const char* name_;
    mgdt_progress_fn tell_;
    void* user_;
};

// A handle that a call on another handle reads.
class SecondHandle {
  public:
    // Throws MGDT_ERR_BUSY if a call that changes the handle is inside.
    explicit SecondHandle(const HandleBase* handle) : handle_(handle) {
        if (!handle->calls.try_enter_together())
            fail(MGDT_ERR_BUSY, "the second handle is busy in a call that changes it");
    }
    ~SecondHandle() { handle_->calls.leave_together(); }
    SecondHandle(const SecondHandle&) = delete;
    SecondHandle& operator=(const SecondHandle&) = delete;

  private:
    const HandleBase* handle_;
};

// Copies the message of the last call that failed on the handle.
mgdt_status get_message(const HandleBase* handle, std::int64_t capacity, char* buffer);

inline void require_pointer(const void* p, const char* name) {
    if (!p) fail(MGDT_ERR_NULL_POINTER, "%s is NULL", name);
}

// Checks a number of points, or of something else, that a call is given.
inline std::size_t require_count(std::int64_t n, const char* of = "points") {
    if (n < 0)
        fail(MGDT_ERR_INVALID_ARGUMENT, "the number of %s is negative (%lld)", of,
             static_cast<long long>(n));
    // This happens only where std::size_t has 32 bits.
    if (static_cast<std::uint64_t>(n) > std::numeric_limits<std::size_t>::max())
        fail(MGDT_ERR_TOO_LARGE, "%lld %s are more than memory can hold", static_cast<long long>(n),
             of);
    return static_cast<std::size_t>(n);
}

inline void require_capacity(std::int64_t capacity, std::size_t needed, const char* name) {
    if (capacity < 0)
        fail(MGDT_ERR_INVALID_ARGUMENT, "the capacity of %s is negative (%lld)", name,
             static_cast<long long>(capacity));
    if (static_cast<std::uint64_t>(capacity) < needed)
        fail(MGDT_ERR_BUFFER_TOO_SMALL, "%s holds %lld elements; %zu are needed", name,
             static_cast<long long>(capacity), needed);
}

}  // namespace mgdt
