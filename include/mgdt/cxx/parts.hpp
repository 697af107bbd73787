/* SPDX-License-Identifier: MIT The class of a triangulation in parts. Part of mgdt/mgdt.hpp, which
 * includes it and explains it. */
#ifndef MGDT_CXX_PARTS_HPP
#define MGDT_CXX_PARTS_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../mgdt_parts.h"
#include "constants.hpp"
#include "error.hpp"
#include "handle.hpp"
#include "views.hpp"

namespace mgdt {
inline namespace cxx1 {

namespace detail {

struct PartsCalls {
    using Handle = mgdt_parts;
    static constexpr auto destroy = mgdt_parts_destroy;
    static constexpr auto set_progress = mgdt_parts_set_progress;
    static constexpr auto cancel = mgdt_parts_cancel;
    static constexpr auto get_error = mgdt_parts_get_error;
};

}  // namespace detail

/** Points in parts and their triangulation; see mgdt_parts.h. It can be moved, not copied. The
 *  default of the argument `part` is the only part of the process. @since 1.2 */
class Parts : public detail::Worker<detail::PartsCalls> {
  public:
    /** Stands for the part of this process; MGDT_PARTS_THIS_PART. */
    static constexpr std::int32_t this_part = MGDT_PARTS_THIS_PART;

    /** Makes parts in this process; mgdt_parts_create(). @throw OutOfMemory, Error */
    explicit Parts(std::int32_t parts) : Parts(parts, nullptr, nullptr, nullptr) {}
    /** Makes parts in this process that take all their memory from `alloc`;
     *  mgdt_parts_create_with_allocator(). Neither function may throw. @throw OutOfMemory, Error */
    Parts(std::int32_t parts, mgdt_alloc_fn alloc, mgdt_free_fn give_back, void* user) {
        make([&](mgdt_parts** out) {
            return mgdt_parts_create_with_allocator(parts, alloc, give_back, user, out);
        });
    }
    /** Makes parts in this process with the memory of a resource, see Triangulation. @throw
     *  OutOfMemory, Error */
    template <class Resource, class = detail::allocate_of<Resource>,
              class = detail::deallocate_of<Resource>>
    Parts(std::int32_t parts, Resource& resource)
        : Parts(parts, &detail::take<Resource>, &detail::give<Resource>, std::addressof(resource)) {
    }
    /** Makes the part of this process. Processes exchange bytes by functions of the caller;
     *  mgdt_parts_create_with_transport(). @throw OutOfMemory, Error */
    explicit Parts(const mgdt_transport& transport) {
        make([&](mgdt_parts** out) { return mgdt_parts_create_with_transport(&transport, out); });
    }
    /** Takes ownership of a handle of the C interface, such as one of mgdt_mpi_create(). For such a
     *  handle the destructor is collective. */
    explicit Parts(mgdt_parts* owned) noexcept : Worker(owned) {}

    friend void swap(Parts& a, Parts& b) noexcept { a.swap_with(b); }

    /** mgdt_parts_clear(). @throw Error */
    void clear() { require(mgdt_parts_clear(get())); }

    /** mgdt_parts_set_option(). @throw Error */
    void set_option(PartsOption option, std::int64_t value) {
        require(mgdt_parts_set_option(get(), static_cast<std::int32_t>(option), value));
    }
    /** mgdt_parts_get_option(). @throw Error */
    [[nodiscard]] std::int64_t option(PartsOption option) const {
        std::int64_t value = 0;
        require(mgdt_parts_get_option(get(), static_cast<std::int32_t>(option), &value));
        return value;
    }

    /** mgdt_parts_insert_points(). @throw OutOfMemory, Error; the next build() of all processes
     *  fails too, so a process that catches the exception may go on to that build() */
    void insert(Points points, std::int32_t part = this_part) {
        require(mgdt_parts_insert_points(get(), part, static_cast<std::int64_t>(points.count()),
                                         points.data(), nullptr));
    }
    /** Inserts points that have ids, one for each. */
    void insert(Points points, Span<const std::int64_t> ids, std::int32_t part = this_part) {
        if (ids.size() != points.count())
            throw Error(MGDT_ERR_INVALID_ARGUMENT, "there are " + std::to_string(points.count()) +
                                                       " points and " + std::to_string(ids.size()) +
                                                       " ids");
        require(mgdt_parts_insert_points(get(), part, static_cast<std::int64_t>(points.count()),
                                         points.data(), ids.data()));
    }

    /** mgdt_parts_build(). Collective. @throw Cancelled, OutOfMemory, Error, and what the progress
     *  callback throws */
    void build() { require(mgdt_parts_build(get())); }
    /** mgdt_parts_build_each().
     *  @param look  called as look(const Parts&, std::int32_t part) for each part in ascending
     *  order. A result that is true cancels. If it throws, build_each() throws that exception
     *  @throw as build() */
    template <class F, class = std::enable_if_t<std::is_invocable_v<std::remove_reference_t<F>&,
                                                                    const Parts&, std::int32_t>>>
    void build_each(F&& look) {
        using Look = std::remove_reference_t<F>;
        struct Call {
            const Parts& parts;
            Look& look;
            detail::Guarded guarded{};
        } call{*this, look};
        const auto relay = [](const mgdt_parts*, std::int32_t part, void* user) noexcept {
            Call& c = *static_cast<Call*>(user);
            return c.guarded.run(
                1, [&] { return detail::asks_to_stop(c.look, c.parts, part) ? 1 : 0; });
        };
        const mgdt_status status = mgdt_parts_build_each(get(), relay, &call);
        call.guarded.rethrow();
        require(status);
    }

    /** mgdt_parts_get_stat(). @throw Error */
    [[nodiscard]] std::int64_t number(PartsNumber key, std::int32_t part = this_part) const {
        std::int64_t value = 0;
        require(mgdt_parts_get_stat(get(), part, static_cast<std::int32_t>(key), &value));
        return value;
    }
    /** mgdt_parts_get_array(). @throw OutOfMemory, Error, std::bad_alloc (the vector's) */
    [[nodiscard]] std::vector<std::int64_t> array(PartsArray key,
                                                  std::int32_t part = this_part) const {
        std::vector<std::int64_t> values(size(key, part));
        write(key, part, values.size(), values.data());
        return values;
    }
    /** An array with four numbers per tetrahedron, such as corners.
     *  @throw as array() */
    [[nodiscard]] std::vector<std::array<std::int64_t, 4>> rows(
        PartsArray key, std::int32_t part = this_part) const {
        std::int32_t columns = 0;
        if (mgdt_parts_array_info(static_cast<std::int32_t>(key), &columns, nullptr) != MGDT_OK ||
            columns != 4)
            throw Error(MGDT_ERR_INVALID_ARGUMENT,
                        "the array does not have four numbers for each tetrahedron");
        std::vector<std::array<std::int64_t, 4>> values(size(key, part) / 4);
        write(key, part, 4 * values.size(), values.empty() ? nullptr : values[0].data());
        return values;
    }
    /** The coordinates of the part's vertices; mgdt_parts_get_coordinates(). @throw Error,
     *  std::bad_alloc (the vector's) */
    [[nodiscard]] std::vector<Point> coordinates(std::int32_t part = this_part) const {
        std::vector<Point> xyz(static_cast<std::size_t>(number(PartsNumber::vertices, part)));
        require(mgdt_parts_get_coordinates(get(), part, static_cast<std::int64_t>(3 * xyz.size()),
                                           xyz.empty() ? nullptr : xyz[0].data()));
        return xyz;
    }

    /** Checks that the triangulation is valid; mgdt_parts_check(). Collective.
     *  @throw OutOfMemory, Error; the one for MGDT_ERR_CHECK_FAILED says what is wrong and where */
    void check(Check level = Check::canonical) {
        require(mgdt_parts_check(get(), static_cast<std::int32_t>(level)));
    }

  private:
    std::size_t size(PartsArray key, std::int32_t part) const {
        std::int64_t size = 0;
        require(mgdt_parts_get_size(get(), part, static_cast<std::int32_t>(key), &size));
        return static_cast<std::size_t>(size);
    }
    void write(PartsArray key, std::int32_t part, std::size_t capacity,
               std::int64_t* values) const {
        require(mgdt_parts_get_array(get(), part, static_cast<std::int32_t>(key),
                                     static_cast<std::int64_t>(capacity), values));
    }
};

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_PARTS_HPP */
