// SPDX-License-Identifier: MIT
// The guards of the entry points of the C interface. They refuse a call that conflicts with another
// call on the same handle, disable thread cancellation, set up the floating-point environment, and
// convert every exception to a status and a message.
#pragma once

#include <new>

#include "capi/call_lock.hpp"
#include "mgdt/mgdt.h"
#include "platform/atomic.hpp"
#include "platform/call_settings.hpp"
#include "platform/cancellation.hpp"
#include "platform/compiler.hpp"
#include "platform/error.hpp"
#include "platform/fp_environment.hpp"
#include "platform/function_ref.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

// The base class of every handle. A callback may call the handle while the derived class is being
// destroyed; the members of the base class still exist then.
class HandleBase {
  public:
    mutable CallLock calls;

    // Remembers why a call cannot enter, and returns its status. `other` is the name of the call
    // that the handle is busy in, if it is known.
    mgdt_status refuse(const char* name, const char* other = nullptr) const noexcept;

    // The message of the last failure. Const calls on several threads may fail at once.
    void remember(const char* message) const noexcept;
    void recall(char* to, std::size_t capacity) const noexcept;

  private:
    class Lock;

    mutable Atomic<bool> message_lock_{false};
    mutable char message_[Error::message_size] = {};
};

// The body of a call. Its type is hidden, so that each guard is compiled once.
using Body = FunctionRef<void()>;

// Run a body within a handle, and return its status: alone; together with others that read; and
// without being counted (guard.cpp).
mgdt_status guard_alone(HandleBase* t, const Body& body, const char* name);
mgdt_status guard_together(const HandleBase* t, const Body& body, const char* name);
mgdt_status guard_uncounted(const HandleBase* t, const Body& body, const char* name);

// Runs a call that changes the handle.
template <class F>
mgdt_status guard(HandleBase* t, F body, const char* name = __builtin_FUNCTION()) {
    return guard_alone(t, body, name);
}

// Runs a call that reads the handle and may take long. Calls that change the handle are refused
// meanwhile.
template <class F>
mgdt_status guard(const HandleBase* t, F body, const char* name = __builtin_FUNCTION()) {
    return guard_together(t, body, name);
}

// Runs a call that reads the handle for about a microsecond. Such a call is not counted, since with
// many threads counting would take a large part of its time. A call that runs callbacks is counted,
// because callbacks may call the handle.
template <class Handle, class F>
mgdt_status guard_short(const Handle* t, F body, const char* name = __builtin_FUNCTION()) {
    return t && t->has_callbacks() ? guard_together(t, body, name) : guard_uncounted(t, body, name);
}

// Runs body(progress), the body of a long call that reads `handle`, which the call has entered. The
// call reports progress and can be cancelled if `is_watched`. Unless `polls_first`, the body has to
// find a request to stop that was made before the call.
void read_for_long(const HandleBase* handle, const CallSettings& settings, StopFlag& stop,
                   bool is_watched, bool polls_first, FunctionRef<void(StageProgress&)> body,
                   const char* name);

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
std::size_t require_count(std::int64_t n, const char* of = "points");

// Checks that an array of the caller with `capacity` elements has room for `needed` elements.
void require_capacity(std::int64_t capacity, std::size_t needed, const char* name);

}  // namespace mgdt
