// SPDX-License-Identifier: MIT
// A number of limited precision together with a bound of its error: a result is known as well as
// its own bound says, and needs no analysis beforehand.
#pragma once

#include "long_float.hpp"
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
    static Bound rounding() { return rounding_of<Twofold>; }
    // Of a product or quotient that is too small for doubles, where all begins near 1.
    static Bound underflow() { return 0x1p-900; }
    static Bound infinite() { return std::numeric_limits<double>::infinity(); }
};
template <int Bits>
struct BoundsOf<LongFloat<Bits>> {
    using Bound = LongFloat<64>;
    static Bound magnitude(const LongFloat<Bits>& x) {
        Bound r;
        r.exponent = x.exponent;
        for (int i = 0; i < Bound::size; ++i)
            r.limb[i] = x.limb[LongFloat<Bits>::size - Bound::size + i];
        return r;
    }
    static Bound rounding() {
        Bound r(8.0);
        r.exponent -= Bits;
        return r;
    }
    static Bound underflow() { return Bound(); }
    static Bound infinite() {
        Bound r(1.0);
        r.exponent = std::int64_t{1} << 50;
        return r;
    }
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
        const Bound slack(1 + 0x1p-30);
        return {value, (inherited + Of::rounding() * Of::magnitude(value)) * slack};
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
        return rounded(quotient,
                       (a.error + Of::magnitude(quotient) * b.error) / least + Of::underflow());
    }
};

}  // namespace mgdt
