// SPDX-License-Identifier: MIT
// Parses numbers, with correct rounding and independently of the locale.
#pragma once

#include <cstdint>
#include <string_view>

namespace mgdt::cli {

enum class NumberStatus { ok, not_a_number, too_large, not_finite };

// Parses a decimal number: 1, -.5, +1e-3, or as Fortran writes it: 1.0D+05, 1.0-100.
NumberStatus parse_number(std::string_view text, double& value);

// Whether there is a number, including nan and inf.
inline bool is_value(NumberStatus status) {
    return status == NumberStatus::ok || status == NumberStatus::not_finite;
}

// Whether a number is a marker: an integer of 32 bits.
inline bool is_marker(double value) {
    return value >= -0x1p31 && value < 0x1p31 && value == static_cast<std::int32_t>(value);
}

// Parses a decimal integer in the range of int64.
bool parse_integer(std::string_view text, std::int64_t& value);

// The reason for messages: "'abc' is not a number".
const char* describe(NumberStatus status);

}  // namespace mgdt::cli
