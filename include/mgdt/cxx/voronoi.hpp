/* SPDX-License-Identifier: MIT
 * The class of a Voronoi diagram. Part of mgdt/mgdt.hpp, which includes it and explains it. */
#ifndef MGDT_CXX_VORONOI_HPP
#define MGDT_CXX_VORONOI_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../mgdt_voronoi.h"
#include "constants.hpp"
#include "error.hpp"
#include "handle.hpp"
#include "triangulation.hpp"
#include "views.hpp"

namespace mgdt {
inline namespace cxx1 {

namespace detail {

struct VoronoiCalls {
    using Handle = mgdt_voronoi;
    using Statistic = VoronoiStatistic;
    using Array = VoronoiArray;
    using Doubles = VoronoiDoubles;
    static constexpr auto destroy = mgdt_voronoi_destroy;
    static constexpr auto get_stat = mgdt_voronoi_get_stat;
    static constexpr auto array_info = mgdt_voronoi_array_info;
    static constexpr auto get_size = mgdt_voronoi_get_size;
    static constexpr auto get_array = mgdt_voronoi_get_array;
    static constexpr auto get_array_i32 = mgdt_voronoi_get_array_i32;
    static constexpr auto get_doubles = mgdt_voronoi_get_doubles;
    static constexpr auto get_error = mgdt_voronoi_get_error;
};

}  // namespace detail

/** The Voronoi diagram of the points of a triangulation, which it outlives; see mgdt_voronoi.h. It
 *  can be moved, not copied. Statistics and arrays: mgdt_voronoi_get_stat(),
 *  mgdt_voronoi_array_info(), mgdt_voronoi_get_size(), mgdt_voronoi_get_array() and
 *  mgdt_voronoi_get_doubles(). @since 1.3 */
class Voronoi : public detail::Results<detail::VoronoiCalls, detail::Owner<detail::VoronoiCalls>> {
  public:
    /** Makes the diagram; mgdt_voronoi_create(). Cells are clipped to the planes a b c d, to where
     *  a x + b y + c z <= d. @throw Cancelled, OutOfMemory, Error, and what the progress callback
     *  throws */
    explicit Voronoi(const Triangulation& t,
                     const std::vector<std::array<double, 4>>& planes = {}) {
        mgdt_voronoi* made = nullptr;
        const mgdt_status status =
            mgdt_voronoi_create(t.handle(), static_cast<std::int64_t>(planes.size()),
                                planes.empty() ? nullptr : planes[0].data(), &made);
        Voronoi owned(made);  // the callback may throw at the last report, when there is a diagram
        t.require(status);
        *this = std::move(owned);
    }
    /** Takes ownership of a handle of the C interface. */
    explicit Voronoi(mgdt_voronoi* owned) noexcept : Results(owned) {}

    friend void swap(Voronoi& a, Voronoi& b) noexcept { a.swap_with(b); }
    /** Releases ownership of the handle, which the caller frees by mgdt_voronoi_destroy(). */
    [[nodiscard]] mgdt_voronoi* release() noexcept { return release_handle(); }

    /** Leaves out the faces that are smaller than an area, or than a share of the area of each of
     *  their cells; mgdt_voronoi_drop_small_faces(). @throw OutOfMemory, Error */
    void drop_small_faces(double least_area, double least_share = 0) {
        require(mgdt_voronoi_drop_small_faces(get(), least_area, least_share));
    }
};

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_VORONOI_HPP */
