/* SPDX-License-Identifier: MIT
 * The class of one triangulation. Part of mgdt/mgdt.hpp, which includes it and explains it. */
#ifndef MGDT_CXX_TRIANGULATION_HPP
#define MGDT_CXX_TRIANGULATION_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../mgdt.h"
#include "constants.hpp"
#include "error.hpp"
#include "handle.hpp"
#include "views.hpp"

namespace mgdt {
inline namespace cxx1 {

namespace detail {

struct TriangulationCalls {
    using Handle = mgdt_triangulation;
    static constexpr auto destroy = mgdt_destroy;
    static constexpr auto set_progress = mgdt_set_progress;
    static constexpr auto cancel = mgdt_cancel;
    static constexpr auto get_error = mgdt_get_error;
};

}  // namespace detail

/** A Delaunay triangulation that grows as points are inserted. It can be moved, not copied. */
class Triangulation : public detail::Worker<detail::TriangulationCalls> {
  public:
    /** Makes an empty triangulation; mgdt_create(). @throw OutOfMemory */
    Triangulation() : Triangulation(nullptr, nullptr, nullptr) {}

    /** Makes an empty triangulation that takes all its memory from `alloc`;
     *  mgdt_create_with_allocator(). Neither function may throw. @throw OutOfMemory, Error */
    Triangulation(mgdt_alloc_fn alloc, mgdt_free_fn give_back, void* user) {
        make([&](mgdt_triangulation** out) {
            return mgdt_create_with_allocator(alloc, give_back, user, out);
        });
    }

    /** Makes an empty triangulation that takes all its memory from a std::pmr::memory_resource, or
     *  from another class with `allocate(bytes, alignment)` and `deallocate(p, bytes, alignment)`.
     *  The resource must outlive the object. It must be safe to use from several threads if several
     *  threads call const functions. An exception from allocate() counts as out of memory.
     *  @throw OutOfMemory */
    template <class Resource, class = detail::allocate_of<Resource>,
              class = detail::deallocate_of<Resource>>
    explicit Triangulation(Resource& resource)
        : Triangulation(&detail::take<Resource>, &detail::give<Resource>,
                        std::addressof(resource)) {}

    /** Takes ownership of a handle of the C interface, with its settings and progress callback. */
    explicit Triangulation(mgdt_triangulation* owned) noexcept : Worker(owned) {}

    friend void swap(Triangulation& a, Triangulation& b) noexcept { a.swap_with(b); }

    /** mgdt_clear(). @throw Error */
    void clear() { require(mgdt_clear(get())); }
    /** mgdt_reserve(). @throw OutOfMemory, Error */
    void reserve(std::int64_t points) { require(mgdt_reserve(get(), points)); }
    /** mgdt_shrink(). @throw Error @since 1.2 */
    void shrink() { require(mgdt_shrink(get())); }

    /* Settings. @throw Error */

    /** mgdt_set_order_scheme(). */
    void set_order_scheme(Order scheme) {
        require(mgdt_set_order_scheme(get(), static_cast<std::int32_t>(scheme)));
    }
    /** mgdt_set_order_parameter(). */
    void set_order_parameter(Parameter key, double value) {
        require(mgdt_set_order_parameter(get(), static_cast<std::int32_t>(key), value));
    }
    /** mgdt_set_order_parameter() for Parameter::separation. @since 1.2 */
    void set_order_parameter(Parameter key, Separation value) {
        set_order_parameter(key, static_cast<double>(value));
    }
    /** mgdt_set_seed(). */
    void set_seed(std::uint64_t seed) { require(mgdt_set_seed(get(), seed)); }
    /** mgdt_set_threads(). */
    void set_threads(std::int32_t n) { require(mgdt_set_threads(get(), n)); }
    /** mgdt_set_index_base(). */
    void set_index_base(std::int32_t base) { require(mgdt_set_index_base(get(), base)); }
    /** mgdt_set_memory_limit(). */
    void set_memory_limit(std::int64_t bytes) { require(mgdt_set_memory_limit(get(), bytes)); }
    /** mgdt_set_compact(). @throw OutOfMemory, Error */
    void set_compact(bool on) { require(mgdt_set_compact(get(), on ? 1 : 0)); }
    /** mgdt_set_read_progress(). @since 1.3 */
    void set_read_progress(bool on) { require(mgdt_set_read_progress(get(), on ? 1 : 0)); }
    /** mgdt_set_canonical_output(). */
    void set_canonical_output(bool on) { require(mgdt_set_canonical_output(get(), on ? 1 : 0)); }
    /** mgdt_set_isa(). */
    void set_isa(const char* name) { require(mgdt_set_isa(get(), name)); }

    /* The settings: mgdt_get_order_scheme() and the functions beside it. @throw Error @since 1.2 */

    [[nodiscard]] Order order_scheme() const {
        return static_cast<Order>(setting(mgdt_get_order_scheme));
    }
    [[nodiscard]] double order_parameter(Parameter key) const {
        double value = 0;
        require(mgdt_get_order_parameter(get(), static_cast<std::int32_t>(key), &value));
        return value;
    }
    [[nodiscard]] std::uint64_t seed() const { return setting(mgdt_get_seed); }
    [[nodiscard]] std::int32_t threads() const { return setting(mgdt_get_threads); }
    [[nodiscard]] std::int32_t index_base() const { return setting(mgdt_get_index_base); }
    [[nodiscard]] std::int64_t memory_limit() const { return setting(mgdt_get_memory_limit); }
    [[nodiscard]] bool compact() const { return setting(mgdt_get_compact) != 0; }
    /** @since 1.3 */
    [[nodiscard]] bool read_progress() const { return setting(mgdt_get_read_progress) != 0; }
    [[nodiscard]] bool canonical_output() const { return setting(mgdt_get_canonical_output) != 0; }

    /* Points. @throw Cancelled, OutOfMemory, Error, and what the progress callback throws */

    /** mgdt_insert_points(). */
    void insert(Points points) {
        require(
            mgdt_insert_points(get(), static_cast<std::int64_t>(points.count()), points.data()));
    }
    /** Inserts the points of a list: `t.insert({{0, 0, 0}, {1, 0, 0}})`. */
    void insert(std::initializer_list<Point> points) { insert(Points(points)); }
    /** Inserts points whose coordinates are in three arrays of equal length. */
    void insert(Span<const double> x, Span<const double> y, Span<const double> z) {
        if (x.size() != y.size() || x.size() != z.size())
            throw Error(MGDT_ERR_INVALID_ARGUMENT, "the coordinates' arrays have " +
                                                       std::to_string(x.size()) + ", " +
                                                       std::to_string(y.size()) + " and " +
                                                       std::to_string(z.size()) + " elements");
        insert_strided(x.size(), x.data(), y.data(), z.data(), 1);
    }
    /** Inserts n points, each `stride` doubles after the previous one;
     *  mgdt_insert_points_strided(). */
    void insert_strided(std::size_t n, const double* x, const double* y, const double* z,
                        std::int64_t stride) {
        require(mgdt_insert_points_strided(get(), static_cast<std::int64_t>(n), x, y, z, stride));
    }

    /* Removal and motion of points, which are given by their indices in any contiguous container of
     * std::int64_t or std::int32_t, or in a list in braces. @throw Cancelled, OutOfMemory, Error,
     * and what the progress callback throws @since 1.2 */

    /** mgdt_remove_points(). */
    template <class Indices, class = detail::size_t_of<Indices>>
    void remove(const Indices& points) {
        const auto list = detail::row_of(points);
        const auto n = static_cast<std::int64_t>(list.size());
        if constexpr (std::is_same_v<decltype(list), const Span<const std::int64_t>>)
            require(mgdt_remove_points(get(), n, list.data()));
        else
            require(mgdt_remove_points_i32(get(), n, list.data()));
    }
    void remove(std::initializer_list<std::int64_t> points) {
        remove(Span<const std::int64_t>(points.begin(), points.size()));
    }
    /** mgdt_move_points(), with new coordinates for each of the points. */
    template <class Indices, class = detail::size_t_of<Indices>>
    void move(const Indices& points, Points places) {
        const auto list = detail::row_of(points);
        if (list.size() != places.count())
            throw Error(MGDT_ERR_INVALID_ARGUMENT, "there are " + std::to_string(list.size()) +
                                                       " points and " +
                                                       std::to_string(places.count()) + " places");
        // An empty list may have no address.
        if (list.empty()) return;
        const auto n = static_cast<std::int64_t>(list.size());
        if constexpr (std::is_same_v<decltype(list), const Span<const std::int64_t>>)
            require(mgdt_move_points(get(), n, list.data(), places.data()));
        else
            require(mgdt_move_points_i32(get(), n, list.data(), places.data()));
    }
    void move(std::initializer_list<std::int64_t> points, Points places) {
        move(Span<const std::int64_t>(points.begin(), points.size()), places);
    }
    /** Moves all points, in the order of their indices; coordinates of removed points are
     *  ignored. */
    void move(Points places) {
        require(mgdt_move_points(get(), static_cast<std::int64_t>(places.count()), nullptr,
                                 places.data()));
    }
    /** The new index of each point, or none; mgdt_renumber_points(). @throw Error,
     *  std::bad_alloc (the vector's) */
    template <class Int = std::int64_t>
    std::vector<Int> renumber() {
        static_assert(detail::is_index_v<Int>, "indices are std::int64_t or std::int32_t");
        std::vector<Int> index(static_cast<std::size_t>(point_count()));
        const std::int64_t n = point_count();
        if constexpr (std::is_same_v<Int, std::int64_t>)
            require(mgdt_renumber_points(get(), n, index.data()));
        else
            require(mgdt_renumber_points_i32(get(), n, index.data()));
        return index;
    }

    /* Counts. */

    /** mgdt_point_count(). */
    [[nodiscard]] std::int64_t point_count() const noexcept { return mgdt_point_count(get()); }
    /** mgdt_vertex_count(). */
    [[nodiscard]] std::int64_t vertex_count() const noexcept { return mgdt_vertex_count(get()); }
    /** mgdt_dimension(). */
    [[nodiscard]] std::int32_t dimension() const noexcept { return mgdt_dimension(get()); }
    /** mgdt_tetrahedron_count(). */
    [[nodiscard]] std::int64_t tetrahedron_count() const noexcept {
        return mgdt_tetrahedron_count(get());
    }
    /** mgdt_hull_facet_count(). */
    [[nodiscard]] std::int64_t hull_facet_count() const noexcept {
        return mgdt_hull_facet_count(get());
    }
    /** mgdt_edge_count(). */
    [[nodiscard]] std::int64_t edge_count() const noexcept { return mgdt_edge_count(get()); }
    /** mgdt_vertex_tetrahedra_count(). */
    [[nodiscard]] std::int64_t vertex_tetrahedra_count() const noexcept {
        return mgdt_vertex_tetrahedra_count(get());
    }

    /** mgdt_vertex_neighbors_count(). @since 1.2 */
    [[nodiscard]] std::int64_t vertex_neighbors_count() const noexcept {
        return mgdt_vertex_neighbors_count(get());
    }

    /* Export. A function without arguments returns a vector of 64-bit integers, or of 32-bit
     * integers as `t.tetrahedra<std::int32_t>()`. A function with an argument writes to a
     * contiguous container that is large enough, of std::int64_t or std::int32_t, or of std::arrays
     * of them.
     * @throw OutOfMemory, Error, std::bad_alloc (the vector's) */

    /** mgdt_get_tetrahedra(). */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<std::array<Int, 4>> tetrahedra() const {
        return result<Int, 4>(tetrahedron_count(), mgdt_get_tetrahedra, mgdt_get_tetrahedra_i32);
    }
    template <class Buffer>
    void tetrahedra(Buffer&& out) const {
        write<4>(out, mgdt_get_tetrahedra, mgdt_get_tetrahedra_i32);
    }
    /** mgdt_get_neighbors(). */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<std::array<Int, 4>> neighbors() const {
        return result<Int, 4>(tetrahedron_count(), mgdt_get_neighbors, mgdt_get_neighbors_i32);
    }
    template <class Buffer>
    void neighbors(Buffer&& out) const {
        write<4>(out, mgdt_get_neighbors, mgdt_get_neighbors_i32);
    }
    /** mgdt_get_hull_facets(). */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<std::array<Int, 3>> hull_facets() const {
        return result<Int, 3>(hull_facet_count(), mgdt_get_hull_facets, mgdt_get_hull_facets_i32);
    }
    template <class Buffer>
    void hull_facets(Buffer&& out) const {
        write<3>(out, mgdt_get_hull_facets, mgdt_get_hull_facets_i32);
    }
    /** mgdt_get_edges(). */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<std::array<Int, 2>> edges() const {
        return result<Int, 2>(edge_count(), mgdt_get_edges, mgdt_get_edges_i32);
    }
    template <class Buffer>
    void edges(Buffer&& out) const {
        write<2>(out, mgdt_get_edges, mgdt_get_edges_i32);
    }
    /** mgdt_get_point_map(). */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<Int> point_map() const {
        std::vector<Int> map(static_cast<std::size_t>(point_count()));
        write<1>(map, mgdt_get_point_map, mgdt_get_point_map_i32);
        return map;
    }
    template <class Buffer>
    void point_map(Buffer&& out) const {
        write<1>(out, mgdt_get_point_map, mgdt_get_point_map_i32);
    }
    /** mgdt_get_vertex_tetrahedra(). */
    template <class Int = std::int64_t>
    [[nodiscard]] PointLists<Int> vertex_tetrahedra() const {
        return lists<Int>(vertex_tetrahedra_count(), mgdt_get_vertex_tetrahedra,
                          mgdt_get_vertex_tetrahedra_i32);
    }
    template <class Offsets, class List>
    void vertex_tetrahedra(Offsets&& offsets, List&& list) const {
        write_lists(offsets, list, mgdt_get_vertex_tetrahedra, mgdt_get_vertex_tetrahedra_i32);
    }
    /** mgdt_get_vertex_neighbors(). @since 1.2 */
    template <class Int = std::int64_t>
    [[nodiscard]] PointLists<Int> vertex_neighbors() const {
        return lists<Int>(vertex_neighbors_count(), mgdt_get_vertex_neighbors,
                          mgdt_get_vertex_neighbors_i32);
    }
    template <class Offsets, class List>
    void vertex_neighbors(Offsets&& offsets, List&& list) const {
        write_lists(offsets, list, mgdt_get_vertex_neighbors, mgdt_get_vertex_neighbors_i32);
    }
    /** mgdt_get_gabriel_edges(). @since 1.2 */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<std::array<Int, 2>> gabriel_edges() const {
        return graph<Int>(edge_count(), mgdt_get_gabriel_edges, mgdt_get_gabriel_edges_i32);
    }
    /** mgdt_get_spanning_tree(). @since 1.2 */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<std::array<Int, 2>> spanning_tree() const {
        return graph<Int>(vertex_count(), mgdt_get_spanning_tree, mgdt_get_spanning_tree_i32);
    }
    /** mgdt_get_circumcenters(). @since 1.2 */
    [[nodiscard]] Circumspheres circumspheres() const {
        Circumspheres result;
        const auto n = static_cast<std::size_t>(tetrahedron_count());
        result.centers.resize(n);
        result.squared_radii.resize(n);
        require(mgdt_get_circumcenters(get(), static_cast<std::int64_t>(n),
                                       n == 0 ? nullptr : result.centers[0].data(),
                                       result.squared_radii.data()));
        return result;
    }
    /** Measures each tetrahedron; mgdt_get_tetrahedron_measures(). @since 1.3 */
    [[nodiscard]] std::vector<double> tetrahedron_measures(TetrahedronMeasure measure) const {
        std::vector<double> x(static_cast<std::size_t>(tetrahedron_count()));
        require(mgdt_get_tetrahedron_measures(get(), static_cast<std::int32_t>(measure),
                                              static_cast<std::int64_t>(x.size()), x.data()));
        return x;
    }
    /** Measures each Voronoi cell: one number, or three for a centroid. Cells are clipped to the
     *  planes a b c d, to where a x + b y + c z <= d; mgdt_get_cell_measures(). @since 1.2 */
    [[nodiscard]] std::vector<double> cell_measures(
        Measure measure, const std::vector<std::array<double, 4>>& planes = {}) const {
        const std::size_t width = measure == Measure::centroid ? 3 : 1;
        std::vector<double> x(width * static_cast<std::size_t>(point_count()));
        require(mgdt_get_cell_measures(get(), static_cast<std::int32_t>(measure),
                                       static_cast<std::int64_t>(planes.size()),
                                       planes.empty() ? nullptr : planes[0].data(),
                                       static_cast<std::int64_t>(x.size()), x.data()));
        return x;
    }

    /** The alpha of each simplex of a dimension, with 4 facets per tetrahedron; mgdt_get_alphas().
     *  @since 1.2 */
    [[nodiscard]] std::vector<double> alphas(std::int32_t dimension) const {
        const std::int64_t counts[] = {point_count(), edge_count(), 4 * tetrahedron_count(),
                                       tetrahedron_count()};
        const bool is_known = dimension >= 0 && dimension <= 3;
        std::vector<double> x(is_known ? static_cast<std::size_t>(counts[dimension]) : 0);
        require(mgdt_get_alphas(get(), dimension, static_cast<std::int64_t>(x.size()), x.data()));
        return x;
    }
    /** The surface of an alpha shape; mgdt_get_alpha_surface(). @since 1.2 */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<std::array<Int, 3>> alpha_surface(double alpha2) const {
        static_assert(detail::is_index_v<Int>, "indices are std::int64_t or std::int32_t");
        // The surfaces of most shapes fit. If one does not, the count says how much room it needs.
        std::vector<std::array<Int, 3>> v(static_cast<std::size_t>(2 * vertex_count() + 4));
        for (;;) {
            Int count = 0;
            mgdt_status status;
            const auto room = static_cast<std::int64_t>(3 * v.size());
            if constexpr (std::is_same_v<Int, std::int64_t>)
                status = mgdt_get_alpha_surface(get(), alpha2, room, v[0].data(), &count);
            else
                status = mgdt_get_alpha_surface_i32(get(), alpha2, room, v[0].data(), &count);
            const bool is_short = status == MGDT_ERR_BUFFER_TOO_SMALL;
            if (!is_short) require(status);
            v.resize(static_cast<std::size_t>(count));
            if (!is_short) return v;
        }
    }
    /** The least alpha whose shape is one solid with all vertices; mgdt_get_solid_alpha().
     *  @since 1.2 */
    [[nodiscard]] double solid_alpha() const {
        double alpha2 = 0;
        require(mgdt_get_solid_alpha(get(), &alpha2));
        return alpha2;
    }

    /* Queries. @throw OutOfMemory, Error, std::bad_alloc (the vectors') */

    /** The tetrahedron that contains a point, or none; mgdt_locate(). */
    [[nodiscard]] std::int64_t locate(const Point& xyz) const {
        std::int64_t found = 0;
        require(mgdt_locate(get(), xyz.data(), &found));
        return found;
    }
    /** The tetrahedra that contain many points; mgdt_locate_points(). */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<Int> locate_points(Points points) const {
        std::vector<Int> found(points.count());
        locate_points(points, found);
        return found;
    }
    /** The tetrahedra that contain many points, and the barycentric coordinates of the points;
     *  mgdt_locate_points(). */
    template <class Int = std::int64_t>
    [[nodiscard]] Located<Int> locate_with_weights(Points points) const {
        Located<Int> result;
        result.tetrahedra.resize(points.count());
        result.weights.resize(points.count());
        locate_points(points, result.tetrahedra, result.weights);
        return result;
    }
    /** Writes the tetrahedra that contain many points to a buffer with one number per point. */
    template <class Buffer>
    void locate_points(Points points, Buffer&& out) const {
        locate_into(points, detail::flat<1>(out), nullptr);
    }
    /** Writes the tetrahedra and the barycentric coordinates of many points to buffers. Per point,
     *  `weights` has four doubles or an std::array of them. */
    template <class Buffer, class Weights>
    void locate_points(Points points, Buffer&& out, Weights&& weights) const {
        using Group = detail::group<detail::element_t<Weights>, 4>;
        static_assert(std::is_same_v<typename Group::index, double>, "weights are doubles");
        if (static_cast<std::size_t>(std::size(weights)) * Group::width / 4 < points.count())
            too_small("weights", points.count());
        locate_into(points, detail::flat<1>(out), detail::pointer<double>(weights));
    }
    /** The tetrahedra that the segment from a to b passes through, in order;
     *  mgdt_traverse_segment(). @since 1.3 */
    template <class Int = std::int64_t>
    [[nodiscard]] Traversal<Int> traverse_segment(const Point& a, const Point& b) const {
        static_assert(detail::is_index_v<Int>, "indices are std::int64_t or std::int32_t");
        Traversal<Int> way;
        // Most segments fit. If one does not, the count says how much room it needs.
        Int count = 128;
        for (;;) {
            const Int room = count;
            way.tetrahedra.resize(static_cast<std::size_t>(room));
            way.parameters.resize(static_cast<std::size_t>(room) + 1);
            const auto read = [&](auto function) {
                return function(get(), a.data(), b.data(), room, way.tetrahedra.data(),
                                way.parameters.data(), &count);
            };
            mgdt_status status;
            if constexpr (std::is_same_v<Int, std::int64_t>)
                status = read(mgdt_traverse_segment);
            else
                status = read(mgdt_traverse_segment_i32);
            if (status == MGDT_ERR_BUFFER_TOO_SMALL) continue;
            require(status);
            way.tetrahedra.resize(static_cast<std::size_t>(count));
            way.parameters.resize(count == 0 ? 0 : static_cast<std::size_t>(count) + 1);
            return way;
        }
    }
    /** The vertex nearest to a point, or none; mgdt_nearest_vertex(). */
    [[nodiscard]] std::int64_t nearest_vertex(const Point& xyz) const {
        std::int64_t found = 0;
        require(mgdt_nearest_vertex(get(), xyz.data(), &found));
        return found;
    }
    /** The vertices nearest to many points; mgdt_nearest_vertices(). @since 1.2 */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<Int> nearest_vertices(Points points) const {
        std::vector<Int> found(points.count());
        nearest_vertices(points, found);
        return found;
    }
    /** Writes the vertices nearest to many points to a buffer with one number per point. @since
     *  1.2 */
    template <class Buffer>
    void nearest_vertices(Points points, Buffer&& out) const {
        const auto buffer = detail::flat<1>(out);
        if (buffer.size() < points.count()) too_small("vertices", points.count());
        const auto n = static_cast<std::int64_t>(points.count());
        if constexpr (std::is_same_v<decltype(buffer), const Span<std::int64_t>>)
            require(mgdt_nearest_vertices(get(), n, points.data(), buffer.data()));
        else
            require(mgdt_nearest_vertices_i32(get(), n, points.data(), buffer.data()));
    }

    /* Values between points. @throw OutOfMemory, Error, std::bad_alloc (the vectors') */

    /** Interpolates values at places from values at the points, with `fields` consecutive numbers
     *  per point and place; mgdt_interpolate(). @since 1.2 */
    [[nodiscard]] std::vector<double> interpolate(Method method, Outside outside,
                                                  Span<const double> values, Points places,
                                                  std::size_t fields = 1) const {
        require_values(values, fields);
        std::vector<double> out(fields * places.count());
        require(mgdt_interpolate(
            get(), static_cast<std::int32_t>(method), static_cast<std::int32_t>(outside),
            static_cast<std::int64_t>(fields), values.data(),
            static_cast<std::int64_t>(places.count()), places.data(), out.data()));
        return out;
    }
    /** The weights of interpolation, for any fields; mgdt_get_interpolation_weights(). @since
     *  1.2 */
    template <class Int = std::int64_t>
    [[nodiscard]] Weights<Int> interpolation_weights(Method method, Outside outside,
                                                     Points places) const {
        static_assert(detail::is_index_v<Int>, "indices are std::int64_t or std::int32_t");
        Weights<Int> rows;
        rows.offsets.resize(places.count() + 1);
        // Most weights fit. If they do not, the last offset says how much room they need.
        std::size_t room = (method == Method::linear ? 4 : 24) * places.count() + 8;
        for (;;) {
            rows.points.resize(room);
            rows.weights.resize(room);
            const auto read = [&](auto function) {
                return function(
                    get(), static_cast<std::int32_t>(method), static_cast<std::int32_t>(outside),
                    static_cast<std::int64_t>(places.count()), places.data(),
                    static_cast<std::int64_t>(rows.offsets.size()), rows.offsets.data(),
                    static_cast<std::int64_t>(room), rows.points.data(), rows.weights.data());
            };
            mgdt_status status;
            if constexpr (std::is_same_v<Int, std::int64_t>)
                status = read(mgdt_get_interpolation_weights);
            else
                status = read(mgdt_get_interpolation_weights_i32);
            const bool is_short = status == MGDT_ERR_BUFFER_TOO_SMALL;
            if (!is_short) require(status);
            room = static_cast<std::size_t>(rows.offsets.back() - rows.offsets.front());
            if (is_short) continue;
            rows.points.resize(room);
            rows.weights.resize(room);
            return rows;
        }
    }
    /** Estimates gradients of values at the points: three numbers for each field of each point;
     *  mgdt_get_gradients(). @since 1.2 */
    [[nodiscard]] std::vector<double> gradients(Span<const double> values,
                                                std::size_t fields = 1) const {
        require_values(values, fields);
        std::vector<double> out(3 * fields * static_cast<std::size_t>(point_count()));
        require(mgdt_get_gradients(get(), static_cast<std::int64_t>(fields), values.data(),
                                   out.data()));
        return out;
    }

    /* Trust and figures. */

    /** Checks that the triangulation is valid; mgdt_check().
     *  @throw OutOfMemory, Error; the one for MGDT_ERR_CHECK_FAILED says what is wrong and where */
    void check(Check level = Check::canonical) const {
        require(mgdt_check(get(), static_cast<std::int32_t>(level)));
    }
    /** mgdt_get_stat(). @throw Error */
    [[nodiscard]] double statistic(Statistic key) const {
        double value = 0;
        require(mgdt_get_stat(get(), static_cast<std::int32_t>(key), &value));
        return value;
    }

    /** mgdt_isa_name(). */
    [[nodiscard]] const char* isa() const noexcept { return mgdt_isa_name(get()); }

  private:
    template <class T>
    T setting(mgdt_status (*read)(const mgdt_triangulation*, T*)) const {
        T value{};
        require(read(get(), &value));
        return value;
    }
    void require_values(Span<const double> values, std::size_t fields) const {
        const auto points = static_cast<std::size_t>(point_count());
        if (fields != 0 && values.size() / fields < points) too_small("values", points);
    }
    [[noreturn]] static void too_small(const char* what, std::size_t points) {
        throw Error(MGDT_ERR_BUFFER_TOO_SMALL, std::string("the buffer of ") + what +
                                                   " is too small for " + std::to_string(points) +
                                                   " points");
    }

    template <class Int>
    using Export = mgdt_status (*)(const mgdt_triangulation*, std::int64_t, Int*);
    template <std::size_t K, class C>
    void write(C& out, Export<std::int64_t> wide, Export<std::int32_t> narrow) const {
        const auto buffer = detail::flat<K>(out);
        const auto capacity = static_cast<std::int64_t>(buffer.size());
        if constexpr (std::is_same_v<decltype(buffer), const Span<std::int64_t>>)
            require(wide(get(), capacity, buffer.data()));
        else
            require(narrow(get(), capacity, buffer.data()));
    }
    template <class Int, std::size_t K>
    std::vector<std::array<Int, K>> result(std::int64_t count, Export<std::int64_t> wide,
                                           Export<std::int32_t> narrow) const {
        static_assert(detail::is_index_v<Int>, "indices are std::int64_t or std::int32_t");
        std::vector<std::array<Int, K>> v(static_cast<std::size_t>(count));
        write<K>(v, wide, narrow);
        return v;
    }
    template <class Int>
    using ListExport = mgdt_status (*)(const mgdt_triangulation*, std::int64_t, Int*, std::int64_t,
                                       Int*);
    template <class Offsets, class List>
    void write_lists(Offsets& offsets, List& list, ListExport<std::int64_t> wide,
                     ListExport<std::int32_t> narrow) const {
        const auto first = detail::flat<1>(offsets);
        const auto second = detail::flat<1>(list);
        using Int = std::remove_reference_t<decltype(first[0])>;
        static_assert(std::is_same_v<decltype(first), decltype(second)>,
                      "offsets and list have the same kind of integers");
        const auto n = static_cast<std::int64_t>(first.size());
        const auto m = static_cast<std::int64_t>(second.size());
        if constexpr (std::is_same_v<Int, std::int64_t>)
            require(wide(get(), n, first.data(), m, second.data()));
        else
            require(narrow(get(), n, first.data(), m, second.data()));
    }
    template <class Int>
    PointLists<Int> lists(std::int64_t length, ListExport<std::int64_t> wide,
                          ListExport<std::int32_t> narrow) const {
        static_assert(detail::is_index_v<Int>, "indices are std::int64_t or std::int32_t");
        PointLists<Int> v;
        v.offsets.resize(static_cast<std::size_t>(point_count()) + 1);
        v.list.resize(static_cast<std::size_t>(length));
        write_lists(v.offsets, v.list, wide, narrow);
        return v;
    }
    template <class Int>
    using GraphExport = mgdt_status (*)(const mgdt_triangulation*, std::int64_t, Int*, Int*);
    template <class Int>
    std::vector<std::array<Int, 2>> graph(std::int64_t most, GraphExport<std::int64_t> wide,
                                          GraphExport<std::int32_t> narrow) const {
        static_assert(detail::is_index_v<Int>, "indices are std::int64_t or std::int32_t");
        std::vector<std::array<Int, 2>> v(static_cast<std::size_t>(most));
        Int count = 0;
        Int* const out = v.empty() ? nullptr : v[0].data();
        if constexpr (std::is_same_v<Int, std::int64_t>)
            require(wide(get(), 2 * most, out, &count));
        else
            require(narrow(get(), 2 * most, out, &count));
        v.resize(static_cast<std::size_t>(count));
        return v;
    }
    template <class Int>
    void locate_into(Points points, Span<Int> out, double* weights) const {
        if (out.size() < points.count()) too_small("tetrahedra", points.count());
        const auto n = static_cast<std::int64_t>(points.count());
        if constexpr (std::is_same_v<Int, std::int64_t>)
            require(mgdt_locate_points(get(), n, points.data(), out.data(), weights));
        else
            require(mgdt_locate_points_i32(get(), n, points.data(), out.data(), weights));
    }
};

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_TRIANGULATION_HPP */
