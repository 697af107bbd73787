// SPDX-License-Identifier: MIT
// The byte order of the machine.
#pragma once

#include <cstdint>
#include <cstring>

namespace mgdt::cli {

inline bool host_is_big_endian() {
    const std::uint16_t one = 1;
    unsigned char first;
    std::memcpy(&first, &one, 1);
    return first == 0;
}

}  // namespace mgdt::cli
