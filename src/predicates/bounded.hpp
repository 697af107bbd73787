// SPDX-License-Identifier: MIT
// A number of limited precision together with a bound of its error: a result is known as well as
// its own bound says, and needs no analysis beforehand.
#pragma once

#include <limits>

#include "long_number.hpp"
#include "vector.hpp"

namespace mgdt {

// The numbers that bound the errors of a Real. They are rounded themselves, which Bounded allows
// for.
template <class Real>
struct BoundsOf;
template <>
struct BoundsOf<Twofold> {
    using Bound = double;
    static Bound magnitude(const Twofold& x) { return std::fabs(x.high); }
    static Bound rounding_error(const Twofold& x) { return rounding_of<Twofold> * magnitude(x); }
    static Bound quotient_error(const Twofold& x) { return rounding_error(x); }
    // Of a product or quotient that is too small for doubles, where all begins near 1.
    static Bound underflow() { return 0x1p-900; }
    static Bound infinite() { return std::numeric_limits<double>::infinity(); }
};
template <>
struct BoundsOf<LongNumber> {
    using Bound = WideDouble;
    static Bound magnitude(const LongNumber& x) {
        const WideDouble w = x.wide();
        return w.mantissa < 0 ? WideDouble() - w : w;
    }
    static Bound rounding_error(const LongNumber& x) { return x.rounding() * magnitude(x); }
    // A quotient has four times the error of a product.
    static Bound quotient_error(const LongNumber& x) { return WideDouble(4) * rounding_error(x); }
    static Bound underflow() { return Bound(); }
    static Bound infinite() { return Bound(1, std::int64_t{1} << 50); }
};

template <class Real>
struct Bounded {
    using Of = BoundsOf<Real>;
    using Bound = typename Of::Bound;
    Real value;
    Bound error;

    Bound magnitude() const { return Of::magnitude(value); }
    // Of an operation that gives `value`, from operands' errors that add up to `inherited`.
    static Bounded rounded(const Real& value, const Bound& inherited) {
        return with_error(value, inherited + Of::rounding_error(value));
    }
    static Bounded with_error(const Real& value, const Bound& error) {
        return {value, error * Bound(1 + 0x1p-30)};
    }

    friend Bounded operator+(const Bounded& a, const Bounded& b) {
        return rounded(a.value + b.value, a.error + b.error);
    }
    friend Bounded operator-(const Bounded& a, const Bounded& b) {
        return rounded(a.value - b.value, a.error + b.error);
    }
    friend Bounded operator*(const Bounded& a, const Bounded& b) {
        return rounded(a.value * b.value, (a.magnitude() * b.error + b.magnitude() * a.error) +
                                              (a.error * b.error + Of::underflow()));
    }
    friend Bounded operator/(const Bounded& a, const Bounded& b) {
        const Bound least = b.magnitude() * Bound(1 - 0x1p-30) - b.error;
        if (!(Bound(0.0) < least)) return {a.value, Of::infinite()};
        const Real quotient = a.value / b.value;
        return with_error(quotient, (a.error + Of::magnitude(quotient) * b.error) / least +
                                        (Of::quotient_error(quotient) + Of::underflow()));
    }
};

}  // namespace mgdt
