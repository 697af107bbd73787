// SPDX-License-Identifier: MIT
// Floating-point numbers of many digits, with exponents that no product leaves: for what has to be
// measured where doubles and twofold numbers do not do.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "integer.hpp"

namespace mgdt {

// +-0.d * 2^exponent, where d are the Bits of the limbs, of which the first is 1; or 0, all of
// whose bits are. The relative error of one operation is below 2^(3 - Bits). Nothing but a quotient
// by 0, which is 0, is wrong.
template <int Bits>
struct LongFloat {
    static constexpr int size = Bits / exact::limb_bits;
    static_assert(size * exact::limb_bits == Bits);

    LongFloat() = default;
    explicit LongFloat(double x) : is_negative(std::signbit(x)) {
        if (x == 0) return;
        int e;
        // 64 bits, the first of them 1.
        auto bits = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::fabs(x), &e), 64));
        exponent = e;
        for (int i = size - 1; i >= 0 && bits != 0; --i) {
            limb[i] = static_cast<exact::Limb>(bits >> (64 - exact::limb_bits));
            bits = exact::limb_bits < 64 ? bits << (exact::limb_bits & 63) : 0;
        }
    }

    bool is_zero() const { return limb[size - 1] == 0; }
    // Cut off to 53 bits; 0 or infinite where no double is as small or as large.
    double in_double() const {
        if (is_zero()) return 0;
        double d = 0;
        for (int i = size - 1, shift = 0; i >= 0 && shift < 64; --i) {
            shift += exact::limb_bits;
            d += std::ldexp(static_cast<double>(limb[i] >> (shift > 53 ? shift - 53 : 0)),
                            shift > 53 ? -53 : -shift);
            if (shift >= 53) break;
        }
        const std::int64_t most = 4000;
        const auto e = static_cast<int>(exponent < -most  ? -most
                                        : exponent > most ? most
                                                          : exponent);
        return std::ldexp(is_negative ? -d : d, e);
    }

    friend LongFloat operator-(const LongFloat& a) {
        LongFloat r = a;
        r.is_negative = !a.is_negative;
        return r;
    }
    friend LongFloat operator+(const LongFloat& a, const LongFloat& b) {
        if (a.is_zero()) return b;
        if (b.is_zero()) return a;
        return a.is_less_than(b) ? sum(b, a) : sum(a, b);
    }
    friend LongFloat operator-(const LongFloat& a, const LongFloat& b) { return a + -b; }
    MGDT_PREDICATES_APART friend LongFloat operator*(const LongFloat& a, const LongFloat& b) {
        LongFloat r;
        if (a.is_zero() || b.is_zero()) return r;
        exact::Limb product[2 * size] = {};
        for (int i = 0; i < size; ++i)
            product[i + size] = exact::add_row(product + i, a.limb[i], b.limb, size);
        r.is_negative = a.is_negative != b.is_negative;
        r.exponent = a.exponent + b.exponent;
        const bool is_short = product[2 * size - 1] >> (exact::limb_bits - 1) == 0;
        for (int i = 0; i < size; ++i)
            r.limb[i] =
                is_short ? static_cast<exact::Limb>(product[i + size] << 1 |
                                                    product[i + size - 1] >> (exact::limb_bits - 1))
                         : product[i + size];
        r.exponent -= is_short;
        return r;
    }
    friend LongFloat operator/(const LongFloat& a, const LongFloat& b) { return a * inverse(b); }
    friend bool operator<(const LongFloat& a, const LongFloat& b) {
        const LongFloat d = a - b;
        return d.is_negative && !d.is_zero();
    }

    bool is_negative = false;
    std::int64_t exponent = 0;
    exact::Limb limb[size] = {};  // the least first

  private:
    // In magnitude; none is 0.
    bool is_less_than(const LongFloat& b) const {
        if (exponent != b.exponent) return exponent < b.exponent;
        for (int i = size - 1; i >= 0; --i)
            if (limb[i] != b.limb[i]) return limb[i] < b.limb[i];
        return false;
    }
    // Of a, and b of no larger magnitude.
    MGDT_PREDICATES_APART static LongFloat sum(const LongFloat& a, const LongFloat& b) {
        const std::int64_t distance = a.exponent - b.exponent;
        if (distance > Bits) return a;
        // A limb more than there are, below.
        exact::Limb r[size + 2] = {}, shifted[size + 2] = {};
        for (int i = 0; i < size; ++i) r[i + 1] = a.limb[i];
        const int limbs = static_cast<int>(distance) / exact::limb_bits,
                  bits = static_cast<int>(distance) % exact::limb_bits;
        const auto limb_of_b = [&](int i) {
            return i >= 0 && i < size ? b.limb[i] : exact::Limb{0};
        };
        for (int i = 0; i <= size; ++i) {
            const exact::Limb low = limb_of_b(i - 1 + limbs), high = limb_of_b(i + limbs);
            shifted[i] =
                bits == 0
                    ? low
                    : static_cast<exact::Limb>(low >> bits | high << (exact::limb_bits - bits));
        }
        exact::Limb carry = 0;
        for (int i = 0; i < size + 2; ++i)
            carry = a.is_negative == b.is_negative
                        ? exact::add_with_carry(r[i], shifted[i], carry)
                        : exact::subtract_with_borrow(r[i], shifted[i], carry);
        const int length = exact::length_of(r, size + 2);
        LongFloat result;
        if (length == 0) return result;
        result.is_negative = a.is_negative;
        result.exponent = a.exponent + length - Bits - exact::limb_bits;
        // The Bits from the leading one on.
        const int first = length - Bits, skip = first > 0 ? first / exact::limb_bits : 0;
        for (int i = 0; i < size; ++i) {
            if (first >= 0) {
                const int down = first % exact::limb_bits;
                const exact::Limb low = r[i + skip],
                                  high = i + skip + 1 < size + 2 ? r[i + skip + 1] : 0;
                result.limb[i] =
                    down == 0
                        ? low
                        : static_cast<exact::Limb>(low >> down | high << (exact::limb_bits - down));
            } else {
                const int up = -first % exact::limb_bits, from = i - -first / exact::limb_bits;
                const exact::Limb high = from >= 0 ? r[from] : 0, low = from >= 1 ? r[from - 1] : 0;
                result.limb[i] =
                    up == 0 ? high
                            : static_cast<exact::Limb>(high << up | low >> (exact::limb_bits - up));
            }
        }
        return result;
    }
    // By Newton's method, each step of which doubles the number of digits.
    static LongFloat inverse(const LongFloat& b) {
        LongFloat unit = b;
        if (b.is_zero()) return b;
        unit.exponent = 0;
        LongFloat x(1 / unit.in_double());
        const LongFloat two(2.0);
        for (int digits = 48; digits < Bits; digits *= 2) x = x * (two - unit * x);
        x.exponent -= b.exponent;
        return x;
    }
};

}  // namespace mgdt
