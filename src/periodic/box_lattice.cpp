// SPDX-License-Identifier: MIT
#include "periodic/box_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "platform/error.hpp"

namespace mgdt {
namespace {

double dot(const double* a, const double* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void cross(const double* a, const double* b, double* to) {
    for (unsigned c = 0; c < 3; ++c) {
        const unsigned d = (c + 1) % 3, e = (c + 2) % 3;
        to[c] = a[d] * b[e] - a[e] * b[d];
    }
}

// The multiples of the caller's vectors are not larger, so that sums of products with 2^30 fit.
constexpr double most_multiples = 0x1p31;

[[noreturn]] void fail_to_span(unsigned dimensions) {
    fail(MGDT_ERR_INVALID_ARGUMENT, dimensions == 1 ? "the vector of the box has no length"
                                    : dimensions == 2
                                        ? "the two vectors of the box are on a line"
                                        : "the three vectors of the box are in a plane");
}

}  // namespace

BoxLattice::BoxLattice(unsigned dimensions, const double* vectors) : dimensions_(dimensions) {
    // A common factor keeps all products in the range of doubles.
    double largest = 0;
    for (unsigned i = 0; i < 3 * dimensions; ++i)
        largest = std::max(largest, std::fabs(vectors[i]));
    if (largest == 0) fail_to_span(dimensions);
    const int exponent = std::ilogb(largest);
    for (unsigned i = 0; i < 3 * dimensions; ++i)
        given_[i / 3][i % 3] = std::scalbn(vectors[i], -exponent);
    reduce();
    complete();
    set_dual();
    for (unsigned k = 0; k < 3; ++k) {
        for (unsigned c = 0; c < 3; ++c) {
            basis_[k][c] = std::scalbn(basis_[k][c], exponent);
            dual_[k][c] = std::scalbn(dual_[k][c], -exponent);
        }
        slope_[k] = std::scalbn(slope_[k], -exponent);
    }
    covering_radius_ = std::scalbn(covering_radius_, exponent);
}

// Computes the coordinates of a combination, nearly as well as doubles can.
void BoxLattice::set(Combination& v) const {
    for (unsigned c = 0; c < 3; ++c) {
        double sum = 0, error = 0;
        for (unsigned i = 0; i < dimensions_; ++i) {
            const auto factor = static_cast<double>(v.of[i]);
            const double product = factor * given_[i][c], next = sum + product, part = next - sum;
            error += std::fma(factor, given_[i][c], -product) +
                     ((sum - (next - part)) + (product - part));
            sum = next;
        }
        v.x[c] = sum + error;
    }
}

void BoxLattice::add(Combination& v, const Combination& w, double factor) const {
    for (unsigned i = 0; i < dimensions_; ++i) {
        const double sum = static_cast<double>(v.of[i]) + factor * static_cast<double>(w.of[i]);
        if (!(std::fabs(sum) < most_multiples))
            fail(MGDT_ERR_INVALID_ARGUMENT, "the box is too oblique");
        v.of[i] = static_cast<std::int64_t>(sum);
    }
    set(v);
}

void BoxLattice::reduce() {
    const unsigned n = dimensions_;
    Combination v[4] = {};
    for (unsigned i = 0; i < n; ++i) {
        v[i].of[i] = 1;
        set(v[i]);
    }
    const auto length2 = [&](unsigned i) { return dot(v[i].x, v[i].x); };
    // As Lagrange does it for two vectors: takes from each vector what makes it shorter. This
    // brings oblique boxes near to the end soon.
    for (bool is_shorter = true; is_shorter;) {
        is_shorter = false;
        for (unsigned i = 0; i < n; ++i)
            for (unsigned j = 0; j < n; ++j) {
                if (i == j) continue;
                if (length2(j) == 0) fail_to_span(n);
                const double factor = std::nearbyint(dot(v[i].x, v[j].x) / length2(j));
                if (factor == 0) continue;
                Combination shorter = v[i];
                add(shorter, v[j], -factor);
                if (!(dot(shorter.x, shorter.x) < length2(i) * (1 - 1e-12))) continue;
                v[i] = shorter;
                is_shorter = true;
            }
    }
    // Selling's steps to an obtuse superbase: the sum of the squares of its lengths decreases.
    for (unsigned i = 0; i < n; ++i) add(v[n], v[i], -1);
    const auto step = [&] {
        for (unsigned i = 0; i <= n; ++i)
            for (unsigned j = 0; j <= n; ++j) {
                const double product = dot(v[i].x, v[j].x);
                if (i == j || !(product > 1e-12 * std::sqrt(length2(i)) * std::sqrt(length2(j))))
                    continue;
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
    // The longest vector of the superbase goes.
    const auto shorter = [&](const Combination& a, const Combination& b) {
        const double x = dot(a.x, a.x), y = dot(b.x, b.x);
        return x != y ? x < y : std::lexicographical_compare(b.of, b.of + 3, a.of, a.of + 3);
    };
    if (n > 1) std::sort(v, v + n + 1, shorter);
    for (unsigned k = 0; k < n; ++k) {
        std::copy_n(v[k].of, 3, transform_[k]);
        std::copy_n(v[k].x, 3, basis_[k]);
        covering_radius_ += std::sqrt(length2(k)) / 2;
    }
}

// Completes the basis by vectors that are orthogonal to it and of about the length of the longest.
void BoxLattice::complete() {
    const double size = std::sqrt(dot(basis_[dimensions_ - 1], basis_[dimensions_ - 1]));
    if (size == 0) fail_to_span(dimensions_);
    if (dimensions_ == 1) {
        unsigned least = 0;
        for (unsigned c = 1; c < 3; ++c)
            if (std::fabs(basis_[0][c]) < std::fabs(basis_[0][least])) least = c;
        double axis[3] = {};
        axis[least] = 1;
        cross(basis_[0], axis, basis_[1]);
    }
    if (dimensions_ < 3) {
        double unit[2][3];
        for (unsigned k = 0; k < 2; ++k) {
            const double length = std::sqrt(dot(basis_[k], basis_[k]));
            for (unsigned c = 0; c < 3; ++c) unit[k][c] = basis_[k][c] / length;
        }
        cross(unit[0], unit[1], basis_[2]);
        for (unsigned k = dimensions_; k < 3; ++k) {
            const double length = std::sqrt(dot(basis_[k], basis_[k]));
            if (!(length > 0)) fail_to_span(dimensions_);
            for (unsigned c = 0; c < 3; ++c) basis_[k][c] *= size / length;
        }
    }
}

void BoxLattice::set_dual() {
    double volume = 0;
    for (unsigned k = 0; k < 3; ++k) cross(basis_[(k + 1) % 3], basis_[(k + 2) % 3], dual_[k]);
    volume = dot(basis_[0], dual_[0]);
    if (volume == 0) fail_to_span(dimensions_);
    for (unsigned k = 0; k < 3; ++k) {
        for (unsigned c = 0; c < 3; ++c) dual_[k][c] /= volume;
        slope_[k] = std::sqrt(dot(dual_[k], dual_[k]));
        if (!std::isfinite(slope_[k])) fail_to_span(dimensions_);
    }
}

void BoxLattice::coordinates(const double* x, double (&s)[3]) const {
    for (unsigned k = 0; k < 3; ++k) s[k] = dot(dual_[k], x);
}

std::array<std::int64_t, 3> BoxLattice::to_callers(const Multiples& of_basis) const {
    std::array<std::int64_t, 3> of_callers = {};
    for (unsigned k = 0; k < dimensions_; ++k)
        for (unsigned j = 0; j < dimensions_; ++j) of_callers[j] += of_basis[k] * transform_[k][j];
    return of_callers;
}

}  // namespace mgdt
