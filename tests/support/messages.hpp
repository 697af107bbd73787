// SPDX-License-Identifier: MIT
// The message of the last call that failed on a handle.
#pragma once

#include <string>

#include "mgdt/mgdt.h"

namespace mgdt_tests {

template <class Handle>
std::string message_of(const Handle* handle,
                       mgdt_status (*get)(const Handle*, int64_t capacity, char* buffer)) {
    char text[256] = "";
    get(handle, sizeof text, text);
    return text;
}
inline std::string error_of(const mgdt_triangulation* t) {
    return message_of(t, mgdt_get_error);
}

}  // namespace mgdt_tests
