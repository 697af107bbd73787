// SPDX-License-Identifier: MIT
#include "capi/guard.hpp"

#include <cstdio>
#include <cstring>
#include <limits>

namespace mgdt {
namespace {

void copy(const char* from, char* to, std::size_t capacity) noexcept {
    const std::size_t length = std::strlen(from);
    const std::size_t kept = length < capacity ? length : capacity - 1;
    std::memcpy(to, from, kept);
    to[kept] = '\0';
}

}  // namespace

// Protects the message of a handle.
class HandleBase::Lock {
  public:
    explicit Lock(Atomic<bool>& flag) noexcept : flag_(flag) {
        while (flag_.exchange(true, std::memory_order_acquire)) {
        }
        annotate_acquire(&flag_);
    }
    ~Lock() {
        annotate_release(&flag_);
        flag_.store(false, std::memory_order_release);
    }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

  private:
    Atomic<bool>& flag_;
};

mgdt_status HandleBase::refuse(const char* name, const char* other) const noexcept {
    char message[Error::message_size];
    if (!other) other = calls.name();
    if (other)
        std::snprintf(message, sizeof message, "%s() is refused: the handle is busy in %s()", name,
                      other);
    else
        std::snprintf(message, sizeof message,
                      "%s() is refused: the handle is busy in calls that read it", name);
    remember(message);
    return MGDT_ERR_BUSY;
}

void HandleBase::remember(const char* message) const noexcept {
    const Lock lock(message_lock_);
    copy(message, message_, sizeof message_);
}

void HandleBase::recall(char* to, std::size_t capacity) const noexcept {
    const Lock lock(message_lock_);
    copy(message_, to, capacity);
}

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

// The progress function of a long call that reads a handle. While it runs, guard_together() refuses
// calls that its thread makes on the same handle. Without this rule, a progress function that made
// such a call would call itself without end.
class ProgressOfRead {
  public:
    // Calls the function that `settings` names now.
    ProgressOfRead(const HandleBase* handle, const char* name,
                   const CallSettings& settings) noexcept
        : handle_(handle), name_(name), tell_(settings.progress), user_(settings.progress_user) {}
    ProgressOfRead(const ProgressOfRead&) = delete;
    ProgressOfRead& operator=(const ProgressOfRead&) = delete;

    // Returns settings whose progress function marks this call as running and calls the function
    // of the host.
    CallSettings settings() noexcept {
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
    // The name of the call that reads the handle and whose progress function runs on this thread;
    // nullptr if there is none.
    static const char* running_for(const HandleBase* handle) noexcept {
        for (const Running* r = innermost; r; r = r->outer)
            if (r->of.handle_ == handle) return r->of.name_;
        return nullptr;
    }

  private:
    // Is on the stack while a progress function runs, which may make calls on other handles.
    struct Running {
        explicit Running(const ProgressOfRead& p) noexcept : of(p), outer(innermost) {
            innermost = this;
        }
        ~Running() { innermost = outer; }
        Running(const Running&) = delete;
        Running& operator=(const Running&) = delete;

        const ProgressOfRead& of;
        const Running* outer;
    };
    static thread_local const Running* innermost;

    const HandleBase* handle_;
    const char* name_;
    mgdt_progress_fn tell_;
    void* user_;
};

thread_local const ProgressOfRead::Running* ProgressOfRead::innermost = nullptr;

}  // namespace

void read_for_long(const HandleBase* handle, const CallSettings& settings, StopFlag& stop,
                   bool is_watched, bool polls_first, FunctionRef<void(StageProgress&)> body,
                   const char* name) {
    StopFlag never;
    StopFlag& watched = is_watched ? stop : never;
    const StopFlag::Call call(watched);
    ProgressOfRead of_read(handle, name, is_watched ? settings : CallSettings());
    StageProgress progress(of_read.settings(), watched);
    if (polls_first) progress.stop_request().poll();
    body(progress);
    progress.finish();
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

std::size_t require_count(std::int64_t n, const char* of) {
    if (n < 0)
        fail(MGDT_ERR_INVALID_ARGUMENT, "the number of %s is negative (%lld)", of,
             static_cast<long long>(n));
    // This happens only where std::size_t has 32 bits.
    if (static_cast<std::uint64_t>(n) > std::numeric_limits<std::size_t>::max())
        fail(MGDT_ERR_TOO_LARGE, "%lld %s are more than memory can hold", static_cast<long long>(n),
             of);
    return static_cast<std::size_t>(n);
}

void require_capacity(std::int64_t capacity, std::size_t needed, const char* name) {
    if (capacity < 0)
        fail(MGDT_ERR_INVALID_ARGUMENT, "the capacity of %s is negative (%lld)", name,
             static_cast<long long>(capacity));
    if (static_cast<std::uint64_t>(capacity) < needed)
        fail(MGDT_ERR_BUFFER_TOO_SMALL, "%s holds %lld elements; %zu are needed", name,
             static_cast<long long>(capacity), needed);
}

}  // namespace mgdt
