// SPDX-License-Identifier: MIT
#include "capi/guard.hpp"

namespace mgdt {
namespace {

// Runs `body` for a handle that the call has entered and returns its status.
//
// The function is not inlined, because of threads with the asynchronous cancellation type. A
// cancellation request that arrives during the call takes effect when the guards below restore the
// cancellation state. The request unwinds the frames of the guards, which is possible because the
// guards have nothing to clean up and are not noexcept.
MGDT_NOT_INLINE mgdt_status run_inside(const HandleBase* t, const Body& body) noexcept {
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

}  // namespace

// Is on the stack while a progress function runs, which may make calls on other handles.
class ProgressOfRead::Running {
  public:
    explicit Running(const ProgressOfRead& of) noexcept : of_(of), outer_(innermost) {
        innermost = this;
    }
    ~Running() { innermost = outer_; }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    const ProgressOfRead& of() const noexcept { return of_; }
    const Running* outer() const noexcept { return outer_; }

  private:
    const ProgressOfRead& of_;
    const Running* outer_;
};

thread_local const ProgressOfRead::Running* ProgressOfRead::innermost = nullptr;

CallSettings ProgressOfRead::settings() noexcept {
    CallSettings own;
    if (!tell_) return own;
    own.progress = [](double fraction, void* user) {
        const ProgressOfRead& of = *static_cast<const ProgressOfRead*>(user);
        const Running running(of);
        return of.tell_(fraction, of.user_);
    };
    own.progress_user = this;
    return own;
}

const char* ProgressOfRead::running_for(const HandleBase* handle) noexcept {
    for (const Running* r = innermost; r; r = r->outer())
        if (r->of().handle_ == handle) return r->of().name_;
    return nullptr;
}

mgdt_status guard_alone(HandleBase* t, const Body& body, const char* name) {
    if (!t) return MGDT_ERR_NULL_POINTER;
    const CancellationDisabled uninterrupted;
    if (!t->calls.try_enter_alone(name)) return t->refuse(name);
    const mgdt_status status = run_inside(t, body);
    t->calls.leave_alone();
    return status;
}

mgdt_status guard_together(const HandleBase* t, const Body& body, const char* name) {
    if (!t) return MGDT_ERR_NULL_POINTER;
    const CancellationDisabled uninterrupted;
    if (const char* const other = ProgressOfRead::running_for(t)) return t->refuse(name, other);
    if (!t->calls.try_enter_together()) return t->refuse(name);
    const mgdt_status status = run_inside(t, body);
    t->calls.leave_together();
    return status;
}

mgdt_status guard_uncounted(const HandleBase* t, const Body& body, const char* name) {
    if (!t) return MGDT_ERR_NULL_POINTER;
    const CancellationDisabled uninterrupted;
    if (t->calls.is_held_alone()) return t->refuse(name);
    return run_inside(t, body);
}

mgdt_status get_message(const HandleBase* handle, std::int64_t capacity, char* buffer) {
    if (!handle || !buffer) return MGDT_ERR_NULL_POINTER;
    if (capacity < 1) return MGDT_ERR_INVALID_ARGUMENT;
    const CancellationDisabled uninterrupted;
    handle->recall(buffer, static_cast<std::size_t>(capacity));
    return MGDT_OK;
}

}  // namespace mgdt
