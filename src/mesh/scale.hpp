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

// x times 2^k for any k that a scale can be. Two factors, since 2^k itself may overflow.
double scaled(double x, int k);

// Whether scaling the coordinate forth and back gives it again.
bool scales_exactly(double x, int k);

}  // namespace mgdt
