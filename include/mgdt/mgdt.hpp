/* SPDX-License-Identifier: MIT
 *
 * mgdt for C++17 and later: header-only classes over the C interface of mgdt.h, mgdt_parts.h,
 * mgdt_voronoi.h, mgdt_domain.h, mgdt_mesh.h and mgdt_periodic.h.
 *
 * mgdt::Triangulation (cxx/triangulation.hpp), mgdt::Parts (cxx/parts.hpp), mgdt::Voronoi
 * (cxx/voronoi.hpp), mgdt::Domain (cxx/domain.hpp), mgdt::Mesh (cxx/mesh.hpp) and mgdt::Periodic
 * (cxx/periodic.hpp) own a handle. Each function names the C function that it calls; the C headers
 * describe meaning, shapes, index base, "none" and threads.
 *
 * - A failed call throws. mgdt::Error has the status and the library's message; mgdt::Cancelled and
 *   mgdt::Busy are the errors for MGDT_ERR_CANCELLED and MGDT_ERR_BUSY; mgdt::OutOfMemory is a
 *   std::bad_alloc. The state of the object is then as mgdt.h describes.
 * - Points are read without a copy from any contiguous container of doubles (three per point), of
 *   std::array<double, 3>, of double[3], or of your own type (see mgdt::is_point).
 * - Results are std::vectors of 64-bit or 32-bit integers, or are written to the caller's buffer.
 * - Const member functions may run on one object from many threads at once. While another member
 *   function runs, no other may be called, except cancel(). A callback may call cancel() and
 *   nothing else; it must not destroy, move from or assign to the object.
 * - An object that was moved from is empty: counts are 0, the dimension is -1, and functions that
 *   can throw throw an Error with MGDT_ERR_NULL_POINTER. It may be destroyed and assigned to.
 *
 * Everything here is inline and calls nothing but C functions, so it adds nothing to the binary
 * interface: a program that includes it runs with every library of ABI version 1.
 *
 * @since 1.0
 */
#ifndef MGDT_MGDT_HPP
#define MGDT_MGDT_HPP

#if !(__cplusplus >= 201703L || (defined(_MSVC_LANG) && _MSVC_LANG >= 201703L))
#error "mgdt.hpp needs C++17 or later; mgdt.h does not"
#endif

#include <cstdint>
#include <string>
#include <vector>

#include "cxx/constants.hpp"
#include "cxx/domain.hpp"
#include "cxx/error.hpp"
#include "cxx/mesh.hpp"
#include "cxx/parts.hpp"
#include "cxx/periodic.hpp"
#include "cxx/triangulation.hpp"
#include "cxx/views.hpp"
#include "cxx/voronoi.hpp"
#include "mgdt.h"

namespace mgdt {
// The inner name keeps these classes apart from the library's own when it is linked statically.
inline namespace cxx1 {

/** Finds the order scheme with a name. @throw Error MGDT_ERR_UNKNOWN_SCHEME,
 *  MGDT_ERR_NULL_POINTER */
[[nodiscard]] inline Order order_from_name(const char* text) {
    std::int32_t scheme = 0;
    const mgdt_status status = mgdt_order_scheme_from_name(text, &scheme);
    if (status != MGDT_OK)
        throw Error(status, std::string(mgdt_status_string(status)) +
                                (text ? ": " + std::string(text) : std::string()));
    return static_cast<Order>(scheme);
}
/** All order schemes that the library has, the default first. Schemes of a later version than this
 *  header have no name in Order. @since 1.2 */
[[nodiscard]] inline std::vector<Order> order_schemes() {
    std::vector<Order> all;
    std::int32_t scheme = 0;
    for (std::int32_t i = 0; mgdt_order_scheme_at(i, &scheme) == MGDT_OK; ++i)
        all.push_back(static_cast<Order>(scheme));
    return all;
}
[[nodiscard]] inline Order order_from_name(const std::string& text) {
    return order_from_name(text.c_str());
}
/** Version of the library that is running, "1.0.0". */
[[nodiscard]] inline const char* version() noexcept {
    return mgdt_version_string();
}
/** Version of the binary interface: 1. */
[[nodiscard]] inline std::int32_t abi_version() noexcept {
    return mgdt_abi_version();
}

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_MGDT_HPP */
