// SPDX-License-Identifier: MIT
#include "integer.hpp"

namespace mgdt::exact {

void add(Limb* r, const Limb* b, int n) {
    Limb carry = 0;
    for (int i = 0; i < n; ++i) carry = add_with_carry(r[i], b[i], carry);
}

void subtract(Limb* r, const Limb* b, int n) {
    subtract_masked(r, b, n, ~Limb{0});
}

void multiply(const Limb* x, int n, const Limb* y, int m, Limb* r) {
    for (int i = 0; i < n; ++i) {
        if (x[i] != 0) r[i + m] = add_row(r + i, x[i], y, m);
    }
    const auto mask = [](Limb top) { return Limb{0} - (top >> (limb_bits - 1)); };
    subtract_masked(r + n, y, m, mask(x[n - 1]));
    subtract_masked(r + m, x, n, mask(y[m - 1]));
}

}  // namespace mgdt::exact
