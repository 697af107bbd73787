/* SPDX-License-Identifier: MIT
 * Views of the caller's points, indices and buffers, which are not copied, and structs of results.
 * Part of mgdt/mgdt.hpp, which includes it. */
#ifndef MGDT_CXX_VIEWS_HPP
#define MGDT_CXX_VIEWS_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

#include "error.hpp"

namespace mgdt {
inline namespace cxx1 {

/* ----------------------------------------------------------------------------- views of data ---
 */

/** Whether an object of type T is three doubles, x y z, and nothing else, so that an array of them
 *  is an array of doubles. For your own type:
 *  `template <> struct mgdt::is_point<MyPoint> : std::true_type {};` */
template <class T>
struct is_point : std::false_type {};
template <>
struct is_point<std::array<double, 3>> : std::true_type {};
template <>
struct is_point<double[3]> : std::true_type {};

namespace detail {

// The element type of a contiguous container, without const. Substitution fails for other types.
template <class C>
using element_t = std::remove_cv_t<std::remove_pointer_t<decltype(std::data(std::declval<C&>()))>>;
template <class C>
using size_t_of = decltype(static_cast<std::size_t>(std::size(std::declval<C&>())));

template <class T>
inline constexpr bool is_index_v =
    std::is_same_v<T, std::int64_t> || std::is_same_v<T, std::int32_t>;

// What an element of a buffer may be if K indices belong together: one index, or an std::array of
// K.
template <class T, std::size_t K>
struct group {
    using index = T;
    static constexpr std::size_t width = 1;
};
template <class T, std::size_t K>
struct group<std::array<T, K>, K> {
    using index = T;
    static constexpr std::size_t width = K;
};

}  // namespace detail

/** A view of consecutive elements, which another object owns. */
template <class T>
class Span {
  public:
    constexpr Span() noexcept = default;
    constexpr Span(T* data, std::size_t size) noexcept : data_(data), size_(size) {}
    /** Any contiguous container of T: vector, array, C array, std::span, ... */
    template <class C, class = detail::size_t_of<C>,
              class = std::enable_if_t<
                  !std::is_same_v<std::remove_cv_t<std::remove_reference_t<C>>, Span> &&
                  std::is_convertible_v<decltype(std::data(std::declval<C&>())), T*> &&
                  std::is_same_v<detail::element_t<C>, std::remove_cv_t<T>>>>
    constexpr Span(C&& c) : data_(std::data(c)), size_(static_cast<std::size_t>(std::size(c))) {}

    [[nodiscard]] constexpr T* data() const noexcept { return data_; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] constexpr T* begin() const noexcept { return data_; }
    [[nodiscard]] constexpr T* end() const noexcept { return data_ + size_; }
    [[nodiscard]] constexpr T& operator[](std::size_t k) const noexcept { return data_[k]; }

  private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

namespace detail {

// The first of the indices (or weights) in a container of them or of arrays of them.
template <class T, class C>
T* pointer(C& c) {
    if constexpr (std::is_same_v<element_t<C>, T>)
        return std::data(c);
    else
        return reinterpret_cast<T*>(std::data(c));
}
// A view of the integers in a buffer.
template <std::size_t K, class C>
auto flat(C& c) {
    using Group = group<element_t<C>, K>;
    using Int = typename Group::index;
    static_assert(is_index_v<Int>,
                  "indices are std::int64_t or std::int32_t, or std::arrays of as many of them as "
                  "belong together");
    return Span<Int>(pointer<Int>(c), static_cast<std::size_t>(std::size(c)) * Group::width);
}
// A view of the indices in a container that is only read.
template <class C>
auto row_of(const C& c) {
    using Int = element_t<const C>;
    static_assert(is_index_v<Int>, "indices are std::int64_t or std::int32_t");
    return Span<const Int>(std::data(c), static_cast<std::size_t>(std::size(c)));
}

}  // namespace detail

/** A point. */
using Point = std::array<double, 3>;

/** A view of consecutive points, which another object owns. */
class Points {
  public:
    /** n points at xyz: 3 n doubles. */
    constexpr Points(const double* xyz, std::size_t n) noexcept : xyz_(xyz), count_(n) {}
    /** Any contiguous container of doubles, three per point.
     *  @throw Error MGDT_ERR_INVALID_ARGUMENT if their number is no multiple of three */
    template <class C, class = detail::size_t_of<C>,
              std::enable_if_t<std::is_same_v<detail::element_t<C>, double>, int> = 0>
    Points(const C& c) : xyz_(std::data(c)), count_(static_cast<std::size_t>(std::size(c)) / 3) {
        if (const auto size = static_cast<std::size_t>(std::size(c)); size % 3 != 0)
            throw Error(MGDT_ERR_INVALID_ARGUMENT, "the number of coordinates is " +
                                                       std::to_string(size) +
                                                       ", which is no multiple of 3");
    }
    /** Any contiguous container of points: std::array<double, 3>, double[3], your own type. */
    template <class C, class = detail::size_t_of<C>,
              std::enable_if_t<is_point<detail::element_t<C>>::value, int> = 0>
    Points(const C& c) noexcept
        : xyz_(reinterpret_cast<const double*>(std::data(c))),
          count_(static_cast<std::size_t>(std::size(c))) {
        using T = detail::element_t<C>;
        static_assert(sizeof(T) == 3 * sizeof(double) && std::is_trivially_copyable_v<T> &&
                          std::is_standard_layout_v<T>,
                      "a point is three doubles and nothing else");
    }

    [[nodiscard]] constexpr const double* data() const noexcept { return xyz_; }
    /** Number of points. */
    [[nodiscard]] constexpr std::size_t count() const noexcept { return count_; }

  private:
    const double* xyz_;
    std::size_t count_;
};

/** A compressed list: for each point the tetrahedra around its vertex, see
 *  mgdt_get_vertex_tetrahedra(), or the neighbours of its vertex, see
 *  mgdt_get_vertex_neighbors(). */
template <class Int>
struct PointLists {
    std::vector<Int> offsets{}; /**< One more than there are points, in the index base. */
    std::vector<Int> list{};    /**< Numbers of tetrahedra, or indices of points. */
    /** The list of point k, which is counted from 0 whatever the index base is. */
    [[nodiscard]] Span<const Int> operator[](std::size_t k) const noexcept {
        const Int base = offsets[0];
        return {list.data() + (offsets[k] - base),
                static_cast<std::size_t>(offsets[k + 1] - offsets[k])};
    }
};

/** The result of vertex_tetrahedra(). */
template <class Int>
using VertexTetrahedra = PointLists<Int>;

/** The circumspheres of the tetrahedra; see mgdt_get_circumcenters(). */
struct Circumspheres {
    std::vector<std::array<double, 3>> centers{};
    std::vector<double> squared_radii{};
};

/** The tetrahedra that a segment passes through, and the parameters between them: tetrahedron i is
 *  entered at parameters[i] and left at parameters[i + 1]. See mgdt_traverse_segment(). @since 1.3
 */
template <class Int>
struct Traversal {
    std::vector<Int> tetrahedra{};    /**< Their numbers, in order. */
    std::vector<double> parameters{}; /**< One more than tetrahedra; none if there are none. */
};

/** The result of locate() with weights; see mgdt_locate_points(). */
template <class Int>
struct Located {
    std::vector<Int> tetrahedra{};                /**< A number each, or none (base - 1). */
    std::vector<std::array<double, 4>> weights{}; /**< Barycentric coordinates; zeros for none. */
};

/** The result of interpolation_weights(); see mgdt_get_interpolation_weights(). @since 1.2 */
template <class Int>
struct Weights {
    std::vector<Int> offsets{};    /**< One more than there are places, in the index base. */
    std::vector<Int> points{};     /**< Indices of points. */
    std::vector<double> weights{}; /**< A weight for each. */
};

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_VIEWS_HPP */
