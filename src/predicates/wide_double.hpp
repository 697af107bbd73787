// SPDX-License-Identifier: MIT
// A double with a separate exponent, whose range is so large that no product overflows. It is for
// error bounds and for results of long numbers.
#pragma once

#include <cmath>
#include <cstdint>

namespace mgdt {

// mantissa 2^exponent, where the magnitude of the mantissa is 0 or in [1/2, 1].
struct WideDouble {
    double mantissa = 0;
    std::int64_t exponent = 0;

    WideDouble() = default;
    explicit WideDouble(double x, std::int64_t times_power = 0) {
        int e = 0;
        mantissa = std::frexp(x, &e);
        exponent = x == 0 ? 0 : times_power + e;
    }

    // The number as a double; 0 or infinite if it is outside the range of doubles.
    double in_double() const {
        constexpr std::int64_t most = 4000;
        return std::ldexp(mantissa, static_cast<int>(exponent < -most  ? -most
                                                     : exponent > most ? most
                                                                       : exponent));
    }

    friend WideDouble operator+(const WideDouble& a, const WideDouble& b) {
        if (a.mantissa == 0) return b;
        if (b.mantissa == 0) return a;
        if (a.exponent < b.exponent) return b + a;
        const std::int64_t distance = a.exponent - b.exponent;
        const double low = distance < 200 ? std::ldexp(b.mantissa, -static_cast<int>(distance)) : 0;
        return WideDouble(a.mantissa + low, a.exponent);
    }
    friend WideDouble operator-(const WideDouble& a, const WideDouble& b) {
        WideDouble minus_b = b;
        minus_b.mantissa = -b.mantissa;
        return a + minus_b;
    }
    friend WideDouble operator*(const WideDouble& a, const WideDouble& b) {
        return WideDouble(a.mantissa * b.mantissa, a.exponent + b.exponent);
    }
    friend WideDouble operator/(const WideDouble& a, const WideDouble& b) {
        return WideDouble(a.mantissa / b.mantissa, a.exponent - b.exponent);
    }
    friend WideDouble magnitude(const WideDouble& a) {
        return a.mantissa < 0 ? WideDouble() - a : a;
    }
    friend bool operator<(const WideDouble& a, const WideDouble& b) { return (a - b).mantissa < 0; }
};

// x / sqrt(y) for positive y, with the error of a few roundings.
inline WideDouble over_root(const WideDouble& x, const WideDouble& y) {
    const bool is_odd = y.exponent % 2 != 0;
    const double root = std::sqrt(is_odd ? 2 * y.mantissa : y.mantissa);
    return WideDouble(x.mantissa / root, x.exponent - (y.exponent - is_odd) / 2);
}

}  // namespace mgdt
