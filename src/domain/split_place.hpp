// SPDX-License-Identifier: MIT
// Where a segment is divided.
#pragma once

#include <cstdint>

#include "platform/memory.hpp"

namespace mgdt {

// For each end of each segment: whether another segment meets it there at an angle of less than 60
// degrees.
Buffer<std::uint8_t> find_acute_ends(const Buffer<double>& points,
                                     const Buffer<std::uint32_t>& segments, Allocator& allocator);

// Chooses where to divide a part of the segment ab: the part from a + k0 / parts (b - a) to a + k1
// / parts (b - a), which has the point `reference` inside of its diametral sphere. Returns k with
// k0 < k < k1; k1 - k0 is at least 2. If `avoids_short_parts` is set, no part becomes much shorter
// than the distance to the reference point.
std::uint32_t split_place(const double* a, const double* b, bool is_acute_at_a, bool is_acute_at_b,
                          const double* reference, std::uint32_t k0, std::uint32_t k1,
                          std::uint32_t parts, bool avoids_short_parts) noexcept;

}  // namespace mgdt
