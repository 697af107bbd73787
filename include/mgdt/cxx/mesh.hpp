/* SPDX-License-Identifier: MIT
 * The class of a mesh. Part of mgdt/mgdt.hpp, which includes it and explains it. */
#ifndef MGDT_CXX_MESH_HPP
#define MGDT_CXX_MESH_HPP

#include <cstdint>
#include <utility>
#include <vector>

#include "../mgdt_mesh.h"
#include "constants.hpp"
#include "handle.hpp"

namespace mgdt {
inline namespace cxx1 {

namespace detail {

struct MeshCalls {
    using Handle = mgdt_mesh;
    using Option = MeshOption;
    using Statistic = MeshStatistic;
    using Array = MeshArray;
    using Doubles = MeshDoubles;
    static constexpr auto destroy = mgdt_mesh_destroy;
    static constexpr auto set_progress = mgdt_mesh_set_progress;
    static constexpr auto cancel = mgdt_mesh_cancel;
    static constexpr auto get_error = mgdt_mesh_get_error;
    static constexpr auto set_option = mgdt_mesh_set_option;
    static constexpr auto get_option = mgdt_mesh_get_option;
    static constexpr auto get_stat = mgdt_mesh_get_stat;
    static constexpr auto array_info = mgdt_mesh_array_info;
    static constexpr auto get_size = mgdt_mesh_get_size;
    static constexpr auto get_array = mgdt_mesh_get_array;
    static constexpr auto get_array_i32 = mgdt_mesh_get_array_i32;
    static constexpr auto get_doubles = mgdt_mesh_get_doubles;
};

}  // namespace detail

/** A mesh of tetrahedra, which Domain::build() makes; see mgdt_mesh.h. It can be moved, not copied.
 *  Options, statistics and arrays: mgdt_mesh_set_option(), mgdt_mesh_get_option(),
 *  mgdt_mesh_get_stat(), mgdt_mesh_array_info(), mgdt_mesh_get_size(), mgdt_mesh_get_array() and
 *  mgdt_mesh_get_doubles(). @since 1.3 */
class Mesh : public detail::Results<detail::MeshCalls> {
  public:
    /** Takes ownership of a handle of the C interface. */
    explicit Mesh(mgdt_mesh* owned) noexcept : Results(owned) {}
    friend void swap(Mesh& a, Mesh& b) noexcept { a.swap_with(b); }

    /** The points: those that were set, then the Steiner points. @throw Error, std::bad_alloc (the
     *  vector's) */
    [[nodiscard]] std::vector<Point> points() const { return Results::points(MeshDoubles::points); }
    /** A measure of each tetrahedron; mgdt_mesh_get_tetrahedron_measures(). @throw OutOfMemory,
     *  Error, std::bad_alloc (the vector's) */
    [[nodiscard]] std::vector<double> tetrahedron_measures(TetrahedronMeasure measure) const {
        std::vector<double> x(static_cast<std::size_t>(statistic(MeshStatistic::tetrahedra)));
        require(mgdt_mesh_get_tetrahedron_measures(get(), static_cast<std::int32_t>(measure),
                                                   static_cast<std::int64_t>(x.size()), x.data()));
        return x;
    }
    /** mgdt_mesh_check(). @throw Cancelled, OutOfMemory, Error, and what the progress callback
     *  throws */
    void check() const { require(mgdt_mesh_check(get())); }
};

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_MESH_HPP */
