// SPDX-License-Identifier: MIT
// The power of two by which the library multiplies coordinates, so that atoms in metres and
// galaxies in millimetres are in the range of the floating-point filters. The multiplication is
// exact, so no decision depends on it.
#pragma once

#include <cmath>
#include <cstddef>

namespace mgdt {

// The exponents, as std::ilogb gives them, of the largest coordinate and of the lowest bit of the
// significand of any nonzero coordinate.
struct ExponentRange {
    int highest = -2000;
    int lowest_bit = 2000;

    bool empty() const { return highest == -2000; }
    void add(double x);
    void add(const ExponentRange& other) {
        if (other.highest > highest) highest = other.highest;
        if (other.lowest_bit < lowest_bit) lowest_bit = other.lowest_bit;
    }
};

// An exponent k such that 2^k times every coordinate of the range is exact. The result is `current`
// if the scaled coordinates then have ordinary size, since a change of the scale takes a pass over
// the mesh. It is 0 if the coordinates have ordinary size without scaling, or if no k is exact.
// Otherwise the largest product is near 1.
int choose_scale(const ExponentRange& range, int current);

// The exponent for coordinates that no factor brings into the range where filters are proved.
// `typical`, the exponent of most coordinates, decides, so that few remain outside. 0 if `typical`
// is ordinary, or if scaling is not exact.
int choose_scale_of_most(const ExponentRange& range, int typical);

// Whether 2^k times every coordinate is exact and within 2^-150 to 2^150, where the filters of
// kernel/circumsphere.hpp are proved.
bool is_normal(const ExponentRange& range, int k);
// Whether 2^k times every coordinate is exact.
bool is_exact(const ExponentRange& range, int k);

// The least e such that all of n numbers are below 2^e; 0 if all are 0.
int exponent_above(const double* x, std::size_t n);

// x times 2^k, for every k that choose_scale() can return.
double scaled_by_two_factors(double x, int k);
inline double scaled(double x, int k) {
    return k == 0 ? x : scaled_by_two_factors(x, k);
}

// Multiplies three coordinates by 2^-scale. Returns whether all results are exact.
bool unscale(const double (&x)[3], int scale, double (&result)[3]);

// Whether multiplying x by 2^k and then by 2^-k gives x.
bool scales_exactly(double x, int k);

}  // namespace mgdt
