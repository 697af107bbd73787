// SPDX-License-Identifier: MIT
// The exception that the library throws inside. The C interface turns it into a status and a
// message (capi/guard.hpp).
#pragma once

#include <cstdarg>
#include <cstdio>

#include "mgdt/mgdt.h"

namespace mgdt {

struct Error {
    static constexpr int message_size = 256;
    mgdt_status status;
    char message[message_size];
};

#if defined(__MINGW32__)
#define MGDT_FORMAT_PRINTF __attribute__((format(gnu_printf, 2, 3)))
#elif defined(__GNUC__)
#define MGDT_FORMAT_PRINTF __attribute__((format(printf, 2, 3)))
#else
#define MGDT_FORMAT_PRINTF
#endif

[[noreturn]] MGDT_FORMAT_PRINTF inline void fail(mgdt_status status, const char* format, ...) {
    Error error;
    error.status = status;
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(error.message, sizeof error.message, format, arguments);
    va_end(arguments);
    throw error;
}

}  // namespace mgdt
