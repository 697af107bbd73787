/* SPDX-License-Identifier: MIT
 * The class of a Voronoi diagram. Part of mgdt/mgdt.hpp, which includes it and explains it. */
#ifndef MGDT_CXX_VORONOI_HPP
#define MGDT_CXX_VORONOI_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "../mgdt_voronoi.h"
#include "constants.hpp"
#include "error.hpp"
#include "handle.hpp"
#include "triangulation.hpp"
#include "views.hpp"

namespace mgdt {
inline namespace cxx1 {

/** The Voronoi diagram of the points of a triangulation, which it outlives; see mgdt_voronoi.h. It
 *  can be moved, not copied. @since 1.3 */
class Voronoi {
  public:
    /** Makes the diagram; mgdt_voronoi_create(). Cells are clipped to the planes a b c d, to where
     *  a x + b y + c z <= d. @throw OutOfMemory, Error */
    explicit Voronoi(const Triangulation& t,
                     const std::vector<std::array<double, 4>>& planes = {}) {
        mgdt_voronoi* made = nullptr;
        const mgdt_status status =
            mgdt_voronoi_create(t.handle(), static_cast<std::int64_t>(planes.size()),
                                planes.empty() ? nullptr : planes[0].data(), &made);
        if (status != MGDT_OK) detail::throw_failure(status, t.last_error());
        handle_.reset(made);
    }
    /** Takes ownership of a handle of the C interface. */
    explicit Voronoi(mgdt_voronoi* owned) noexcept : handle_(owned) {}

    friend void swap(Voronoi& a, Voronoi& b) noexcept { a.handle_.swap(b.handle_); }

    /** Whether the object owns a handle: true until the handle is moved or released. */
    [[nodiscard]] explicit operator bool() const noexcept { return handle_ != nullptr; }
    /** The handle, for calls of the C interface. The object still owns it. */
    [[nodiscard]] mgdt_voronoi* handle() noexcept { return handle_.get(); }
    [[nodiscard]] const mgdt_voronoi* handle() const noexcept { return handle_.get(); }
    /** Releases ownership of the handle, which the caller frees by mgdt_voronoi_destroy(). */
    [[nodiscard]] mgdt_voronoi* release() noexcept { return handle_.release(); }

    /** Number of elements of an array; mgdt_voronoi_get_size(). @throw Error */
    [[nodiscard]] std::size_t size(VoronoiArray key) const {
        return size_of(static_cast<std::int32_t>(key));
    }
    [[nodiscard]] std::size_t size(VoronoiNumbers key) const {
        return size_of(static_cast<std::int32_t>(key));
    }
    /** An array of integers; mgdt_voronoi_get_array().
     *  @throw Error, std::bad_alloc (the vector's) */
    template <class Int = std::int64_t>
    [[nodiscard]] std::vector<Int> array(VoronoiArray key) const {
        static_assert(detail::is_index_v<Int>, "indices are std::int64_t or std::int32_t");
        std::vector<Int> values(size(key));
        const auto capacity = static_cast<std::int64_t>(values.size());
        if constexpr (sizeof(Int) == sizeof(std::int64_t))
            require(mgdt_voronoi_get_array(handle_.get(), static_cast<std::int32_t>(key), capacity,
                                           values.data()));
        else
            require(mgdt_voronoi_get_array_i32(handle_.get(), static_cast<std::int32_t>(key),
                                               capacity, values.data()));
        return values;
    }
    /** An array of doubles with one number for each face or cell; mgdt_voronoi_get_doubles().
     *  @throw Error, std::bad_alloc (the vector's) */
    [[nodiscard]] std::vector<double> numbers(VoronoiNumbers key) const {
        std::vector<double> values(size(key));
        write(key, values.size(), values.data());
        return values;
    }
    /** An array with three coordinates for each vertex, ray, face or cell.
     *  @throw Error also if the array has one number for each; std::bad_alloc (the vector's) */
    [[nodiscard]] std::vector<Point> points(VoronoiNumbers key) const {
        if (key == VoronoiNumbers::face_areas || key == VoronoiNumbers::cell_volumes ||
            key == VoronoiNumbers::cell_face_areas ||
            key == VoronoiNumbers::cell_neighbor_distances)
            throw Error(MGDT_ERR_INVALID_ARGUMENT, "the array does not have points");
        std::vector<Point> values(size(key) / 3);
        write(key, 3 * values.size(), values.empty() ? nullptr : values[0].data());
        return values;
    }

    /** Leaves out the faces that are smaller than an area, or than a share of the area of each of
     *  their cells; mgdt_voronoi_drop_small_faces(). @throw OutOfMemory, Error */
    void drop_small_faces(double area, double relative = 0) {
        require(mgdt_voronoi_drop_small_faces(handle_.get(), area, relative));
    }
    /** Message of the last call that failed on the handle; mgdt_voronoi_get_error().
     *  @throw std::bad_alloc */
    [[nodiscard]] std::string last_error() const {
        return detail::message_of(mgdt_voronoi_get_error, handle_.get());
    }

  private:
    struct Destroy {
        void operator()(mgdt_voronoi* v) const noexcept { mgdt_voronoi_destroy(v); }
    };

    void require(mgdt_status status) const {
        if (status != MGDT_OK)
            detail::throw_failure(status, handle_ ? last_error() : std::string());
    }
    std::size_t size_of(std::int32_t key) const {
        std::int64_t size = 0;
        require(mgdt_voronoi_get_size(handle_.get(), key, &size));
        return static_cast<std::size_t>(size);
    }
    void write(VoronoiNumbers key, std::size_t capacity, double* values) const {
        require(mgdt_voronoi_get_doubles(handle_.get(), static_cast<std::int32_t>(key),
                                         static_cast<std::int64_t>(capacity), values));
    }

    std::unique_ptr<mgdt_voronoi, Destroy> handle_{};
};

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_VORONOI_HPP */
