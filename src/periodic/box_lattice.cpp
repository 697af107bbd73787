// SPDX-License-Identifier: MIT
#include "periodic/box_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "periodic/integers_modulo.hpp"
#include "platform/error.hpp"
#include "predicates/predicates.hpp"
#include "predicates/twofold.hpp"

namespace mgdt {
namespace {

double dot(const double* a, const double* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length_of(const double* a) {
    return std::sqrt(dot(a, a));
}

// The cross product. Pairs of doubles are used because vectors of an obtuse basis may be nearly
// parallel.
void cross(const double* a, const double* b, Twofold (&to)[3]) {
    for (unsigned c = 0; c < 3; ++c) {
        const unsigned d = (c + 1) % 3, e = (c + 2) % 3;
        to[c] = Twofold::product(a[d], b[e]) - Twofold::product(a[e], b[d]);
    }
}

// The largest allowed coefficient when the basis is expressed in the caller's vectors. With this
// limit, sums of products with numbers up to 2^30 fit 64 bits.
constexpr double most_multiples = 0x1p31;

[[noreturn]] void fail_to_span(unsigned dimensions) {
    fail(MGDT_ERR_INVALID_ARGUMENT, dimensions == 1 ? "the vector of the box has no length"
                                    : dimensions == 2
                                        ? "the two vectors of the box are on a line"
                                        : "the three vectors of the box are in a plane");
}

}  // namespace

BoxLattice::BoxLattice(unsigned dimensions, const double* vectors) : dimensions_(dimensions) {
    double largest = 0;
    for (unsigned i = 0; i < 3 * dimensions; ++i)
        largest = std::max(largest, std::fabs(vectors[i]));
    if (largest == 0) fail_to_span(dimensions);
    exponent_ = std::ilogb(largest);
    factors_[0] = std::scalbn(1.0, -(exponent_ / 2));
    factors_[1] = std::scalbn(1.0, -(exponent_ - exponent_ / 2));
    for (unsigned k = 0; k < dimensions; ++k) {
        transform_[k][k] = 1;
        for (unsigned c = 0; c < 3; ++c)
            basis_[k][c] = given_[k][c] = std::scalbn(vectors[3 * k + c], -exponent_);
    }
    reduce();
    complete();
    set_dual();
}

BoxLattice BoxLattice::rounded_to(const double (&units)[3]) const {
    BoxLattice rounded = *this;
    rounded.is_exact_ = true;
    // A vector that is many times longer than the basis is already a multiple of the unit. In
    // integers modulo 2^64 each step of the combination is exact. The result is exact too, because
    // it is hardly larger than a vector of the basis: below 2^50 units.
    for (unsigned c = 0; c < 3; ++c) {
        if (units[c] == 0) continue;
        std::uint64_t given[3] = {};
        for (unsigned k = 0; k < dimensions_; ++k) {
            const double of = std::nearbyint(given_[k][c] / units[c]);
            rounded.given_[k][c] = of * units[c];
            given[k] = modulo_2_64(of);
        }
        for (unsigned k = 0; k < dimensions_; ++k) {
            std::uint64_t sum = 0;
            for (unsigned j = 0; j < dimensions_; ++j)
                sum += static_cast<std::uint64_t>(transform_[k][j]) * given[j];
            rounded.basis_[k][c] = from_modulo_2_64(sum) * units[c];
        }
    }
    rounded.reduce();
    rounded.complete();
    rounded.set_dual();
    for (unsigned k = 0; k < dimensions_; ++k)
        if (!(rounded.slope_[k] * 2 * rounded.covering_radius_ <= largest_ratio))
            fail(MGDT_ERR_INVALID_ARGUMENT,
                 "the box is flat, or nearly: across one of its faces it measures %g of its size",
                 1 / (rounded.slope_[k] * 2 * rounded.covering_radius_));
    return rounded;
}

// Computes the coordinates of a combination, with an error of about one rounding.
void BoxLattice::set(Combination& v) const {
    for (unsigned c = 0; c < 3; ++c) {
        Twofold sum = {0, 0};
        for (unsigned i = 0; i < dimensions_; ++i)
            sum = sum + Twofold::product(static_cast<double>(v.of[i]), given_[i][c]);
        v.x[c] = sum.high + sum.low;
    }
}

void BoxLattice::add(Combination& v, const Combination& w, double factor) const {
    for (unsigned i = 0; i < dimensions_; ++i) {
        const double sum = static_cast<double>(v.of[i]) + factor * static_cast<double>(w.of[i]);
        if (!(std::fabs(sum) < most_multiples))
            fail(MGDT_ERR_INVALID_ARGUMENT, "the box is too oblique");
        v.of[i] = static_cast<std::int64_t>(sum);
    }
    if (!is_exact_) return set(v);
    for (unsigned c = 0; c < 3; ++c) v.x[c] += factor * w.x[c];
}

// Lengths of vectors that are not exact are compared with a tolerance, so that each reduction ends.
bool BoxLattice::is_shorter(const Combination& v, const Combination& w) const {
    if (is_exact_) return compare_lengths(v.x, lattice_origin, w.x, lattice_origin) < 0;
    return dot(v.x, v.x) < dot(w.x, w.x) * (1 - 1e-12);
}

bool BoxLattice::is_acute(const Combination& v, const Combination& w) const {
    if (!is_exact_) return dot(v.x, w.x) > 1e-12 * length_of(v.x) * length_of(w.x);
    const double opposite[3] = {-w.x[0], -w.x[1], -w.x[2]};
    return compare_lengths(v.x, opposite, v.x, w.x) > 0;
}

// Makes the basis obtuse.
void BoxLattice::reduce() {
    const unsigned n = dimensions_;
    Combination v[4] = {};
    for (unsigned i = 0; i < n; ++i) {
        std::copy_n(transform_[i], 3, v[i].of);
        std::copy_n(basis_[i], 3, v[i].x);
    }
    // Lagrange's reduction of pairs of vectors: subtracts from each vector the multiple of another
    // one that makes it shortest. Very oblique boxes need few steps.
    for (bool has_changed = true; has_changed;) {
        has_changed = false;
        for (unsigned i = 0; i < n; ++i)
            for (unsigned j = 0; j < n; ++j) {
                if (i == j) continue;
                const double square = dot(v[j].x, v[j].x);
                if (square == 0) fail_to_span(n);
                const double factor = std::nearbyint(dot(v[i].x, v[j].x) / square);
                if (factor == 0) continue;
                Combination shorter = v[i];
                add(shorter, v[j], -factor);
                if (!is_shorter(shorter, v[i])) continue;
                v[i] = shorter;
                has_changed = true;
            }
    }
    // Selling's algorithm for an obtuse superbase. Each step decreases the sum of the squares of
    // the lengths.
    for (unsigned i = 0; i < n; ++i) add(v[n], v[i], -1);
    const auto step = [&] {
        for (unsigned i = 0; i <= n; ++i)
            for (unsigned j = 0; j <= n; ++j) {
                if (i == j || !is_acute(v[i], v[j])) continue;
                const Combination w = v[i];
                for (unsigned k = 0; k <= n; ++k)
                    if (k != i && k != j) add(v[k], w, n == 2 ? 2 : 1);
                add(v[i], w, -2);
                return true;
            }
        return false;
    };
    if (n > 1)
        while (step()) {
        }
    // The basis is the superbase without its longest vector.
    const auto is_before = [&](const Combination& a, const Combination& b) {
        const int c = compare_lengths(a.x, lattice_origin, b.x, lattice_origin);
        return c != 0 ? c < 0 : std::lexicographical_compare(b.of, b.of + 3, a.of, a.of + 3);
    };
    for (unsigned i = 1; n > 1 && i <= n; ++i)
        for (unsigned j = i; j > 0 && is_before(v[j], v[j - 1]); --j) std::swap(v[j], v[j - 1]);
    covering_radius_ = 0;
    for (unsigned k = 0; k < n; ++k) {
        std::copy_n(v[k].of, 3, transform_[k]);
        std::copy_n(v[k].x, 3, basis_[k]);
        covering_radius_ += length_of(basis_[k]) / 2 * (1 + 0x1p-40);
    }
}

// Completes the basis by vectors that are orthogonal to it, within rounding, and about as long as
// its longest vector.
void BoxLattice::complete() {
    const double size = length_of(basis_[dimensions_ - 1]);
    if (size == 0) fail_to_span(dimensions_);
    const auto set_normal = [&](const double* a, const double* b, double(&to)[3]) {
        // Unit vectors are used, so that the squares of lengths are in the range of doubles.
        double unit[2][3];
        for (unsigned c = 0; c < 3; ++c) {
            unit[0][c] = a[c] / length_of(a);
            unit[1][c] = b[c] / length_of(b);
        }
        Twofold normal[3];
        cross(unit[0], unit[1], normal);
        for (unsigned c = 0; c < 3; ++c) to[c] = normal[c].high;
        const double length = length_of(to);
        if (!(length > 0)) fail_to_span(dimensions_);
        for (double& x : to) x *= size / length;
    };
    if (dimensions_ == 1) {
        unsigned least = 0;
        for (unsigned c = 1; c < 3; ++c)
            if (std::fabs(basis_[0][c]) < std::fabs(basis_[0][least])) least = c;
        double axis[3] = {};
        axis[least] = 1;
        set_normal(basis_[0], axis, basis_[1]);
    }
    if (dimensions_ < 3) set_normal(basis_[0], basis_[1], basis_[2]);
}

void BoxLattice::set_dual() {
    for (unsigned k = 0; k < 3; ++k) {
        Twofold normal[3], volume = {0, 0};
        cross(basis_[(k + 1) % 3], basis_[(k + 2) % 3], normal);
        for (unsigned c = 0; c < 3; ++c) volume = volume + normal[c] * Twofold{basis_[k][c], 0};
        if (volume.high == 0) fail_to_span(dimensions_);
        for (unsigned c = 0; c < 3; ++c) {
            const Twofold quotient = normal[c] / volume;
            dual_[k][c] = quotient.high + quotient.low;
        }
        slope_[k] = length_of(dual_[k]) * (1 + 0x1p-40);
        if (!std::isfinite(slope_[k])) fail_to_span(dimensions_);
    }
}

std::array<std::int64_t, 3> BoxLattice::multiples_of_callers(const Multiples& of_basis) const {
    // In a slab or a wire, the rows and columns of missing vectors are 0.
    std::array<std::int64_t, 3> of_callers;
    for (unsigned j = 0; j < 3; ++j)
        of_callers[j] = of_basis[0] * transform_[0][j] + of_basis[1] * transform_[1][j] +
                        of_basis[2] * transform_[2][j];
    return of_callers;
}

std::array<std::int64_t, 3> BoxLattice::multiples_of_basis(
    const std::array<std::int64_t, 3>& of_callers) const {
    // The determinant of the transformation is 1 or -1. So the inverse is the determinant times the
    // adjugate, also in integers modulo 2^64.
    std::uint64_t t[3][3] = {};
    for (unsigned k = 0; k < 3; ++k)
        for (unsigned j = 0; j < 3; ++j)
            t[k][j] = k < dimensions_ ? static_cast<std::uint64_t>(transform_[k][j]) : k == j;
    const auto cofactor = [&](unsigned k, unsigned j) {
        const unsigned k1 = (k + 1) % 3, k2 = (k + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        return t[k1][j1] * t[k2][j2] - t[k1][j2] * t[k2][j1];
    };
    std::uint64_t determinant = 0;
    for (unsigned j = 0; j < 3; ++j) determinant += t[0][j] * cofactor(0, j);
    std::array<std::int64_t, 3> of_basis;
    for (unsigned k = 0; k < 3; ++k) {
        std::uint64_t sum = 0;
        for (unsigned j = 0; j < 3; ++j)
            sum += cofactor(k, j) * static_cast<std::uint64_t>(of_callers[j]);
        of_basis[k] = static_cast<std::int64_t>(determinant * sum);
    }
    return of_basis;
}

}  // namespace mgdt
