// SPDX-License-Identifier: MIT
#include "mesh/scale.hpp"

#include <algorithm>

namespace mgdt {
namespace {

// Coordinates need no scaling if the largest is from 2^-40 to 2^40: the squares of such lengths fit
// into floats, which the location tree uses.
constexpr int ordinary = 40;

bool is_ordinary_exponent(int exponent) {
    return exponent <= ordinary && exponent >= -ordinary;
}

}  // namespace

bool is_exact(const ExponentRange& range, int k) {
    return range.highest + k <= 1023 && range.lowest_bit + k >= -1074;
}

bool is_normal(const ExponentRange& range, int k) {
    // The lowest bit of a normal double is 52 binary digits below its highest.
    return is_exact(range, k) && range.highest + k < 150 && range.lowest_bit + 52 + k >= -150;
}

int exponent_above(const double* x, std::size_t n) {
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, std::fabs(x[i]));
    int exponent = 0;
    if (largest > 0) std::frexp(largest, &exponent);
    return exponent;
}

void ExponentRange::add(double x) {
    if (x == 0) return;
    int exponent;
    std::frexp(x, &exponent);
    if (exponent - 1 > highest) highest = exponent - 1;
    // A double has 53 bits at most; subnormals end at 2^-1074.
    const int last = exponent - 53 < -1074 ? -1074 : exponent - 53;
    if (last < lowest_bit) lowest_bit = last;
}

int choose_scale(const ExponentRange& range, int current) {
    if (range.empty()) return current;
    const auto is_ordinary = [&](int k) { return is_ordinary_exponent(range.highest + k); };
    if (is_exact(range, current) && is_ordinary(current)) return current;
    if (is_ordinary(0)) return 0;
    const int k = -range.highest;
    return is_exact(range, k) ? k : 0;
}

int choose_scale_of_most(const ExponentRange& range, int typical) {
    return is_ordinary_exponent(typical) || !is_exact(range, -typical) ? 0 : -typical;
}

// Multiplies by two factors, since 2^k itself may overflow.
double scaled_by_two_factors(double x, int k) {
    const int half = k / 2;
    return std::ldexp(std::ldexp(x, half), k - half);
}

bool unscale(const double (&x)[3], int scale, double (&result)[3]) {
    if (scale == 0) {
        std::copy_n(x, 3, result);
        return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
    }
    bool is_exact = true;
    for (int axis = 0; axis < 3; ++axis) {
        result[axis] = scaled(x[axis], -scale);
        is_exact &= scales_exactly(x[axis], -scale);
    }
    return is_exact;
}

bool scales_exactly(double x, int k) {
    const double y = scaled(x, k);
    return std::isfinite(y) && scaled(y, -k) == x;
}

}  // namespace mgdt
