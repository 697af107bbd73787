/* SPDX-License-Identifier: MIT
 * The class of a domain. Part of mgdt/mgdt.hpp, which includes it and explains it. */
#ifndef MGDT_CXX_DOMAIN_HPP
#define MGDT_CXX_DOMAIN_HPP

#include <cstddef>
#include <cstdint>
#include <utility>

#include "../mgdt_domain.h"
#include "constants.hpp"
#include "error.hpp"
#include "handle.hpp"
#include "mesh.hpp"
#include "views.hpp"

namespace mgdt {
inline namespace cxx1 {

namespace detail {

struct DomainCalls {
    using Handle = mgdt_domain;
    using Option = DomainOption;
    using Statistic = DomainStatistic;
    using Array = DomainArray;
    using Doubles = DomainDoubles;
    using DoubleOption = DomainDoubleOption;
    static constexpr auto destroy = mgdt_domain_destroy;
    static constexpr auto set_progress = mgdt_domain_set_progress;
    static constexpr auto cancel = mgdt_domain_cancel;
    static constexpr auto get_error = mgdt_domain_get_error;
    static constexpr auto set_option = mgdt_domain_set_option;
    static constexpr auto get_option = mgdt_domain_get_option;
    static constexpr auto get_stat = mgdt_domain_get_stat;
    static constexpr auto array_info = mgdt_domain_array_info;
    static constexpr auto get_size = mgdt_domain_get_size;
    static constexpr auto get_array = mgdt_domain_get_array;
    static constexpr auto get_array_i32 = mgdt_domain_get_array_i32;
    static constexpr auto get_doubles = mgdt_domain_get_doubles;
    static constexpr auto set_double_option = mgdt_domain_set_double_option;
    static constexpr auto get_double_option = mgdt_domain_get_double_option;
};

}  // namespace detail

/** Points, facets and segments of a domain that is to be filled with a mesh; see mgdt_domain.h. It
 *  can be moved, not copied. Options, statistics and arrays: mgdt_domain_set_option(),
 *  mgdt_domain_get_option(), mgdt_domain_set_double_option(), mgdt_domain_get_double_option(),
 *  mgdt_domain_get_doubles(), mgdt_domain_get_stat(), mgdt_domain_array_info(),
 *  mgdt_domain_get_size() and mgdt_domain_get_array(). @since 1.3 */
class Domain : public detail::Results<detail::DomainCalls> {
  public:
    /** Makes a domain without points; mgdt_domain_create(). @throw OutOfMemory, Error */
    Domain() : Domain(nullptr, nullptr, nullptr) {}
    /** Makes a domain that takes all its memory from `alloc`; mgdt_domain_create_with_allocator().
     *  Neither function may throw. @throw OutOfMemory, Error */
    Domain(mgdt_alloc_fn alloc, mgdt_free_fn give_back, void* user) {
        make([&](mgdt_domain** out) {
            return mgdt_domain_create_with_allocator(alloc, give_back, user, out);
        });
    }
    /** Takes ownership of a handle of the C interface. */
    explicit Domain(mgdt_domain* owned) noexcept : Results(owned) {}
    friend void swap(Domain& a, Domain& b) noexcept { a.swap_with(b); }

    /** mgdt_domain_clear(). @throw Error */
    void clear() { require(mgdt_domain_clear(get())); }

    /** mgdt_domain_set_points(). @throw OutOfMemory, Error */
    void set_points(Points points) {
        require(mgdt_domain_set_points(get(), static_cast<std::int64_t>(points.count()),
                                       points.data()));
    }
    /** Sets triangles as facets; mgdt_domain_set_facets().
     *  @param corners  three for each
     *  @param markers  one for each, or none
     *  @throw OutOfMemory, Error */
    void set_triangles(Span<const std::int64_t> corners, Span<const std::int32_t> markers = {}) {
        detail::require_size(corners.size() % 3 == 0, "triangles have three corners each");
        set_facets(corners.size() / 3, nullptr, corners, markers);
    }
    /** Sets polygons as facets; mgdt_domain_set_facets().
     *  @param offsets  one more than there are facets
     *  @throw OutOfMemory, Error */
    void set_facets(Span<const std::int64_t> offsets, Span<const std::int64_t> corners,
                    Span<const std::int32_t> markers = {}) {
        detail::require_size(offsets.size() > 0, "there are no offsets");
        const std::int64_t last = offsets.data()[offsets.size() - 1];
        detail::require_size(
            last - option(DomainOption::index_base) == static_cast<std::int64_t>(corners.size()),
            "the last offset is not the end of the corners");
        set_facets(offsets.size() - 1, offsets.data(), corners, markers);
    }
    /** mgdt_domain_set_segments().
     *  @param ends     two for each
     *  @param markers  one for each, or none
     *  @throw OutOfMemory, Error */
    void set_segments(Span<const std::int64_t> ends, Span<const std::int32_t> markers = {}) {
        detail::require_size(ends.size() % 2 == 0, "segments have two ends each");
        detail::require_markers(ends.size() / 2, markers);
        require(mgdt_domain_set_segments(get(), static_cast<std::int64_t>(ends.size() / 2),
                                         ends.data(),
                                         markers.size() > 0 ? markers.data() : nullptr));
    }
    /** mgdt_domain_set_regions().
     *  @param markers  one for each place, or none
     *  @throw OutOfMemory, Error */
    void set_regions(Points places, Span<const std::int32_t> markers = {}) {
        detail::require_markers(places.count(), markers);
        require(mgdt_domain_set_regions(get(), static_cast<std::int64_t>(places.count()),
                                        places.data(),
                                        markers.size() > 0 ? markers.data() : nullptr));
    }
    /** mgdt_domain_set_holes(). @throw OutOfMemory, Error */
    void set_holes(Points places) {
        require(
            mgdt_domain_set_holes(get(), static_cast<std::int64_t>(places.count()), places.data()));
    }

    /** mgdt_domain_clean(). @throw Cancelled, OutOfMemory, Error, and what the progress callback
     *  throws. @since 1.4 */
    void clean() { require(mgdt_domain_clean(get())); }
    /** mgdt_domain_validate(). @throw Cancelled, OutOfMemory, Error, and what the progress callback
     *  throws; the status is MGDT_ERR_INVALID_BOUNDARY if there are offending pairs */
    void validate() { require(mgdt_domain_validate(get())); }
    /** mgdt_domain_build(). @throw Cancelled, OutOfMemory, Error, and what the progress callback
     *  throws */
    [[nodiscard]] Mesh build() {
        mgdt_mesh* made = nullptr;
        const mgdt_status status = mgdt_domain_build(get(), &made);
        Mesh mesh(made);
        require(status);
        return mesh;
    }
    /** Compares a mesh with what was set; mgdt_domain_check(). @throw Cancelled, OutOfMemory,
     *  Error, and what the progress callback throws */
    void check(const Mesh& mesh) const { require(mgdt_domain_check(get(), mesh.handle())); }

  private:
    void set_facets(std::size_t n, const std::int64_t* offsets, Span<const std::int64_t> corners,
                    Span<const std::int32_t> markers) {
        detail::require_markers(n, markers);
        require(mgdt_domain_set_facets(get(), static_cast<std::int64_t>(n), offsets, corners.data(),
                                       markers.size() > 0 ? markers.data() : nullptr));
    }
};

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_DOMAIN_HPP */
