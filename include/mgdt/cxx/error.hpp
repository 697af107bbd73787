/* SPDX-License-Identifier: MIT
 * The exceptions. Part of mgdt/mgdt.hpp, which includes it. */
#ifndef MGDT_CXX_ERROR_HPP
#define MGDT_CXX_ERROR_HPP

#include <new>
#include <stdexcept>
#include <string>

#include "../mgdt.h"

namespace mgdt {
inline namespace cxx1 {

/** A failed call, unless memory ran out (see OutOfMemory). what() is the library's message. */
class Error : public std::runtime_error {
  public:
    Error(mgdt_status status, const std::string& message)
        : std::runtime_error(message), status_(status) {}
    /** An MGDT_ERR_ value. */
    [[nodiscard]] mgdt_status status() const noexcept { return status_; }

  private:
    mgdt_status status_;
};

/** cancel() or the progress callback stopped a call. */
class Cancelled : public Error {
  public:
    using Error::Error;
};

/** Another call is running on the object: the failed call came from a callback of the object, or
 *  from a second thread against the thread rule. Nothing has changed. @since 1.2 */
class Busy : public Error {
  public:
    using Error::Error;
};

/** The allocator or the memory limit refused memory. A std::bad_alloc, not an Error. */
class OutOfMemory : public std::bad_alloc {
  public:
    [[nodiscard]] const char* what() const noexcept override {
        return "mgdt: out of memory: the allocator or the memory limit refused";
    }
    [[nodiscard]] mgdt_status status() const noexcept { return MGDT_ERR_OUT_OF_MEMORY; }
};

/** One line that describes a status. */
[[nodiscard]] inline const char* status_string(mgdt_status status) noexcept {
    return mgdt_status_string(status);
}

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_ERROR_HPP */
