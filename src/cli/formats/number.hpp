// SPDX-License-Identifier: MIT
// Numbers in text: correctly rounded, and the same in every locale.
#pragma once

#include <cstdint>
#include <string_view>

namespace mgdt::cli {

enum class NumberStatus { ok, not_a_number, too_large, not_finite };

// Decimal floating-point: 1, -.5, +1e-3; and as Fortran writes it: 1.0D+05, 1.0-100.
NumberStatus parse_number(std::string_view text, double& value);

// Whether there is a number, which may be nan or inf.
inline bool is_value(NumberStatus status) {
    return status == NumberStatus::ok || status == NumberStatus::not_finite;
}

// Decimal integer in the range of int64.
bool parse_integer(std::string_view text, std::int64_t& value);

// What is wrong, for messages: "'abc' is not a number".
const char* describe(NumberStatus status);

}  // namespace mgdt::cli
