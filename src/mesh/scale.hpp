// SPDX-License-Identifier: MIT
// The power of two by which coordinates are multiplied inside, so that atoms in metres
// and galaxies in millimetres meet the same floating-point filters at full speed. Multiplying by it
// is exact, so no decision depends on it.
#pragma once

#include <cmath>

namespace mgdt {

// Exponents (as std::ilogb gives them) of the largest coordinate and of the last bit of the
// coordinates that are not zero.
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

// Exponent k such that 2^k times every coordinate of the range is exact and the largest is near
// 1; 0 where the coordinates are of ordinary size already or no such k exists. `current` is kept
// where it will do, since changing it costs a pass over the mesh.
int choose_scale(const ExponentRange& range, int current);

// The same where no factor brings all coordinates into the range in which filters are proved:
// `typical`, the exponent of most of them, decides, so that few are left outside.
int choose_scale_of_most(const ExponentRange& range, int typical);

// Whether 2^k times every coordinate is exact and within 2^-150 to 2^150, where the filters of
// kernel/circumsphere.hpp are proved.
bool is_normal(const ExponentRange& range, int k);
// Whether 2^k times every coordinate is exact.
bool is_exact(const ExponentRange& range, int k);

// x times 2^k for any k that a scale can be.
double scaled_by_two_factors(double x, int k);
inline double scaled(double x, int k) {
    return k == 0 ? x : scaled_by_two_factors(x, k);
}

// Whether scaling the coordinate forth and back gives it again.
bool scales_exactly(double x, int k);

}  // namespace mgdt
