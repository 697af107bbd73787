/* SPDX-License-Identifier: MIT
 * The class of a domain and its mesh. Part of mgdt/mgdt.hpp, which includes it and explains it. */
#ifndef MGDT_CXX_DOMAIN_HPP
#define MGDT_CXX_DOMAIN_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../mgdt_domain.h"
#include "constants.hpp"
#include "error.hpp"
#include "handle.hpp"
#include "views.hpp"

namespace mgdt {
inline namespace cxx1 {

/** Points, facets and segments, and the mesh of what they enclose; see mgdt_domain.h. It can be
 *  moved, not copied. @since 1.3 */
class Domain {
  public:
    /** Makes a domain without points; mgdt_domain_create(). @throw OutOfMemory, Error */
    Domain() : Domain(nullptr, nullptr, nullptr) {}
    /** Makes a domain that takes all its memory from `alloc`; mgdt_domain_create_with_allocator().
     *  Neither function may throw. @throw OutOfMemory, Error */
    Domain(mgdt_alloc_fn alloc, mgdt_free_fn give_back, void* user) {
        mgdt_domain* made = nullptr;
        require(mgdt_domain_create_with_allocator(alloc, give_back, user, &made));
        handle_.reset(made);
    }
    /** Takes ownership of a handle of the C interface. */
    explicit Domain(mgdt_domain* owned) noexcept : handle_(owned) {}

    Domain(Domain&&) noexcept = default;
    Domain& operator=(Domain&&) noexcept = default;
    Domain(const Domain&) = delete;
    Domain& operator=(const Domain&) = delete;
    ~Domain() = default;
    friend void swap(Domain& a, Domain& b) noexcept {
        a.progress_.swap(b.progress_);
        a.handle_.swap(b.handle_);
    }

    /** Whether the object owns a handle: true until the handle is moved or released. */
    [[nodiscard]] explicit operator bool() const noexcept { return handle_ != nullptr; }
    /** The handle, for calls of the C interface. The object still owns it. */
    [[nodiscard]] mgdt_domain* handle() noexcept { return handle_.get(); }
    [[nodiscard]] const mgdt_domain* handle() const noexcept { return handle_.get(); }
    /** Releases ownership of the handle, which the caller frees by mgdt_domain_destroy(). A
     *  callback of set_progress() is removed. Returns NULL and releases nothing in a callback of
     *  the object. */
    [[nodiscard]] mgdt_domain* release() noexcept {
        if (progress_ && mgdt_domain_set_progress(handle_.get(), nullptr, nullptr) != MGDT_OK)
            return nullptr;
        progress_.reset();
        return handle_.release();
    }

    /** mgdt_domain_clear(). @throw Error */
    void clear() { require(mgdt_domain_clear(handle_.get())); }
    /** mgdt_domain_set_option(). @throw Error */
    void set_option(DomainOption option, std::int64_t value) {
        require(mgdt_domain_set_option(handle_.get(), static_cast<std::int32_t>(option), value));
    }
    /** mgdt_domain_get_option(). @throw Error */
    [[nodiscard]] std::int64_t option(DomainOption option) const {
        std::int64_t value = 0;
        require(mgdt_domain_get_option(handle_.get(), static_cast<std::int32_t>(option), &value));
        return value;
    }
    /** Sets the progress callback, as Triangulation::set_progress(). @throw Error,
     *  std::bad_alloc */
    template <class F, class = std::enable_if_t<std::is_invocable_v<std::decay_t<F>&, double>>>
    void set_progress(F&& call) {
        auto next = detail::Progress::make(std::forward<F>(call));
        require(mgdt_domain_set_progress(handle_.get(), &detail::Progress::hear, next.get()));
        progress_ = std::move(next);
    }
    /** Removes the progress callback. @throw Error */
    void clear_progress() {
        require(mgdt_domain_set_progress(handle_.get(), nullptr, nullptr));
        progress_.reset();
    }
    /** mgdt_domain_cancel(); from any thread and from signal handlers. */
    void cancel() noexcept {
        if (handle_) mgdt_domain_cancel(handle_.get());
    }

    /** mgdt_domain_set_points(). @throw OutOfMemory, Error */
    void set_points(Points points) {
        require(mgdt_domain_set_points(handle_.get(), static_cast<std::int64_t>(points.count()),
                                       points.data()));
    }
    /** Sets triangles as facets; mgdt_domain_set_facets().
     *  @param corners  three for each
     *  @param markers  one for each, or none
     *  @throw OutOfMemory, Error */
    void set_triangles(Span<const std::int64_t> corners, Span<const std::int32_t> markers = {}) {
        require_size(corners.size() % 3 == 0, "triangles have three corners each");
        set_facets(corners.size() / 3, nullptr, corners, markers);
    }
    /** Sets polygons as facets; mgdt_domain_set_facets().
     *  @param offsets  one more than there are facets
     *  @throw OutOfMemory, Error */
    void set_facets(Span<const std::int64_t> offsets, Span<const std::int64_t> corners,
                    Span<const std::int32_t> markers = {}) {
        require_size(offsets.size() > 0, "there are no offsets");
        const std::int64_t last = offsets.data()[offsets.size() - 1];
        require_size(
            last - option(DomainOption::index_base) == static_cast<std::int64_t>(corners.size()),
            "the last offset is not the end of the corners");
        set_facets(offsets.size() - 1, offsets.data(), corners, markers);
    }
    /** mgdt_domain_set_segments().
     *  @param ends     two for each
     *  @param markers  one for each, or none
     *  @throw OutOfMemory, Error */
    void set_segments(Span<const std::int64_t> ends, Span<const std::int32_t> markers = {}) {
        require_size(ends.size() % 2 == 0, "segments have two ends each");
        require_markers(ends.size() / 2, markers);
        require(mgdt_domain_set_segments(handle_.get(), static_cast<std::int64_t>(ends.size() / 2),
                                         ends.data(),
                                         markers.size() > 0 ? markers.data() : nullptr));
    }
    /** mgdt_domain_add_region(). @throw OutOfMemory, Error */
    void add_region(const std::array<double, 3>& place, std::int32_t marker) {
        require(mgdt_domain_add_region(handle_.get(), place.data(), marker));
    }
    /** mgdt_domain_add_hole(). @throw OutOfMemory, Error */
    void add_hole(const std::array<double, 3>& place) {
        require(mgdt_domain_add_hole(handle_.get(), place.data()));
    }

    /** mgdt_domain_validate(). @throw Cancelled, OutOfMemory, Error; its status is
     *  MGDT_ERR_INVALID_BOUNDARY if there are offending_pairs() */
    void validate() { require(mgdt_domain_validate(handle_.get())); }
    /** mgdt_domain_build(). @throw Cancelled, OutOfMemory, Error, and what the progress callback
     *  throws */
    void build() {
        const mgdt_status status = mgdt_domain_build(handle_.get());
        if (progress_) progress_->rethrow();
        require(status);
    }
    /** mgdt_domain_check(). @throw OutOfMemory, Error */
    void check() const { require(mgdt_domain_check(handle_.get())); }

    /** mgdt_domain_get_stat(). @throw Error */
    [[nodiscard]] std::int64_t number(DomainNumber key) const {
        std::int64_t value = 0;
        require(mgdt_domain_get_stat(handle_.get(), static_cast<std::int32_t>(key), &value));
        return value;
    }
    /** An array of integers; mgdt_domain_get_array(). @throw Error, std::bad_alloc (the vector's)
     */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<Int> array(DomainArray key) const {
        static_assert(detail::is_index_v<Int>, "indices are std::int64_t or std::int32_t");
        std::vector<Int> values(size_of(static_cast<std::int32_t>(key)));
        const auto capacity = static_cast<std::int64_t>(values.size());
        if constexpr (sizeof(Int) == sizeof(std::int64_t))
            require(mgdt_domain_get_array(handle_.get(), static_cast<std::int32_t>(key), capacity,
                                          values.data()));
        else
            require(mgdt_domain_get_array_i32(handle_.get(), static_cast<std::int32_t>(key),
                                              capacity, values.data()));
        return values;
    }
    /** The points: those that were set, then the Steiner points. @throw Error, std::bad_alloc (the
     *  vector's) */
    [[nodiscard]] std::vector<Point> points() const {
        std::vector<Point> values(size_of(MGDT_DOMAIN_ARRAY_POINTS) / 3);
        require(mgdt_domain_get_doubles(handle_.get(), MGDT_DOMAIN_ARRAY_POINTS,
                                        static_cast<std::int64_t>(3 * values.size()),
                                        values.empty() ? nullptr : values[0].data()));
        return values;
    }
    /** For each Steiner point its parameter on its edge. @throw Error, std::bad_alloc (the
     *  vector's) */
    [[nodiscard]] std::vector<double> steiner_parameters() const {
        std::vector<double> values(size_of(MGDT_DOMAIN_ARRAY_STEINER_PARAMETERS));
        require(mgdt_domain_get_doubles(handle_.get(), MGDT_DOMAIN_ARRAY_STEINER_PARAMETERS,
                                        static_cast<std::int64_t>(values.size()), values.data()));
        return values;
    }
    /** Message of the last call that failed on the handle; mgdt_domain_get_error().
     *  @throw std::bad_alloc */
    [[nodiscard]] std::string last_error() const {
        return detail::message_of(mgdt_domain_get_error, handle_.get());
    }

  private:
    struct Destroy {
        void operator()(mgdt_domain* d) const noexcept { mgdt_domain_destroy(d); }
    };

    void require(mgdt_status status) const {
        if (status != MGDT_OK)
            detail::throw_failure(status, handle_ ? last_error() : std::string());
    }
    static void require_size(bool is_right, const char* what) {
        if (!is_right) throw Error(MGDT_ERR_INVALID_ARGUMENT, what);
    }
    static void require_markers(std::size_t n, Span<const std::int32_t> markers) {
        require_size(markers.size() == 0 || markers.size() == n,
                     "there is not one marker for each");
    }
    void set_facets(std::size_t n, const std::int64_t* offsets, Span<const std::int64_t> corners,
                    Span<const std::int32_t> markers) {
        require_markers(n, markers);
        require(mgdt_domain_set_facets(handle_.get(), static_cast<std::int64_t>(n), offsets,
                                       corners.data(),
                                       markers.size() > 0 ? markers.data() : nullptr));
    }
    std::size_t size_of(std::int32_t key) const {
        std::int64_t size = 0;
        require(mgdt_domain_get_size(handle_.get(), key, &size));
        return static_cast<std::size_t>(size);
    }

    // The callback outlives the handle.
    std::unique_ptr<detail::Progress> progress_{};
    std::unique_ptr<mgdt_domain, Destroy> handle_{};
};

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_DOMAIN_HPP */
