// SPDX-License-Identifier: MIT
// The shape that all handles have. A handle is an object with three functions: allocator(),
// settings(), which are CallSettings, and stop(), a StopFlag. Here are the life of a handle, its
// progress function and its cancellation; options.hpp has options, arrays.hpp results.
#pragma once

#include <utility>

#include "capi/guard.hpp"
#include "platform/call_settings.hpp"
#include "platform/memory.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

template <class T>
struct Handle : HandleBase {
    using Object = T;

    template <class... Arguments>
    explicit Handle(Arguments&&... arguments) : object(std::forward<Arguments>(arguments)...) {}

    // Whether calls that only read the handle may run functions of the host.
    bool has_callbacks() const noexcept { return object.allocator().release_function() != nullptr; }

    Object object;
};

// The object of a handle that has a result, such as that of another handle's call. Settings are
// CallSettings, or derived from them.
template <class T, class Settings = CallSettings>
class Result {
  public:
    Result(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user)
        : allocator_(alloc, release, user), value(allocator_) {}

    Allocator& allocator() const noexcept { return allocator_; }
    Settings& settings() noexcept { return settings_; }
    const Settings& settings() const noexcept { return settings_; }
    StopFlag& stop() const noexcept { return stop_; }

  private:
    mutable Allocator allocator_;
    Settings settings_;
    mutable StopFlag stop_;

  public:
    T value;
};

// Frees a handle that no call is inside of.
template <class H>
void free_handle(H* handle) noexcept {
    const mgdt_free_fn release = handle->object.allocator().release_function();
    void* const user = handle->object.allocator().user();
    handle->~H();
    Allocator::give_back(release, user, handle, sizeof(H), alignof(H));
}

// Makes a handle whose object is made from (arguments..., alloc, release, user). Throws what the
// constructor throws, and std::bad_alloc.
template <class H, class... Arguments>
H* new_handle(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user,
              const Arguments&... arguments) {
    void* const memory = Allocator::obtain(alloc, user, sizeof(H), alignof(H));
    if (!memory) throw std::bad_alloc();
    H* handle = nullptr;
    try {
        handle = new (memory) H(arguments..., alloc, release, user);
    } catch (...) {
        Allocator::give_back(release, user, memory, sizeof(H), alignof(H));
        throw;
    }
    handle->object.allocator().count(sizeof(H));  // there is no limit yet
    return handle;
}

// Makes the handle of a result within a call on the handle of `source`: with memory from the same
// functions, the same limit, and the settings of `source` but for the progress function. `fill`
// sets the object. Throws with nothing left.
template <class H, class Source, class Fill>
H* new_result(const Source& source, const Fill& fill) {
    const Allocator& memory = source.allocator();
    H* const handle =
        new_handle<H>(memory.allocate_function(), memory.release_function(), memory.user());
    try {
        handle->object.settings().index_base = source.settings().index_base;
        handle->object.settings().threads = source.settings().threads;
        Allocator& own = handle->object.allocator();
        own.set_limit(memory.limit());
        if (own.limit() > 0 && own.bytes() > own.limit()) throw std::bad_alloc();
        fill(handle->object);
    } catch (...) {
        free_handle(handle);
        throw;
    }
    return handle;
}

// The two functions below are not inlined, for the reason at run_inside() in guard.cpp.
template <class H, class... Arguments>
MGDT_NOT_INLINE mgdt_status try_new_handle(H** out, mgdt_alloc_fn alloc, mgdt_free_fn release,
                                           void* user, const Arguments&... arguments) noexcept {
    const FpEnvironment environment;
    try {
        *out = new_handle<H>(alloc, release, user, arguments...);
        return MGDT_OK;
    } catch (const Error& error) {
        return error.status;
    } catch (const std::bad_alloc&) {
        return MGDT_ERR_OUT_OF_MEMORY;
    } catch (...) {
        return MGDT_ERR_INTERNAL;
    }
}
template <class H>
MGDT_NOT_INLINE void free_handle_in_environment(H* handle) noexcept {
    const FpEnvironment environment;
    free_handle(handle);
}

// The body of a create function, which has checked the other arguments.
template <class H, class... Arguments>
mgdt_status create_handle(H** out, mgdt_alloc_fn alloc, mgdt_free_fn release, void* user,
                          const Arguments&... arguments) {
    if (!out) return MGDT_ERR_NULL_POINTER;
    *out = nullptr;
    if ((alloc == nullptr) != (release == nullptr)) return MGDT_ERR_INVALID_ARGUMENT;
    const CancellationDisabled uninterrupted;
    return try_new_handle(out, alloc, release, user, arguments...);
}

// The body of a destroy function: frees a handle, unless a call is inside of it, which would
// continue in freed memory.
template <class H>
void destroy_handle(H* handle, void (*free)(H*) noexcept = free_handle_in_environment<H>,
                    const char* name = __builtin_FUNCTION()) {
    if (!handle) return;
    const CancellationDisabled uninterrupted;
    if (handle->calls.try_enter_alone(name))
        free(handle);
    else
        handle->refuse(name);
}

template <class H>
mgdt_status set_progress(H* handle, mgdt_progress_fn fn, void* user,
                         const char* name = __builtin_FUNCTION()) {
    return guard(
        handle,
        [&] {
            handle->object.settings().progress = fn;
            handle->object.settings().progress_user = user;
        },
        name);
}

template <class H>
mgdt_status get_progress(const H* handle, mgdt_progress_fn* fn, void** user,
                         const char* name = __builtin_FUNCTION()) {
    return guard_short(
        handle,
        [&] {
            require_pointer(reinterpret_cast<const void*>(fn), "the output");
            *fn = handle->object.settings().progress;
            if (user) *user = handle->object.settings().progress_user;
        },
        name);
}

enum class Watched { if_set, always };

// Runs body(progress), a long call that reads the handle. The call reports progress and can be
// cancelled if the settings say so, or if `watched` is `always`.
template <class H, class F>
mgdt_status guard_long(const H* handle, F body, Watched watched = Watched::if_set,
                       const char* name = __builtin_FUNCTION()) {
    return guard(
        handle,
        [&] {
            const CallSettings& settings = handle->object.settings();
            read_for_long(handle, settings, handle->object.stop(),
                          watched == Watched::always || settings.watches_reads, true, body, name);
        },
        name);
}

// The function only stores a flag, so any thread and any signal handler may call it.
template <class H>
mgdt_status cancel(H* handle) {
    if (!handle) return MGDT_ERR_NULL_POINTER;
    handle->object.stop().set();
    return MGDT_OK;
}

}  // namespace mgdt
