// SPDX-License-Identifier: MIT
// A long number of limited precision, with a bound on its error. See docs/theory.md, "Numbers with
// bounds".
#pragma once

#include "predicates/long_number.hpp"

namespace mgdt {

struct BoundedLong {
    LongNumber value;
    // An upper bound on the error. It has a margin for the rounding of the bound itself.
    WideDouble error;

    WideDouble wide() const { return value.wide(); }
    WideDouble wide_error() const { return error; }

    // The result of an operation; `inherited` is the error that the operands' errors cause.
    static BoundedLong rounded(const LongNumber& value, const WideDouble& inherited) {
        return with_error(value, inherited + rounding_error(value));
    }

    friend BoundedLong operator-(const BoundedLong& a) { return {-a.value, a.error}; }
    friend BoundedLong operator+(const BoundedLong& a, const BoundedLong& b) {
        return rounded(a.value + b.value, a.error + b.error);
    }
    friend BoundedLong operator-(const BoundedLong& a, const BoundedLong& b) {
        return rounded(a.value - b.value, a.error + b.error);
    }
    friend BoundedLong operator*(const BoundedLong& a, const BoundedLong& b) {
        return rounded(a.value * b.value,
                       (size(a.value) * b.error + size(b.value) * a.error) + a.error * b.error);
    }
    friend BoundedLong operator/(const BoundedLong& a, const BoundedLong& b) {
        const WideDouble least = size(b.value) * WideDouble(1 - 0x1p-30) - b.error;
        if (!(WideDouble() < least)) return {a.value, WideDouble(1, std::int64_t{1} << 50)};
        const LongNumber quotient = a.value / b.value;
        // The rounding error of a quotient is at most four times that of a product.
        return with_error(quotient, (a.error + size(quotient) * b.error) / least +
                                        WideDouble(4) * rounding_error(quotient));
    }

  private:
    static WideDouble size(const LongNumber& x) { return magnitude(x.wide()); }
    static WideDouble rounding_error(const LongNumber& x) { return x.rounding() * size(x); }
    static BoundedLong with_error(const LongNumber& value, const WideDouble& error) {
        return {value, error * WideDouble(1 + 0x1p-30)};
    }
};

}  // namespace mgdt
