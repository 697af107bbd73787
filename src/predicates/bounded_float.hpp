// SPDX-License-Identifier: MIT
// A double or twofold number with a bound on its error and a separate exponent, whose range is so
// large that no product overflows. The bound of a result holds whatever the magnitudes of the
// operands. See docs/theory.md, "Numbers with bounds".
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "platform/compiler.hpp"
#include "predicates/vector.hpp"
#include "predicates/wide_double.hpp"

namespace mgdt {

// The number (value +- error) 2^(256 block). The larger of |value| and error is in [2^-128, 2^128);
// in an exact 0, all three are 0. If nothing is known, the error is infinite or NaN.
template <class Real>
struct BoundedFloat {
    Real value;
    double error;
    std::int64_t block;

    // x 2^exponent, exactly.
    static BoundedFloat number(double x, std::int64_t exponent = 0) {
        return exact({x, 0}, exponent);
    }
    static BoundedFloat with_error(const WideDouble& x, const WideDouble& error) {
        if (!(error.mantissa <= 1)) return unknown();
        const BoundedFloat value = number(x.mantissa, x.exponent),
                           bound = number(error.mantissa, error.exponent);
        return value + BoundedFloat{to_real<Real>(0), nearest_double(bound.value), bound.block};
    }
    // a - b.
    static BoundedFloat difference(double a, double b) {
        const Twofold d = Twofold::sum(a, -b);
        return std::fabs(d.high) <= std::numeric_limits<double>::max() ? exact(d, 0)
                                                                       : number(a) - number(b);
    }

    // The sign +1, 0 or -1 if the bound determines it, otherwise 2.
    int sign() const {
        const double x = nearest_double(value);
        return x > error ? 1 : -x > error ? -1 : error == 0 ? 0 : 2;
    }
    WideDouble wide() const { return WideDouble(nearest_double(value), 256 * block); }
    WideDouble wide_error() const { return WideDouble(error, 256 * block); }

    friend BoundedFloat operator-(const BoundedFloat& a) {
        return {scaled_by(a.value, -1), a.error, a.block};
    }
    friend BoundedFloat operator+(const BoundedFloat& a, const BoundedFloat& b) {
        if (a.block != b.block) return sum_of_unequal(a, b);
        return rounded(a.value + b.value, a.error + b.error, a.block);
    }
    friend BoundedFloat operator-(const BoundedFloat& a, const BoundedFloat& b) { return a + -b; }
    friend BoundedFloat operator*(const BoundedFloat& a, const BoundedFloat& b) {
        return rounded(a.value * b.value,
                       (magnitude(a) * b.error + magnitude(b) * a.error) + a.error * b.error,
                       a.block + b.block);
    }
    friend BoundedFloat operator/(const BoundedFloat& a, const BoundedFloat& b) {
        const double least = magnitude(b) * (1 - 0x1p-40) - b.error;
        if (!(least > 0)) return unknown();
        const Real quotient = a.value / b.value;
        return rounded(quotient, (a.error + std::fabs(nearest_double(quotient)) * b.error) / least,
                       a.block - b.block);
    }

  private:
    static constexpr double least = 0x1p-128, most = 0x1p128, one_block = 0x1p256;

    static double magnitude(const BoundedFloat& a) { return std::fabs(nearest_double(a.value)); }
    // A number of which nothing is known. Its block exceeds all others, so every sum that contains
    // the number is unknown, too.
    static BoundedFloat unknown() {
        return {to_real<Real>(0), std::numeric_limits<double>::infinity(), std::int64_t{1} << 40};
    }
    // The result of an operation; `inherited` is the error that the operands' errors cause.
    static BoundedFloat rounded(const Real& value, double inherited, std::int64_t block) {
        const double size = std::fabs(nearest_double(value));
        const double error = (inherited + rounding_of<Real> * size) * (1 + 0x1p-40);
        const double larger = error > size ? error : size;
        if (larger >= least && larger < most) return {value, error, block};
        return normalized(value, error, block);
    }
    MGDT_NOT_INLINE static BoundedFloat normalized(Real value, double error, std::int64_t block) {
        if (nearest_double(value) == 0 && error == 0) return {to_real<Real>(0), 0, 0};
        if (!(error <= std::numeric_limits<double>::max())) return unknown();
        const auto larger = [&] { return std::max(std::fabs(nearest_double(value)), error); };
        // No operation gives a magnitude of 2^384 or more, so one division is enough.
        if (larger() >= most) {
            value = scaled_by(value, 1 / one_block);
            error *= 1 / one_block;
            ++block;
        }
        while (larger() < least) {
            value = scaled_by(value, one_block);
            error *= one_block;
            --block;
        }
        return {value, error, block};
    }
    MGDT_NOT_INLINE static BoundedFloat sum_of_unequal(const BoundedFloat& a,
                                                       const BoundedFloat& b) {
        if (a.is_zero()) return b;
        if (b.is_zero()) return a;
        if (a.block < b.block) return sum_of_unequal(b, a);
        // If the blocks differ by 1, underflow in the scaling of b loses less than 2^-900. If they
        // differ by more, b is less than 2^-380 in the unit of a and is left out.
        if (a.block - b.block == 1)
            return rounded(a.value + scaled_by(b.value, 1 / one_block),
                           a.error + b.error * (1 / one_block) + 0x1p-900, a.block);
        return rounded(a.value, a.error + 0x1p-380, a.block);
    }
    bool is_zero() const { return error == 0 && nearest_double(value) == 0; }

    static BoundedFloat exact(const Twofold& x, std::int64_t exponent) {
        if (x.high == 0) return {to_real<Real>(0), 0, 0};
        int of_x;
        std::frexp(x.high, &of_x);
        // The shift divides by 256 and rounds down, so the magnitude is in [2^-128, 2^128).
        const std::int64_t block = (of_x + exponent + 127) >> 8;
        const auto shift = static_cast<int>(exponent - 256 * block);
        BoundedFloat r = {to_real<Real>(0), 0, block};
        r.set(std::ldexp(x.high, shift), std::ldexp(x.low, shift));
        if (x.low != 0) r.error += 0x1p-900;  // the low part may underflow
        return r;
    }
    void set(double high, double low);
};

template <class Real>
Vector<BoundedFloat<Real>> bounded_difference(const double* a, const double* b) {
    Vector<BoundedFloat<Real>> d;
    for (int k = 0; k < 3; ++k) d.x[k] = BoundedFloat<Real>::difference(a[k], b[k]);
    return d;
}

inline BoundedFloat<double> narrowed(const BoundedFloat<Twofold>& x) {
    return {x.value.high, x.error + std::fabs(x.value.low) * (1 + 0x1p-40), x.block};
}

// Rounds x 2^exponent to the nearest double, which may be 0 or infinite. Returns false if the error
// bound does not determine the result, and for results at the limits of the range of doubles,
// subnormal numbers included.
bool round_to_nearest(const BoundedFloat<Twofold>& x, std::int64_t exponent, double& r);

template <>
inline void BoundedFloat<double>::set(double high, double low) {
    value = high;
    error = std::fabs(low);
}
template <>
inline void BoundedFloat<Twofold>::set(double high, double low) {
    value = {high, low};
}

}  // namespace mgdt
