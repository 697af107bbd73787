// SPDX-License-Identifier: MIT
// Where a segment is divided.
#pragma once

#include <cstdint>

#include "platform/memory.hpp"

namespace mgdt {

// For each end of each segment, whether the segment's end is acute: whether two segments meet there
// at an angle of less than 60 degrees.
Buffer<std::uint8_t> find_acute_ends(const Buffer<double>& points,
                                     const Buffer<std::uint32_t>& segments, Allocator& allocator);

// The k, k0 < k < k1, at which to divide the part from a + k0 / parts (b - a) to a + k1 / parts
// (b - a) of the segment ab because of a point inside its diametral sphere. k1 - k0 is at least 2.
// If `avoids_short_parts` is set, no part becomes much shorter than the distance to that point.
std::uint32_t split_place(const double* a, const double* b, bool is_acute_at_a, bool is_acute_at_b,
                          const double* reference, std::uint32_t k0, std::uint32_t k1,
                          std::uint32_t parts, bool avoids_short_parts) noexcept;

}  // namespace mgdt
