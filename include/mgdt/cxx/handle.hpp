/* SPDX-License-Identifier: MIT
 * Shared by the classes that own a handle: exceptions for failed calls, progress callbacks, the
 * base classes, and memory from a resource. Part of mgdt/mgdt.hpp, which includes it. */
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
#include <vector>

#include "../mgdt.h"
#include "error.hpp"
#include "views.hpp"

namespace mgdt {
inline namespace cxx1 {

class Voronoi;

namespace detail {

// Checks the sizes of arrays that belong together.
inline void require_size(bool is_right, const char* what) {
    if (!is_right) throw Error(MGDT_ERR_INVALID_ARGUMENT, what);
}
inline void require_markers(std::size_t n, Span<const std::int32_t> markers) {
    require_size(markers.size() == 0 || markers.size() == n, "there is not one marker for each");
}

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
        message = status == MGDT_ERR_NULL_POINTER ? "the object was moved from"
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

// The base of the classes that own a handle of the C interface. `Calls` names the handle and the C
// functions. An object can be moved, not copied.
template <class Calls>
class Owner {
  public:
    using Handle = typename Calls::Handle;

    /** Whether the object owns a handle: true until the handle is moved or released. */
    [[nodiscard]] explicit operator bool() const noexcept { return handle_ != nullptr; }
    /** The handle, for calls of the C interface. The object still owns it. */
    [[nodiscard]] Handle* handle() noexcept { return handle_.get(); }
    [[nodiscard]] const Handle* handle() const noexcept { return handle_.get(); }
    /** Message of the last call that failed on the handle. @throw std::bad_alloc */
    [[nodiscard]] std::string last_error() const {
        return message_of(Calls::get_error, handle_.get());
    }

  protected:
    Owner() noexcept = default;
    explicit Owner(Handle* owned) noexcept : handle_(owned) {}
    Owner(Owner&&) noexcept = default;
    Owner& operator=(Owner&&) noexcept = default;
    Owner(const Owner&) = delete;
    Owner& operator=(const Owner&) = delete;
    ~Owner() = default;

    void swap_with(Owner& other) noexcept {
        progress_.swap(other.progress_);
        handle_.swap(other.handle_);
    }
    // Owns the handle that create(&handle), a call of the C interface, makes.
    template <class Create>
    void make(const Create& create) {
        Handle* made = nullptr;
        require(create(&made));
        handle_.reset(made);
    }
    Handle* get() const noexcept { return handle_.get(); }
    Handle* release_handle() noexcept { return handle_.release(); }
    // Ends a call: throws what the progress callback has thrown, or the exception of the status.
    void require(mgdt_status status) const {
        if (progress_) progress_->rethrow();
        if (status != MGDT_OK) throw_failure(status, handle_ ? last_error() : std::string());
    }

    std::unique_ptr<Progress> progress_{};  // outlives the handle, which may call it

  private:
    friend class cxx1::Voronoi;

    struct Destroy {
        void operator()(Handle* handle) const noexcept { Calls::destroy(handle); }
    };
    std::unique_ptr<Handle, Destroy> handle_{};
};

// The base of those whose calls report progress and can be cancelled.
template <class Calls>
class Worker : public Owner<Calls> {
  public:
    /** Releases ownership of the handle, which the caller frees by the C function. A callback of
     *  set_progress() is removed. Returns NULL and releases nothing in a callback of the object. */
    [[nodiscard]] typename Calls::Handle* release() noexcept {
        if (this->progress_ && Calls::set_progress(this->get(), nullptr, nullptr) != MGDT_OK)
            return nullptr;
        this->progress_.reset();
        return this->release_handle();
    }
    /** Sets the progress callback.
     *  @param call  a callable that takes a double, the fraction from 0 to 1. The object keeps it.
     *  Long calls call it, see mgdt_set_progress(). A result that is true cancels. If it throws,
     *  the running call is cancelled and throws that exception instead of Cancelled. It must not
     *  throw if several calls run at once.
     *  @throw Error, std::bad_alloc */
    template <class F, class = std::enable_if_t<std::is_invocable_v<std::decay_t<F>&, double>>>
    void set_progress(F&& call) {
        auto next = Progress::make(std::forward<F>(call));
        this->require(Calls::set_progress(this->get(), &Progress::hear, next.get()));
        this->progress_ = std::move(next);
    }
    /** Removes the progress callback. @throw Error */
    void clear_progress() {
        this->require(Calls::set_progress(this->get(), nullptr, nullptr));
        this->progress_.reset();
    }
    /** Stops the running calls, or the next one; from any thread and from signal handlers. */
    void cancel() noexcept {
        if (*this) Calls::cancel(this->get());
    }

  protected:
    using Owner<Calls>::Owner;
};

// The base of the classes whose options, numbers and arrays have keys.
template <class Calls, class Base = Worker<Calls>>
class Results : public Base {
  public:
    /** Sets an option. @throw Error */
    template <class C = Calls>
    void set_option(typename C::Option option, std::int64_t value) {
        this->require(C::set_option(this->get(), static_cast<std::int32_t>(option), value));
    }
    /** The value of an option. @throw Error */
    template <class C = Calls>
    [[nodiscard]] std::int64_t option(typename C::Option option) const {
        std::int64_t value = 0;
        this->require(C::get_option(this->get(), static_cast<std::int32_t>(option), &value));
        return value;
    }
    /** Sets an option whose value is a double. @throw Error. @since 1.4 */
    template <class C = Calls>
    void set_option(typename C::DoubleOption option, double value) {
        this->require(C::set_double_option(this->get(), static_cast<std::int32_t>(option), value));
    }
    /** The value of such an option. @throw Error. @since 1.4 */
    template <class C = Calls>
    [[nodiscard]] double option(typename C::DoubleOption option) const {
        double value = 0;
        this->require(C::get_double_option(this->get(), static_cast<std::int32_t>(option), &value));
        return value;
    }
    /** One number of the object. @throw OutOfMemory, Error */
    template <class C = Calls>
    [[nodiscard]] std::int64_t statistic(typename C::Statistic key) const {
        std::int64_t value = 0;
        this->require(C::get_stat(this->get(), static_cast<std::int32_t>(key), &value));
        return value;
    }

    /** Number of elements of an array. @throw OutOfMemory, Error */
    [[nodiscard]] std::size_t size(typename Calls::Array key) const {
        return size_of(static_cast<std::int32_t>(key));
    }
    template <class C = Calls>
    [[nodiscard]] std::size_t size(typename C::Doubles key) const {
        return size_of(static_cast<std::int32_t>(key));
    }
    /** How many elements of an array belong together, such as 4 for tetrahedra; 0 for a key that
     *  the library does not have. */
    [[nodiscard]] static std::size_t columns(typename Calls::Array key) noexcept {
        return columns_of(static_cast<std::int32_t>(key));
    }
    template <class C = Calls>
    [[nodiscard]] static std::size_t columns(typename C::Doubles key) noexcept {
        return columns_of(static_cast<std::int32_t>(key));
    }
    /** An array of integers. @throw OutOfMemory, Error, std::bad_alloc (the vector's) */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<Int> array(typename Calls::Array key) const {
        static_assert(is_index_v<Int>, "indices are std::int64_t or std::int32_t");
        std::vector<Int> values(size(key));
        const auto capacity = static_cast<std::int64_t>(values.size());
        const auto number = static_cast<std::int32_t>(key);
        if constexpr (sizeof(Int) == sizeof(std::int64_t))
            this->require(Calls::get_array(this->get(), number, capacity, values.data()));
        else
            this->require(Calls::get_array_i32(this->get(), number, capacity, values.data()));
        return values;
    }
    /** An array of doubles. @throw OutOfMemory, Error, std::bad_alloc (the vector's) */
    template <class C = Calls>
    [[nodiscard]] std::vector<double> doubles(typename C::Doubles key) const {
        std::vector<double> values(size(key));
        write<C>(key, values.size(), values.data());
        return values;
    }
    /** An array of doubles of which three belong together.
     *  @throw Error also if it has another shape; OutOfMemory, std::bad_alloc (the vector's) */
    template <class C = Calls>
    [[nodiscard]] std::vector<Point> points(typename C::Doubles key) const {
        if (columns(key) != 3)
            throw Error(MGDT_ERR_INVALID_ARGUMENT, "the array does not have points");
        std::vector<Point> values(size(key) / 3);
        write<C>(key, 3 * values.size(), values.empty() ? nullptr : values[0].data());
        return values;
    }

  protected:
    using Base::Base;

  private:
    std::size_t size_of(std::int32_t key) const {
        std::int64_t size = 0;
        this->require(Calls::get_size(this->get(), key, &size));
        return static_cast<std::size_t>(size);
    }
    static std::size_t columns_of(std::int32_t key) noexcept {
        std::int32_t columns = 0;
        return Calls::array_info(key, &columns, nullptr) == MGDT_OK
                   ? static_cast<std::size_t>(columns)
                   : 0;
    }
    template <class C>
    void write(typename C::Doubles key, std::size_t capacity, double* values) const {
        this->require(C::get_doubles(this->get(), static_cast<std::int32_t>(key),
                                     static_cast<std::int64_t>(capacity), values));
    }
};

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
