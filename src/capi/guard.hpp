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

    // Remembers why a call cannot enter, and returns its status.
    mgdt_status refuse(const char* name) const noexcept {
        char message[Error::message_size];
        if (const char* const other = calls.name())
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

// Runs `body` for a handle that the call has entered and returns its status.
//
// The function is not inlined, because of threads with the asynchronous cancellation type. A
// cancellation request that arrives during the call takes effect when the guards below restore the
// cancellation state. The request unwinds the frames of the guards, which is possible because the
// guards have nothing to clean up and are not noexcept.
template <class Body>
MGDT_NOT_INLINE mgdt_status run_inside(const HandleBase* t, Body& body) noexcept {
    const FpEnvironment environment;
    try {
        body();
        return MGDT_OK;
    } catch (const Error& error) {
        t->remember(error.message);
        return error.status;
    } catch (const std::bad_alloc&) {
        t->remember("out of memory: the allocator or the memory limit refused");
        return MGDT_ERR_OUT_OF_MEMORY;
    } catch (...) {
        t->remember("internal error");
        return MGDT_ERR_INTERNAL;
    }
}

// Runs a call that changes the handle.
template <class Body>
mgdt_status guard(HandleBase* t, Body body, const char* name = __builtin_FUNCTION()) {
    if (!t) return MGDT_ERR_NULL_POINTER;
    const CancellationDisabled uninterrupted;
    if (!t->calls.try_enter_alone(name)) return t->refuse(name);
    const mgdt_status status = run_inside(t, body);
    t->calls.leave_alone();
    return status;
}

// Runs a call that reads the handle and may take long. Calls that change the handle are refused
// meanwhile.
template <class Body>
mgdt_status guard(const HandleBase* t, Body body, const char* name = __builtin_FUNCTION()) {
    if (!t) return MGDT_ERR_NULL_POINTER;
    const CancellationDisabled uninterrupted;
    if (!t->calls.try_enter_together()) return t->refuse(name);
    const mgdt_status status = run_inside(t, body);
    t->calls.leave_together();
    return status;
}

// Runs a call that reads the handle for about a microsecond. Such a call is not counted, since with
// many threads counting would take a large part of its time. A call that runs callbacks is counted,
// because callbacks may call the handle.
template <class Handle, class Body>
mgdt_status guard_short(const Handle* t, Body body, const char* name = __builtin_FUNCTION()) {
    if (!t) return MGDT_ERR_NULL_POINTER;
    if (t->has_callbacks()) return guard(t, body, name);
    const CancellationDisabled uninterrupted;
    if (t->calls.is_held_alone()) return t->refuse(name);
    return run_inside(t, body);
}

// Destroys a handle, unless a call is inside of it, which would continue in freed memory.
template <class Handle>
void destroy_if_free(Handle* handle, void (*destroy)(Handle*) noexcept,
                     const char* name = __builtin_FUNCTION()) {
    if (!handle) return;
    const CancellationDisabled uninterrupted;
    if (handle->calls.try_enter_alone(name))
        destroy(handle);
    else
        handle->refuse(name);
}

// Copies the message of the last call that failed on the handle.
inline mgdt_status get_message(const HandleBase* handle, std::int64_t capacity, char* buffer) {
    if (!handle || !buffer) return MGDT_ERR_NULL_POINTER;
    if (capacity < 1) return MGDT_ERR_INVALID_ARGUMENT;
    const CancellationDisabled uninterrupted;
    handle->recall(buffer, static_cast<std::size_t>(capacity));
    return MGDT_OK;
}

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
