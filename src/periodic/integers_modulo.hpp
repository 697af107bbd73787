// SPDX-License-Identifier: MIT
// Integers of any size modulo 2^64, in which sums of products are exact if the result is small.
#pragma once

#include <cmath>
#include <cstdint>

namespace mgdt {

// A double that is an integer, of any size.
inline std::uint64_t modulo_2_64(double integer) {
    int exponent;
    const double fraction = std::frexp(std::fabs(integer), &exponent);
    const auto bits = static_cast<std::uint64_t>(std::scalbn(fraction, 53));
    const int shift = exponent - 53;
    const std::uint64_t size = shift >= 64   ? 0
                               : shift >= 0  ? bits << shift
                               : shift > -64 ? bits >> -shift
                                             : 0;
    return integer < 0 ? 0 - size : size;
}

// The integer below 2^63 in magnitude. It is rounded to a double.
inline double from_modulo_2_64(std::uint64_t integer) {
    const bool is_negative = integer >> 63 != 0;
    const auto size = static_cast<double>(is_negative ? 0 - integer : integer);
    return is_negative ? -size : size;
}

}  // namespace mgdt
