// SPDX-License-Identifier: MIT
// A number as the sum of two doubles, with about 100 bits.
#pragma once

#include "predicates/integer.hpp"

namespace mgdt {

struct Twofold {
    double high, low;

    // Exact sums and products of doubles. The product is by the method of Dekker, A floating-point
    // technique for extending the available precision, Numerische Mathematik 18 (1971).
    static MGDT_PREDICATES_INLINE Twofold sum(double a, double b) {
        const double s = a + b, part = s - a;
        return {s, (a - (s - part)) + (b - part)};
    }
    static MGDT_PREDICATES_INLINE Twofold product(double a, double b) {
        const auto upper = [](double x) {
            const double c = 134217729.0 * x;  // 2^27 + 1
            return c - (c - x);
        };
        const double p = a * b, ah = upper(a), bh = upper(b), al = a - ah, bl = b - bh;
        return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
    }
    friend Twofold operator+(Twofold a, Twofold b) {
        const Twofold high = sum(a.high, b.high), low = sum(a.low, b.low);
        const Twofold s = sum(high.high, high.low + low.high);
        return sum(s.high, s.low + low.low);
    }
    friend Twofold operator-(Twofold a, Twofold b) { return a + Twofold{-b.high, -b.low}; }
    friend Twofold operator*(Twofold a, Twofold b) {
        const Twofold p = product(a.high, b.high);
        return sum(p.high, p.low + (a.high * b.low + a.low * b.high));
    }
    // The quotient of the upper parts, corrected twice by the quotient of the remainder.
    friend Twofold operator/(Twofold a, Twofold b) {
        const double first = a.high / b.high;
        const Twofold rest = a - b * Twofold{first, 0};
        const double second = rest.high / b.high;
        const Twofold last = rest - b * Twofold{second, 0};
        const Twofold q = sum(first, second);
        return sum(q.high, q.low + last.high / b.high);
    }
};

// Rounds x to the nearest double. Returns false if an error of `error` in x could change the
// result.
MGDT_PREDICATES_INLINE bool round_if_certain(const Twofold& x, double error, double& rounded) {
    rounded = x.high + (x.low + error);
    return rounded == x.high + (x.low - error);
}

}  // namespace mgdt
