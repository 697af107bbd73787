// SPDX-License-Identifier: MIT
#include "periodic/image_grid.hpp"

#include <algorithm>
#include <cmath>

#include "periodic/integers_modulo.hpp"
#include "platform/error.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// The integer nearest to q. If two are equally near, the greater one, so that the result is
// monotone in q.
double nearest_integer(double q) {
    if (!(std::fabs(q) < 0x1p52)) return q;
    const auto towards_zero = static_cast<double>(static_cast<std::int64_t>(q));
    // There are no branches, because half of them would be mispredicted.
    const double below = towards_zero - static_cast<double>(towards_zero > q);
    return below + static_cast<double>(q - below >= 0.5);
}

}  // namespace

bool PointReach::add(const double* x) {
    if (lattice_.dimensions() == 3) return true;  // the size of the box is enough
    double place[3], s[3], square = 0;
    for (unsigned c = 0; c < 3; ++c) place[c] = lattice_.from_callers(x[c]);
    lattice_.coordinates(place, s);
    for (unsigned c = 0; c < 3; ++c) {
        double rest = place[c], size = 0;
        for (unsigned k = 0; k < lattice_.dimensions(); ++k) {
            rest -= s[k] * lattice_.vector(k)[c];
            size += std::fabs(lattice_.vector(k)[c]);
        }
        // Large coordinates cancel, so the rest may be larger because of rounding.
        largest_[c] = std::max(largest_[c], std::fabs(rest) + size);
        square += rest * rest;
    }
    const double height = std::sqrt(square);
    for (unsigned k = 0; k < lattice_.dimensions(); ++k)
        if (!(height * lattice_.slope(k) <= BoxLattice::largest_ratio)) return false;
    height_ = std::max(height_, height);
    return true;
}

void ImageGrid::set_units(const PointReach& reach) {
    for (unsigned c = 0; c < 3; ++c) {
        double size = 0;
        for (unsigned k = 0; k < lattice_.dimensions(); ++k)
            size += std::fabs(lattice_.vector(k)[c]);
        if (size == 0) continue;
        size = std::max(size, reach.largest(c));
        // With M < 2^e for the largest size, images up to 15 M are below 2^53 units.
        unit_[c] = std::scalbn(1.0, std::max(std::ilogb(size) + 1 - 48, -900));
        per_unit_[c] = 1 / unit_[c];
        // The rounded coordinates in the caller's unit have to be doubles, too.
        const int exponent = std::ilogb(size) + lattice_.exponent();
        if (exponent < -1020 || exponent > 1000)
            fail(MGDT_ERR_INVALID_ARGUMENT,
                 "the box is too small or too large: its vectors reach over 2^%d along axis %u",
                 exponent, c + 1);
    }
}

ImageGrid::ImageGrid(const BoxLattice& lattice, const PointReach& reach) : lattice_(lattice) {
    set_units(reach);
    lattice_ = lattice.rounded_to(unit_);
    for (unsigned k = 0; k < lattice.dimensions(); ++k)
        std::copy_n(lattice_.vector(k), 3, basis_[k]);
    size_ = 10 * lattice_.covering_radius() + reach.height();
    for (unsigned k = 0; k < lattice.dimensions(); ++k) margin_[k] = lattice_.error_of(k, size_);
    handedness_ =
        orientation(lattice_origin, lattice_.vector(0), lattice_.vector(1), lattice_.vector(2));
    if (handedness_ == 0)
        fail(MGDT_ERR_INVALID_ARGUMENT, "the box is flat: its rounded vectors do not span");
}

// Whether x is on the outer side of one of the two faces of the box that vector k connects. The
// near face belongs to the box, and the far one does not.
bool ImageGrid::is_below(unsigned k, const double* x, bool from_the_far_side) const {
    double y[3] = {x[0], x[1], x[2]};
    if (from_the_far_side)
        for (unsigned c = 0; c < 3; ++c) y[c] -= lattice_.vector(k)[c];
    const double* v[3] = {lattice_.vector(0), lattice_.vector(1), lattice_.vector(2)};
    v[k] = y;
    return orientation(lattice_origin, v[0], v[1], v[2]) * handedness_ < 0;
}

// Subtracts k times the basis from a point on the grid. In integers modulo 2^64 all steps are
// exact, and so is the result if it is below 2^53 units.
void ImageGrid::reduce(const double* x, const Multiples& k, double* to) const {
    for (unsigned c = 0; c < 3; ++c) {
        to[c] = x[c];
        if (unit_[c] == 0) continue;
        std::uint64_t sum = modulo_2_64(x[c] * per_unit_[c]);
        for (unsigned j = 0; j < lattice_.dimensions(); ++j)
            sum -= static_cast<std::uint64_t>(static_cast<std::int64_t>(k[j])) *
                   modulo_2_64(basis_[j][c] * per_unit_[c]);
        to[c] = from_modulo_2_64(sum) * unit_[c];
    }
}

void ImageGrid::round(const double* x, double* rounded) const {
    for (unsigned c = 0; c < 3; ++c) {
        const double place = lattice_.from_callers(x[c]);
        rounded[c] = unit_[c] > 0 ? nearest_integer(place * per_unit_[c]) * unit_[c] : place;
    }
}

bool ImageGrid::wrap(const double* x, double* wrapped, Multiples& taken) const {
    double rounded[3], s[3];
    round(x, rounded);
    lattice_.coordinates(rounded, s);
    taken = {};
    bool is_inside = true;
    for (unsigned k = 0; k < lattice_.dimensions(); ++k)
        is_inside = is_inside && s[k] > margin_[k] && s[k] < 1 - margin_[k];
    if (is_inside) {
        std::copy_n(rounded, 3, wrapped);
        return true;
    }
    for (unsigned k = 0; k < lattice_.dimensions(); ++k) {
        if (!(std::fabs(s[k]) <= farthest)) return false;
        taken[k] = static_cast<std::int32_t>(std::floor(s[k]));
    }
    reduce(rounded, taken, wrapped);
    // The first coordinates of a distant point are rough, so the reduction is repeated.
    for (int round = 0; round < 4; ++round) {
        lattice_.coordinates(wrapped, s);
        bool is_done = true;
        for (unsigned k = 0; k < lattice_.dimensions(); ++k) {
            const double more = std::floor(s[k]);
            if (!(std::fabs(taken[k] + more) <= farthest)) return false;
            taken[k] += static_cast<std::int32_t>(more);
            is_done = is_done && more == 0;
        }
        if (is_done) break;
        reduce(rounded, taken, wrapped);
    }
    // At a face of the box, rounding may have put the point into the adjacent box.
    for (unsigned k = 0; k < lattice_.dimensions(); ++k) {
        while (is_below(k, wrapped, false)) {
            --taken[k];
            reduce(rounded, taken, wrapped);
        }
        while (!is_below(k, wrapped, true)) {
            ++taken[k];
            reduce(rounded, taken, wrapped);
        }
    }
    return true;
}

}  // namespace mgdt
