/* SPDX-License-Identifier: MIT
 * The class of a mesh. Part of mgdt/mgdt.hpp, which includes it and explains it. */
#ifndef MGDT_CXX_MESH_HPP
#define MGDT_CXX_MESH_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "../mgdt_mesh.h"
#include "constants.hpp"
#include "error.hpp"
#include "handle.hpp"
#include "views.hpp"

namespace mgdt {
inline namespace cxx1 {

namespace detail {

struct MeshCalls {
    using Handle = mgdt_mesh;
    using Option = MeshOption;
    using DoubleOption = MeshDoubleOption;
    using Statistic = MeshStatistic;
    using Array = MeshArray;
    using Doubles = MeshDoubles;
    static constexpr auto destroy = mgdt_mesh_destroy;
    static constexpr auto set_progress = mgdt_mesh_set_progress;
    static constexpr auto cancel = mgdt_mesh_cancel;
    static constexpr auto get_error = mgdt_mesh_get_error;
    static constexpr auto set_option = mgdt_mesh_set_option;
    static constexpr auto get_option = mgdt_mesh_get_option;
    static constexpr auto set_double_option = mgdt_mesh_set_double_option;
    static constexpr auto get_double_option = mgdt_mesh_get_double_option;
    static constexpr auto get_stat = mgdt_mesh_get_stat;
    static constexpr auto array_info = mgdt_mesh_array_info;
    static constexpr auto get_size = mgdt_mesh_get_size;
    static constexpr auto get_array = mgdt_mesh_get_array;
    static constexpr auto get_array_i32 = mgdt_mesh_get_array_i32;
    static constexpr auto get_doubles = mgdt_mesh_get_doubles;
};

// The size function.
class SizeFunction {
  public:
    SizeFunction() = default;
    SizeFunction(const SizeFunction&) = delete;
    SizeFunction& operator=(const SizeFunction&) = delete;
    virtual ~SizeFunction() = default;

    // An mgdt_size_fn whose `user` is a SizeFunction.
    static std::int32_t answer(std::int64_t n, const double* xyz, double* sizes,
                               void* user) noexcept {
        SizeFunction& self = *static_cast<SizeFunction*>(user);
        return self.guarded_.run(1, [&] {
            self.find(n, xyz, sizes);
            return 0;
        });
    }
    void rethrow() { guarded_.rethrow(); }

  private:
    virtual void find(std::int64_t n, const double* xyz, double* sizes) = 0;

    Guarded guarded_{};
};
template <class F>
class SizeCallback final : public SizeFunction {
  public:
    explicit SizeCallback(F call) : call_(std::move(call)) {}

  private:
    void find(std::int64_t n, const double* xyz, double* sizes) override {
        for (std::int64_t i = 0; i < n; ++i, xyz += 3)
            sizes[i] = std::invoke(call_, Point{xyz[0], xyz[1], xyz[2]});
    }

    F call_;
};

}  // namespace detail

/** The shapes of all tetrahedra of a mesh; mgdt_mesh_get_shape_summary(). @since 1.4 */
struct ShapeSummary {
    double least_angle = 0, largest_angle = 0; /**< Dihedral angles, in degrees. */
    double mean_volume_length = 0;             /**< Mean of TetrahedronMeasure::volume_length. */
    std::array<std::int64_t, 18> angles{};     /**< Angles from 0 to 10 degrees, 10 to 20, ... */
    /** Tetrahedra with an angle below 5, 10, 15, 20, 25 and 30 degrees. */
    std::array<std::int64_t, 6> tetrahedra_below{};
};

/** A mesh of tetrahedra, which Domain::build() makes, or build(); see mgdt_mesh.h. It can be
 *  moved, not copied. Options, statistics and arrays: mgdt_mesh_set_option(),
 *  mgdt_mesh_get_option(), mgdt_mesh_set_double_option(), mgdt_mesh_get_double_option(),
 *  mgdt_mesh_get_stat(), mgdt_mesh_array_info(), mgdt_mesh_get_size(), mgdt_mesh_get_array() and
 *  mgdt_mesh_get_doubles().
 *  @since 1.3 */
class Mesh : public detail::Results<detail::MeshCalls> {
  public:
    /** Makes a mesh without tetrahedra; mgdt_mesh_create(). @throw OutOfMemory, Error @since 1.4 */
    Mesh() : Mesh(nullptr, nullptr, nullptr) {}
    /** Makes a mesh that takes all its memory from `alloc`; mgdt_mesh_create_with_allocator().
     *  Neither function may throw. @throw OutOfMemory, Error @since 1.4 */
    Mesh(mgdt_alloc_fn alloc, mgdt_free_fn give_back, void* user) {
        make([&](mgdt_mesh** out) {
            return mgdt_mesh_create_with_allocator(alloc, give_back, user, out);
        });
    }
    /** Takes ownership of a handle of the C interface. */
    explicit Mesh(mgdt_mesh* owned) noexcept : Results(owned) {}
    friend void swap(Mesh& a, Mesh& b) noexcept {
        a.swap_with(b);
        a.size_function_.swap(b.size_function_);
    }
    /** Releases ownership of the handle, which the caller frees by mgdt_mesh_destroy().
     *  Callbacks of set_progress() and set_size_function() are removed. Returns NULL and releases
     *  nothing in a callback of the object. */
    [[nodiscard]] mgdt_mesh* release() noexcept {
        if (size_function_ && mgdt_mesh_set_size_function(get(), nullptr, nullptr) != MGDT_OK)
            return nullptr;
        size_function_.reset();
        return Results::release();
    }

    /** mgdt_mesh_set_points(). @throw OutOfMemory, Error @since 1.4 */
    void set_points(Points points) {
        require(
            mgdt_mesh_set_points(get(), static_cast<std::int64_t>(points.count()), points.data()));
    }
    /** mgdt_mesh_set_tetrahedra().
     *  @param corners  four for each
     *  @param markers  one for each, or none
     *  @throw OutOfMemory, Error
     *  @since 1.4 */
    void set_tetrahedra(Span<const std::int64_t> corners, Span<const std::int32_t> markers = {}) {
        set_items(mgdt_mesh_set_tetrahedra, 4, corners, markers);
    }
    /** mgdt_mesh_set_faces().
     *  @param corners  three for each
     *  @param markers  one for each, or none
     *  @throw OutOfMemory, Error
     *  @since 1.4 */
    void set_faces(Span<const std::int64_t> corners, Span<const std::int32_t> markers = {}) {
        set_items(mgdt_mesh_set_faces, 3, corners, markers);
    }
    /** mgdt_mesh_set_edges().
     *  @param ends     two for each
     *  @param markers  one for each, or none
     *  @throw OutOfMemory, Error
     *  @since 1.4 */
    void set_edges(Span<const std::int64_t> ends, Span<const std::int32_t> markers = {}) {
        set_items(mgdt_mesh_set_edges, 2, ends, markers);
    }
    /** mgdt_mesh_set_fixed_points(). @throw OutOfMemory, Error @since 1.4 */
    void set_fixed_points(Span<const std::int64_t> points) {
        require(mgdt_mesh_set_fixed_points(get(), static_cast<std::int64_t>(points.size()),
                                           points.data()));
    }

    /** Sizes of edges for the next refine(); mgdt_mesh_set_sizes(). None remove those that were
     *  set.
     *  @throw OutOfMemory, Error @since 1.4 */
    void set_sizes(Sizes of, Span<const double> sizes) {
        require(mgdt_mesh_set_sizes(get(), static_cast<std::int32_t>(of),
                                    static_cast<std::int64_t>(sizes.size()), sizes.data()));
    }

    /** Sizes of edges at points, linear between them; mgdt_mesh_set_size_field(). None remove those
     *  that were set.
     *  @param sizes  one for each point
     *  @throw OutOfMemory, Error @since 1.4 */
    void set_size_field(Points points, Span<const double> sizes) {
        detail::require_size(sizes.size() == points.count(), "there is not one size for each");
        require(mgdt_mesh_set_size_field(get(), static_cast<std::int64_t>(points.count()),
                                         points.data(), sizes.data()));
    }
    /** Sets the function that gives sizes of edges; mgdt_mesh_set_size_function().
     *  @param call  a callable that takes a Point and returns the size there, 0 for none.
     *  The object keeps it. If it throws, refine() throws that exception.
     *  @throw Error, std::bad_alloc @since 1.4 */
    template <class F,
              class = std::enable_if_t<std::is_invocable_r_v<double, std::decay_t<F>&, Point>>>
    void set_size_function(F&& call) {
        auto next = std::make_unique<detail::SizeCallback<std::decay_t<F>>>(std::forward<F>(call));
        require(mgdt_mesh_set_size_function(get(), &detail::SizeFunction::answer,
                                            static_cast<detail::SizeFunction*>(next.get())));
        size_function_ = std::move(next);
    }
    /** Removes the size function. @throw Error @since 1.4 */
    void clear_size_function() {
        require(mgdt_mesh_set_size_function(get(), nullptr, nullptr));
        size_function_.reset();
    }

    /** mgdt_mesh_build(). @throw Cancelled, OutOfMemory, Error, and what the progress callback
     *  throws @since 1.4 */
    void build() { require(mgdt_mesh_build(get())); }
    /** mgdt_mesh_refine(). @throw Cancelled, OutOfMemory, Error, and what the progress callback
     *  and the size function throw @since 1.4 */
    void refine() {
        const mgdt_status status = mgdt_mesh_refine(get());
        if (size_function_) size_function_->rethrow();
        require(status);
    }
    /** mgdt_mesh_improve(). @throw Cancelled, OutOfMemory, Error, and what the progress callback
     *  throws @since 1.4 */
    void improve() { require(mgdt_mesh_improve(get())); }

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
    /** The shapes of all tetrahedra in a few numbers; mgdt_mesh_get_shape_summary(). @throw
     *  OutOfMemory, Error @since 1.4 */
    [[nodiscard]] ShapeSummary shape_summary() const {
        ShapeSummary s;
        double shapes[3] = {};
        require(
            mgdt_mesh_get_shape_summary(get(), shapes, s.angles.data(), s.tetrahedra_below.data()));
        s.least_angle = shapes[0];
        s.largest_angle = shapes[1];
        s.mean_volume_length = shapes[2];
        return s;
    }

    /** The tetrahedra that contain points, or none; mgdt_mesh_locate_points().
     *  @param outside  Outside::none or Outside::boundary
     *  @throw OutOfMemory, Error, std::bad_alloc (the vector's)
     *  @since 1.4 */
    [[nodiscard]] std::vector<std::int64_t> locate_points(Points points,
                                                          Outside outside = Outside::none) const {
        std::vector<std::int64_t> found(points.count());
        locate(points, outside, found.data(), nullptr);
        return found;
    }
    /** The same with the barycentric coordinates. @since 1.4 */
    [[nodiscard]] Located<std::int64_t> locate_with_weights(Points points,
                                                            Outside outside = Outside::none) const {
        Located<std::int64_t> found;
        found.tetrahedra.resize(points.count());
        found.weights.resize(points.count());
        locate(points, outside, found.tetrahedra.data(),
               found.weights.empty() ? nullptr : found.weights[0].data());
        return found;
    }
    /** Whether the mesh contains a point, exactly. @throw OutOfMemory, Error @since 1.4 */
    [[nodiscard]] bool contains(const Point& xyz) const {
        std::int64_t found = 0;
        require(mgdt_mesh_locate_points(get(), MGDT_OUTSIDE_NONE, 1, xyz.data(), &found, nullptr));
        return found >= option(MeshOption::index_base);
    }
    /** Interpolates values at places from values at the points, with `fields` consecutive numbers
     *  per point and place; mgdt_mesh_interpolate().
     *  @param outside  Outside::none or Outside::boundary
     *  @throw OutOfMemory, Error, std::bad_alloc (the vector's)
     *  @since 1.4 */
    [[nodiscard]] std::vector<double> interpolate(Span<const double> values, Points places,
                                                  Outside outside = Outside::none,
                                                  std::size_t fields = 1) const {
        const auto points = static_cast<std::size_t>(statistic(MeshStatistic::points));
        detail::require_size(values.size() == fields * points,
                             "there are not as many values as points and fields");
        std::vector<double> out(fields * places.count());
        require(mgdt_mesh_interpolate(
            get(), static_cast<std::int32_t>(outside), static_cast<std::int64_t>(fields),
            values.data(), static_cast<std::int64_t>(places.count()), places.data(), out.data()));
        return out;
    }

    /** mgdt_mesh_check(). @throw Cancelled, OutOfMemory, Error, and what the progress callback
     *  throws */
    void check() const { require(mgdt_mesh_check(get())); }

  private:
    void locate(Points points, Outside outside, std::int64_t* tetrahedra, double* weights) const {
        require(mgdt_mesh_locate_points(get(), static_cast<std::int32_t>(outside),
                                        static_cast<std::int64_t>(points.count()), points.data(),
                                        tetrahedra, weights));
    }
    template <class Set>
    void set_items(Set set, std::size_t each, Span<const std::int64_t> corners,
                   Span<const std::int32_t> markers) {
        const std::size_t n = corners.size() / each;
        detail::require_size(corners.size() % each == 0, "the last one lacks corners");
        detail::require_markers(n, markers);
        require(set(get(), static_cast<std::int64_t>(n), corners.data(),
                    markers.size() > 0 ? markers.data() : nullptr));
    }

    std::unique_ptr<detail::SizeFunction> size_function_{};
};

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_MESH_HPP */
