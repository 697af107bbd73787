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

namespace detail {

struct PeriodicCalls {
    using Handle = mgdt_periodic;
    using Option = PeriodicOption;
    using Statistic = PeriodicStatistic;
    using Array = PeriodicArray;
    using Doubles = PeriodicDoubles;
    static constexpr auto destroy = mgdt_periodic_destroy;
    static constexpr auto set_progress = mgdt_periodic_set_progress;
    static constexpr auto cancel = mgdt_periodic_cancel;
    static constexpr auto get_error = mgdt_periodic_get_error;
    static constexpr auto set_option = mgdt_periodic_set_option;
    static constexpr auto get_option = mgdt_periodic_get_option;
    static constexpr auto get_stat = mgdt_periodic_get_stat;
    static constexpr auto array_info = mgdt_periodic_array_info;
    static constexpr auto get_size = mgdt_periodic_get_size;
    static constexpr auto get_array = mgdt_periodic_get_array;
    static constexpr auto get_array_i32 = mgdt_periodic_get_array_i32;
    static constexpr auto get_doubles = mgdt_periodic_get_doubles;
};

}  // namespace detail

/** Points in a periodic box and their triangulation; see mgdt_periodic.h. It can be moved, not
 *  copied. Options, statistics and arrays: mgdt_periodic_set_option(), mgdt_periodic_get_option(),
 *  mgdt_periodic_get_stat(), mgdt_periodic_array_info(), mgdt_periodic_get_size(),
 *  mgdt_periodic_get_array() and mgdt_periodic_get_doubles(). @since 1.3 */
class Periodic : public detail::Results<detail::PeriodicCalls> {
  public:
    /** Makes a box without vectors and points; mgdt_periodic_create(). @throw OutOfMemory, Error */
    Periodic() : Periodic(nullptr, nullptr, nullptr) {}
    /** Makes a box that takes all its memory from `alloc`; mgdt_periodic_create_with_allocator().
     *  Neither function may throw. @throw OutOfMemory, Error */
    Periodic(mgdt_alloc_fn alloc, mgdt_free_fn give_back, void* user) {
        make([&](mgdt_periodic** out) {
            return mgdt_periodic_create_with_allocator(alloc, give_back, user, out);
        });
    }
    /** Makes a box of one to three vectors without points; mgdt_periodic_set_vectors().
     *  @throw OutOfMemory, Error */
    explicit Periodic(Points vectors) : Periodic() { set_vectors(vectors); }
    /** Takes ownership of a handle of the C interface. */
    explicit Periodic(mgdt_periodic* owned) noexcept : Results(owned) {}

    friend void swap(Periodic& a, Periodic& b) noexcept { a.swap_with(b); }

    /** mgdt_periodic_clear(). @throw Error */
    void clear() { require(mgdt_periodic_clear(get())); }
    /** Sets the vectors, and keeps the points; mgdt_periodic_set_vectors().
     *  @throw OutOfMemory, Error */
    void set_vectors(Points vectors) {
        constexpr std::size_t most = 3;  // C refuses the next number too
        const std::size_t count = vectors.count() <= most ? vectors.count() : most + 1;
        require(mgdt_periodic_set_vectors(get(), static_cast<std::int32_t>(count), vectors.data()));
    }
    /** Merges near images in later builds; mgdt_periodic_set_merge_distance(). @throw Error */
    void set_merge_distance(double distance) {
        require(mgdt_periodic_set_merge_distance(get(), distance));
    }
    /** mgdt_periodic_get_merge_distance(). @throw Error */
    [[nodiscard]] double merge_distance() const {
        double distance = 0;
        require(mgdt_periodic_get_merge_distance(get(), &distance));
        return distance;
    }
    /** mgdt_periodic_insert_points(). @throw OutOfMemory, Error */
    void insert(Points points) {
        require(mgdt_periodic_insert_points(get(), static_cast<std::int64_t>(points.count()),
                                            points.data()));
    }
    /** Moves all points; mgdt_periodic_move_points(). @throw OutOfMemory, Error */
    void move(Points to) {
        require(mgdt_periodic_move_points(get(), static_cast<std::int64_t>(to.count()), nullptr,
                                          to.data()));
    }
    /** Moves some points; mgdt_periodic_move_points(). @throw OutOfMemory, Error */
    void move(Span<const std::int64_t> points, Points to) {
        if (points.size() != to.count())
            throw Error(MGDT_ERR_INVALID_ARGUMENT, "there is not one place for each point");
        if (points.size() == 0) return;
        require(mgdt_periodic_move_points(get(), static_cast<std::int64_t>(to.count()),
                                          points.data(), to.data()));
    }
    /** mgdt_periodic_build(). @throw Cancelled, OutOfMemory, Error, and what the progress callback
     *  throws */
    void build() { require(mgdt_periodic_build(get())); }
    /** mgdt_periodic_check(). @throw Cancelled, OutOfMemory, Error */
    void check() const { require(mgdt_periodic_check(get())); }

    /** The points, rounded, where they were put. @throw Error, std::bad_alloc (the vector's) */
    [[nodiscard]] std::vector<Point> points() const {
        return Results::points(PeriodicDoubles::points);
    }
    /** The vectors, rounded. @throw Error, std::bad_alloc (the vector's) */
    [[nodiscard]] std::vector<Point> vectors() const {
        return Results::points(PeriodicDoubles::vectors);
    }
    /** Measures each cell: one number, or three for a centroid; mgdt_periodic_get_cell_measures().
     *  @throw OutOfMemory, Error, std::bad_alloc (the vector's) */
    [[nodiscard]] std::vector<double> cell_measures(Measure measure) const {
        const std::size_t width = measure == Measure::centroid ? 3 : 1;
        std::vector<double> x(width *
                              static_cast<std::size_t>(statistic(PeriodicStatistic::points)));
        require(mgdt_periodic_get_cell_measures(get(), static_cast<std::int32_t>(measure),
                                                static_cast<std::int64_t>(x.size()), x.data()));
        return x;
    }
    /** The diagram of the cells; mgdt_periodic_create_voronoi().
     *  @throw Cancelled, OutOfMemory, Error */
    [[nodiscard]] Voronoi voronoi() const {
        mgdt_voronoi* made = nullptr;
        const mgdt_status status = mgdt_periodic_create_voronoi(get(), &made);
        Voronoi diagram(made);  // the callback may throw at the last report, when there is one
        require(status);
        return diagram;
    }
};

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_PERIODIC_HPP */
