// SPDX-License-Identifier: MIT
#include "voronoi/ray.hpp"

#include "predicates/bounded_numbers.hpp"

namespace mgdt {
namespace {

// Computes the cross product of two edges. Returns false if the error is too large.
template <class Numbers>
bool normal_in(Numbers numbers, const double* a, const double* b, const double* c,
               double (&normal)[3]) {
    Vector<typename Numbers::B> p, q;
    for (int k = 0; k < 3; ++k) {
        p.x[k] = numbers.difference(b[k], a[k]);
        q.x[k] = numbers.difference(c[k], a[k]);
    }
    const auto n = cross(p, q);
    WideDouble largest;
    for (const auto& of : n.x)
        if (largest < magnitude(of.wide())) largest = magnitude(of.wide());
    Vector<double> x;
    for (int k = 0; k < 3; ++k) {
        if (!(n.x[k].wide_error() < largest * WideDouble(0x1p-53))) return false;
        x.x[k] = (n.x[k].wide() / largest).in_double();
    }
    const double size = length(x);
    for (int k = 0; k < 3; ++k) normal[k] = x.x[k] / size;
    return true;
}

}  // namespace

void unit_normal(Allocator& allocator, const double* a, const double* b, const double* c,
                 double (&normal)[3]) {
    if (normal_in(BoundedFloats<Twofold>(), a, b, c, normal)) return;
    std::size_t limbs = 256 / exact::limb_bits;
    while (!normal_in(BoundedLongs(allocator, limbs), a, b, c, normal)) limbs *= 2;
}

}  // namespace mgdt
