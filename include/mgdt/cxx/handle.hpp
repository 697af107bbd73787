/* SPDX-License-Identifier: MIT
 * Shared by the classes that own a handle: exceptions for failed calls, progress callbacks, and
 * memory from a resource. Part of mgdt/mgdt.hpp, which includes it. */
#ifndef MGDT_CXX_HANDLE_HPP
#define MGDT_CXX_HANDLE_HPP

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "../mgdt.h"
#include "error.hpp"

namespace mgdt {
inline namespace cxx1 {

namespace detail {

// The message of the last call that failed on a handle.
template <class Handle>
std::string message_of(mgdt_status (*get_error)(const Handle*, std::int64_t, char*),
                       const Handle* handle) {
    char text[256] = "";
    return get_error(handle, sizeof text, text) == MGDT_OK ? text : "";
}

// Throws the exception for a status. The message is empty if there is no handle.
[[noreturn]] inline void throw_failure(mgdt_status status, std::string message) {
    if (status == MGDT_ERR_OUT_OF_MEMORY) throw OutOfMemory();
    if (message.empty())
        message = status == MGDT_ERR_NULL_POINTER ? "the triangulation was moved from"
                                                  : mgdt_status_string(status);
    if (status == MGDT_ERR_CANCELLED) throw Cancelled(status, message);
    if (status == MGDT_ERR_BUSY) throw Busy(status, message);
    throw Error(status, message);
}

// Calls functions whose exceptions must not pass through the library, and keeps the exception.
class Guarded {
  public:
    // Returns the result of the call, or `instead` if the call throws.
    template <class Call>
    std::int32_t run(std::int32_t instead, const Call& call) noexcept {
        try {
            return call();
        } catch (...) {
            thrown_ = std::current_exception();
            return instead;
        }
    }
    // Throws the exception that was kept, if there is one.
    void rethrow() {
        if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
    }

  private:
    std::exception_ptr thrown_{};
};

// Calls a callback. Returns whether it has a result and that is true.
template <class F, class... Arguments>
bool asks_to_stop(F& call, Arguments&&... arguments) {
    if constexpr (std::is_void_v<std::invoke_result_t<F&, Arguments...>>) {
        std::invoke(call, std::forward<Arguments>(arguments)...);
        return false;
    } else {
        return static_cast<bool>(std::invoke(call, std::forward<Arguments>(arguments)...));
    }
}

// The progress callback.
class Progress {
  public:
    template <class F>
    static std::unique_ptr<Progress> make(F&& call);

    Progress() = default;
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    virtual ~Progress() = default;

    // An mgdt_progress_fn whose `user` is a Progress.
    static std::int32_t hear(double fraction, void* user) noexcept {
        Progress& self = *static_cast<Progress*>(user);
        return self.guarded_.run(1, [&] { return self.cancels(fraction) ? 1 : 0; });
    }
    void rethrow() { guarded_.rethrow(); }

  private:
    virtual bool cancels(double fraction) = 0;

    Guarded guarded_{};
};
template <class F>
class Callback final : public Progress {
  public:
    explicit Callback(F call) : call_(std::move(call)) {}

  private:
    bool cancels(double fraction) override { return asks_to_stop(call_, fraction); }

    F call_;
};
template <class F>
std::unique_ptr<Progress> Progress::make(F&& call) {
    return std::make_unique<Callback<std::decay_t<F>>>(std::forward<F>(call));
}

// An mgdt_alloc_fn, and below an mgdt_free_fn, whose `user` is a resource such as a
// std::pmr::memory_resource.
template <class Resource>
void* take(std::size_t size, std::size_t align, void* user) noexcept {
    try {
        return static_cast<Resource*>(user)->allocate(size, align);
    } catch (...) {
        return nullptr;
    }
}
template <class Resource>
void give(void* p, std::size_t size, std::size_t align, void* user) noexcept {
    static_cast<Resource*>(user)->deallocate(p, size, align);
}
// Substitution fails for types that are no resource.
template <class Resource>
using allocate_of = decltype(std::declval<Resource&>().allocate(std::size_t{1}, std::size_t{1}));
template <class Resource>
using deallocate_of = decltype(std::declval<Resource&>().deallocate(
    static_cast<void*>(nullptr), std::size_t{1}, std::size_t{1}));

}  // namespace detail

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_HANDLE_HPP */
