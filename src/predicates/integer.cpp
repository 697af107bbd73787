// SPDX-License-Identifier: MIT
#include "predicates/integer.hpp"

namespace mgdt::exact {
namespace {

int bit_length(Limb v) {
#if defined(__GNUC__)
    return 64 - __builtin_clzll(v);
#else
    int n = 0;
    for (; v != 0; v >>= 1) ++n;
    return n;
#endif
}

}  // namespace

namespace {

// The limb that extends a number with this top limb: all ones if the number is negative, otherwise
// 0.
Limb mask_of(Limb top) {
    return Limb{0} - (top >> (limb_bits - 1));
}

}  // namespace

void add(Limb* r, int n, const Limb* b, int m) {
    const int own = m < n ? m : n;
    const Limb beyond = mask_of(b[m - 1]);
    Limb carry = 0;
    for (int i = 0; i < own; ++i) carry = add_with_carry(r[i], b[i], carry);
    for (int i = own; i < n; ++i) carry = add_with_carry(r[i], beyond, carry);
}

void subtract(Limb* r, int n, const Limb* b, int m) {
    const int own = m < n ? m : n;
    const Limb beyond = mask_of(b[m - 1]);
    Limb borrow = 0;
    for (int i = 0; i < own; ++i) borrow = subtract_with_borrow(r[i], b[i], borrow);
    for (int i = own; i < n; ++i) borrow = subtract_with_borrow(r[i], beyond, borrow);
}

void multiply(const Limb* x, int n, const Limb* y, int m, Limb* r, int size) {
    for (int i = 0; i < size; ++i) r[i] = 0;
    for (int i = 0; i < n; ++i) {
        if (x[i] == 0) continue;
        const Limb carry = add_row(r + i, x[i], y, m);
        if (i + m < size) r[i + m] = carry;
    }
    const auto subtract_from = [&](int at, const Limb* b, int length, Limb mask) {
        subtract_masked(r + at, b, length < size - at ? length : size - at, mask);
    };
    subtract_from(n, y, m, mask_of(x[n - 1]));
    subtract_from(m, x, n, mask_of(y[m - 1]));
}

bool take_sign(Limb* a, int n) {
    if (a[n - 1] >> (limb_bits - 1) == 0) return false;
    Limb carry = 1;
    for (int i = 0; i < n; ++i) {
        a[i] = ~a[i];
        carry = add_with_carry(a[i], 0, carry);
    }
    return true;
}

int length_of(const Limb* a, int n) {
    while (n > 0 && a[n - 1] == 0) --n;
    return n == 0 ? 0 : limb_bits * (n - 1) + bit_length(a[n - 1]);
}

Rounded rounded(Limb* a, int n) {
    const bool is_negative = take_sign(a, n);
    const int length = length_of(a, n);
    if (length == 0) return {0, 0};
    n = limb_count(length);
    // The leading 64 bits determine the result, except for whether a later bit is set. So the last
    // of the 64 bits is set if any later bit is; it is far below the bits that a double keeps.
    const int from = length > 64 ? length - 64 : 0;
    const int first = from / limb_bits, offset = from % limb_bits;
    std::uint64_t bits = a[first] >> offset;
    for (int i = first + 1, at = limb_bits - offset; i < n && at < 64; ++i, at += limb_bits)
        bits |= static_cast<std::uint64_t>(a[i]) << at;
    Limb rest = a[first] & ((Limb{1} << offset) - 1);
    for (int i = 0; i < first; ++i) rest |= a[i];
    const auto value = static_cast<double>(bits | (rest != 0));
    return {is_negative ? -value : value, from};
}

}  // namespace mgdt::exact
