// SPDX-License-Identifier: MIT
// Vectors of doubles or of twofold numbers. A result is computed in doubles first, and again in
// twofold numbers if doubles are not accurate enough.
#pragma once

#include <cmath>

#include "predicates/twofold.hpp"

namespace mgdt {

// An upper bound on the relative error of one operation.
template <class Real>
constexpr double rounding_of = 0x1p-53;
template <>
inline constexpr double rounding_of<Twofold> = 0x1p-102;

template <class Real>
Real to_real(double x);
template <>
inline double to_real<double>(double x) {
    return x;
}
template <>
inline Twofold to_real<Twofold>(double x) {
    return {x, 0};
}
inline double nearest_double(double x) {
    return x;
}
inline double nearest_double(const Twofold& x) {
    return x.high;
}
// Multiplies by a power of two.
inline double scaled_by(double x, double factor) {
    return x * factor;
}
inline Twofold scaled_by(const Twofold& x, double factor) {
    return {x.high * factor, x.low * factor};
}

template <class Real>
struct Vector {
    Real x[3];

    friend Vector operator-(const Vector& a, const Vector& b) {
        return {{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}};
    }
    friend Vector operator+(const Vector& a, const Vector& b) {
        return {{a.x[0] + b.x[0], a.x[1] + b.x[1], a.x[2] + b.x[2]}};
    }
    friend Vector operator*(const Real& s, const Vector& a) {
        return {{s * a.x[0], s * a.x[1], s * a.x[2]}};
    }
};

template <class Real>
Vector<Real> to_vector(const Vector<double>& a) {
    return {{to_real<Real>(a.x[0]), to_real<Real>(a.x[1]), to_real<Real>(a.x[2])}};
}
template <class Real>
Vector<Real> scaled_by(const Vector<Real>& a, double factor) {
    return {{scaled_by(a.x[0], factor), scaled_by(a.x[1], factor), scaled_by(a.x[2], factor)}};
}
template <class Real>
Real dot(const Vector<Real>& a, const Vector<Real>& b) {
    return (a.x[0] * b.x[0] + a.x[1] * b.x[1]) + a.x[2] * b.x[2];
}
template <class Real>
Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
    return {{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2],
             a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}
// The length, with the error of a few roundings.
template <class Real>
double length(const Vector<Real>& a) {
    const double x = nearest_double(a.x[0]), y = nearest_double(a.x[1]), z = nearest_double(a.x[2]);
    return std::sqrt((x * x + y * y) + z * z);
}

// Differences of coordinates and of points: rounded in doubles, exact in twofold numbers.
inline void set_difference(double& d, double a, double b) {
    d = a - b;
}
inline void set_difference(Twofold& d, double a, double b) {
    d = Twofold::sum(a, -b);
}
template <class Real>
Vector<Real> difference(const double* a, const double* b) {
    Vector<Real> d;
    for (int k = 0; k < 3; ++k) set_difference(d.x[k], a[k], b[k]);
    return d;
}

}  // namespace mgdt
