// SPDX-License-Identifier: MIT
#include "predicates/quotient.hpp"

#include <cmath>

namespace mgdt::exact {
namespace {

// Bit i; 0 if i is negative.
Limb bit(const Limb* a, int i) {
    return i < 0 ? 0 : a[i / limb_bits] >> (i % limb_bits) & 1U;
}

// The bits from bit `first` on. Bits below bit 0 or beyond the last are 0.
Limb bits_from(const Limb* a, int size, int first) {
    const int shift = ((first % limb_bits) + limb_bits) % limb_bits,
              k = (first - shift) / limb_bits;
    const auto limb = [&](int i) { return i < 0 || i >= size ? Limb{0} : a[i]; };
    return shift == 0 ? limb(k) : limb(k) >> shift | limb(k + 1) << (limb_bits - shift);
}

// m 2^exponent, rounded to the nearest double, for 2^54 <= m < 2^55. The last bit of m is set if
// any later bit of the exact value is.
double rounded_once(std::uint64_t m, int exponent) {
    // The exponent two bits below the last bit of a subnormal number. The last bit is set if any
    // bit that is shifted out is.
    constexpr int least = -1076;
    if (exponent < least) {
        const int shift = least - exponent;
        const std::uint64_t out = shift < 64 ? m & ((std::uint64_t{1} << shift) - 1) : m;
        m = (shift < 64 ? m >> shift : 0) | (out != 0);
        exponent = least;
    }
    if (exponent > least || m >= std::uint64_t{1} << 54)
        return std::ldexp(static_cast<double>(m), exponent);
    const std::uint64_t kept = m >> 2, rest = m & 3;
    const bool up = rest == 3 || (rest == 2 && (kept & 1) != 0);
    return std::ldexp(static_cast<double>(kept + up), exponent + 2);
}

}  // namespace

// Divides by long division, until the quotient has two bits more than a double. At the beginning
// the remainder has one bit less than d.
double rounded_quotient(Limb* n, int n_size, Limb* d, int d_size, Limb* rest, int exponent) {
    const bool is_negative = take_sign(n, n_size) != take_sign(d, d_size);
    const int n_length = length_of(n, n_size), d_length = length_of(d, d_size);
    if (n_length == 0) return 0;
    const int size = limb_count(d_length);
    int at = n_length - d_length;
    for (int i = 0; i < size; ++i) rest[i] = bits_from(n, n_size, i * limb_bits + at + 1);
    // Shifts one more bit of n into the remainder. The remainder is below d, so it may become one
    // bit longer than its limbs; that bit is returned.
    const auto shift_in = [&](int at) {
        Limb carry = bit(n, at);
        for (int i = 0; i < size; ++i) {
            const Limb out = rest[i] >> (limb_bits - 1);
            rest[i] = static_cast<Limb>(rest[i] << 1) | carry;
            carry = out;
        }
        return carry;
    };
    std::uint64_t quotient = 0;
    for (; quotient < std::uint64_t{1} << 54; --at) {
        bool fits = shift_in(at) != 0;
        if (!fits) {
            int i = size - 1;
            while (i > 0 && rest[i] == d[i]) --i;
            fits = rest[i] >= d[i];
        }
        if (fits) {
            Limb borrow = 0;
            for (int i = 0; i < size; ++i) borrow = subtract_with_borrow(rest[i], d[i], borrow);
        }
        quotient = quotient << 1 | fits;
    }
    Limb left = 0;
    for (int i = 0; i < size; ++i) left |= rest[i];
    for (int i = at; i >= 0 && left == 0; --i) left |= bit(n, i);
    const double result = rounded_once(quotient | (left != 0), at + 1 + exponent);
    return is_negative ? -result : result;
}

}  // namespace mgdt::exact
