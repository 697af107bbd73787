/* SPDX-License-Identifier: MIT
 * The class of points in a periodic box. Part of mgdt/mgdt.hpp, which includes it and explains it.
 */
#ifndef MGDT_CXX_PERIODIC_HPP
#define MGDT_CXX_PERIODIC_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../mgdt_periodic.h"
#include "constants.hpp"
#include "error.hpp"
#include "handle.hpp"
#include "views.hpp"
#include "voronoi.hpp"

namespace mgdt {
inline namespace cxx1 {

/** Points in a periodic box and their triangulation; see mgdt_periodic.h. It can be moved, not
 *  copied. @since 1.3 */
class Periodic {
  public:
    /** Makes a box of one to three vectors without points; mgdt_periodic_create().
     *  @throw OutOfMemory, Error */
    explicit Periodic(Points vectors) : Periodic(vectors, nullptr, nullptr, nullptr) {}
    /** Makes a box that takes all its memory from `alloc`; mgdt_periodic_create_with_allocator().
     *  Neither function may throw. @throw OutOfMemory, Error */
    Periodic(Points vectors, mgdt_alloc_fn alloc, mgdt_free_fn give_back, void* user) {
        mgdt_periodic* made = nullptr;
        constexpr std::size_t most = 3;  // C refuses the next number too
        const std::size_t count = vectors.count() <= most ? vectors.count() : most + 1;
        require(mgdt_periodic_create_with_allocator(static_cast<std::int32_t>(count),
                                                    vectors.data(), alloc, give_back, user, &made));
        handle_.reset(made);
    }
    /** Takes ownership of a handle of the C interface. */
    explicit Periodic(mgdt_periodic* owned) noexcept : handle_(owned) {}

    Periodic(Periodic&&) noexcept = default;
    Periodic& operator=(Periodic&&) noexcept = default;
    Periodic(const Periodic&) = delete;
    Periodic& operator=(const Periodic&) = delete;
    ~Periodic() = default;
    friend void swap(Periodic& a, Periodic& b) noexcept {
        a.progress_.swap(b.progress_);
        a.handle_.swap(b.handle_);
    }

    /** Whether the object owns a handle: true until the handle is moved or released. */
    [[nodiscard]] explicit operator bool() const noexcept { return handle_ != nullptr; }
    /** The handle, for calls of the C interface. The object still owns it. */
    [[nodiscard]] mgdt_periodic* handle() noexcept { return handle_.get(); }
    [[nodiscard]] const mgdt_periodic* handle() const noexcept { return handle_.get(); }
    /** Releases ownership of the handle, which the caller frees by mgdt_periodic_destroy(). A
     *  callback of set_progress() is removed. Returns NULL and releases nothing in a callback of
     *  the object. */
    [[nodiscard]] mgdt_periodic* release() noexcept {
        if (progress_ && mgdt_periodic_set_progress(handle_.get(), nullptr, nullptr) != MGDT_OK)
            return nullptr;
        progress_.reset();
        return handle_.release();
    }

    /** mgdt_periodic_clear(). @throw Error */
    void clear() { require(mgdt_periodic_clear(handle_.get())); }
    /** mgdt_periodic_set_option(). @throw Error */
    void set_option(PeriodicOption option, std::int64_t value) {
        require(mgdt_periodic_set_option(handle_.get(), static_cast<std::int32_t>(option), value));
    }
    /** mgdt_periodic_get_option(). @throw Error */
    [[nodiscard]] std::int64_t option(PeriodicOption option) const {
        std::int64_t value = 0;
        require(mgdt_periodic_get_option(handle_.get(), static_cast<std::int32_t>(option), &value));
        return value;
    }
    /** Merges near images in later builds; mgdt_periodic_set_merge_distance(). @throw Error */
    void set_merge_distance(double distance) {
        require(mgdt_periodic_set_merge_distance(handle_.get(), distance));
    }
    /** mgdt_periodic_get_merge_distance(). @throw Error */
    [[nodiscard]] double merge_distance() const {
        double distance = 0;
        require(mgdt_periodic_get_merge_distance(handle_.get(), &distance));
        return distance;
    }
    /** Sets the progress callback, as Triangulation::set_progress(). @throw Error,
     *  std::bad_alloc */
    template <class F, class = std::enable_if_t<std::is_invocable_v<std::decay_t<F>&, double>>>
    void set_progress(F&& call) {
        auto next = detail::Progress::make(std::forward<F>(call));
        require(mgdt_periodic_set_progress(handle_.get(), &detail::Progress::hear, next.get()));
        progress_ = std::move(next);
    }
    /** Removes the progress callback. @throw Error */
    void clear_progress() {
        require(mgdt_periodic_set_progress(handle_.get(), nullptr, nullptr));
        progress_.reset();
    }
    /** mgdt_periodic_cancel(); from any thread and from signal handlers. */
    void cancel() noexcept {
        if (handle_) mgdt_periodic_cancel(handle_.get());
    }

    /** mgdt_periodic_insert_points(). @throw OutOfMemory, Error */
    void insert(Points points) {
        require(mgdt_periodic_insert_points(
            handle_.get(), static_cast<std::int64_t>(points.count()), points.data()));
    }
    /** Moves all points; mgdt_periodic_move_points(). @throw OutOfMemory, Error */
    void move(Points to) {
        require(mgdt_periodic_move_points(handle_.get(), static_cast<std::int64_t>(to.count()),
                                          nullptr, to.data()));
    }
    /** Moves some points; mgdt_periodic_move_points(). @throw OutOfMemory, Error */
    void move(Span<const std::int64_t> points, Points to) {
        if (points.size() != to.count())
            throw Error(MGDT_ERR_INVALID_ARGUMENT, "there is not one place for each point");
        if (points.size() == 0) return;
        require(mgdt_periodic_move_points(handle_.get(), static_cast<std::int64_t>(to.count()),
                                          points.data(), to.data()));
    }
    /** mgdt_periodic_build(). @throw Cancelled, OutOfMemory, Error, and what the progress callback
     *  throws */
    void build() {
        const mgdt_status status = mgdt_periodic_build(handle_.get());
        if (progress_) progress_->rethrow();
        require(status);
    }
    /** mgdt_periodic_check(). @throw Cancelled, OutOfMemory, Error */
    void check() const { require(mgdt_periodic_check(handle_.get())); }

    /** mgdt_periodic_get_stat(). @throw OutOfMemory, Error */
    [[nodiscard]] std::int64_t number(PeriodicNumber key) const {
        std::int64_t value = 0;
        require(mgdt_periodic_get_stat(handle_.get(), static_cast<std::int32_t>(key), &value));
        return value;
    }
    /** An array of integers; mgdt_periodic_get_array().
     *  @throw OutOfMemory, Error, std::bad_alloc (the vector's) */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<Int> array(PeriodicArray key) const {
        static_assert(detail::is_index_v<Int>, "indices are std::int64_t or std::int32_t");
        std::vector<Int> values(size_of(static_cast<std::int32_t>(key)));
        const auto capacity = static_cast<std::int64_t>(values.size());
        if constexpr (sizeof(Int) == sizeof(std::int64_t))
            require(mgdt_periodic_get_array(handle_.get(), static_cast<std::int32_t>(key), capacity,
                                            values.data()));
        else
            require(mgdt_periodic_get_array_i32(handle_.get(), static_cast<std::int32_t>(key),
                                                capacity, values.data()));
        return values;
    }
    /** The points, rounded, where they were put. @throw Error, std::bad_alloc (the vector's) */
    [[nodiscard]] std::vector<Point> points() const { return rows(MGDT_PERIODIC_ARRAY_POINTS); }
    /** The vectors, rounded. @throw Error, std::bad_alloc (the vector's) */
    [[nodiscard]] std::vector<Point> vectors() const { return rows(MGDT_PERIODIC_ARRAY_VECTORS); }
    /** Measures each cell: one number, or three for a centroid; mgdt_periodic_get_cell_measures().
     *  @throw OutOfMemory, Error, std::bad_alloc (the vector's) */
    [[nodiscard]] std::vector<double> cell_measures(Measure measure) const {
        const std::size_t width = measure == Measure::centroid ? 3 : 1;
        std::vector<double> x(width *
                              static_cast<std::size_t>(number(PeriodicNumber::given_points)));
        require(mgdt_periodic_get_cell_measures(handle_.get(), static_cast<std::int32_t>(measure),
                                                static_cast<std::int64_t>(x.size()), x.data()));
        return x;
    }
    /** The diagram of the cells; mgdt_periodic_create_voronoi().
     *  @throw Cancelled, OutOfMemory, Error */
    [[nodiscard]] Voronoi voronoi() const {
        mgdt_voronoi* made = nullptr;
        require(mgdt_periodic_create_voronoi(handle_.get(), &made));
        return Voronoi(made);
    }
    /** Message of the last call that failed on the handle; mgdt_periodic_get_error().
     *  @throw std::bad_alloc */
    [[nodiscard]] std::string last_error() const {
        return detail::message_of(mgdt_periodic_get_error, handle_.get());
    }

  private:
    struct Destroy {
        void operator()(mgdt_periodic* p) const noexcept { mgdt_periodic_destroy(p); }
    };

    void require(mgdt_status status) const {
        if (status != MGDT_OK)
            detail::throw_failure(status, handle_ ? last_error() : std::string());
    }
    std::size_t size_of(std::int32_t key) const {
        std::int64_t size = 0;
        require(mgdt_periodic_get_size(handle_.get(), key, &size));
        return static_cast<std::size_t>(size);
    }
    std::vector<Point> rows(std::int32_t key) const {
        std::vector<Point> values(size_of(key) / 3);
        require(mgdt_periodic_get_doubles(handle_.get(), key,
                                          static_cast<std::int64_t>(3 * values.size()),
                                          values.empty() ? nullptr : values[0].data()));
        return values;
    }

    // The callback outlives the handle.
    std::unique_ptr<detail::Progress> progress_{};
    std::unique_ptr<mgdt_periodic, Destroy> handle_{};
};

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_PERIODIC_HPP */
