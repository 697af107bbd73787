// SPDX-License-Identifier: MIT
// The lattice of a periodic box, and a basis of it that consists of short vectors.
#pragma once

#include <array>
#include <cstdint>

namespace mgdt {

// A sum of multiples of the vectors of a basis: how many times each vector is taken.
using Multiples = std::array<std::int32_t, 3>;

inline Multiples operator+(const Multiples& a, const Multiples& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Multiples operator-(const Multiples& a, const Multiples& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Multiples operator-(const Multiples& a) {
    return {-a[0], -a[1], -a[2]};
}

inline constexpr double lattice_origin[3] = {};

// The basis is part of an obtuse superbase: no two of its vectors, and of these and minus their
// sum, make an acute angle (Conway and Sloane, Low-dimensional lattices VI, 1992). So the cell of a
// lattice point is bounded by planes towards sums of subsets of the basis and their opposites, and
// no other lattice points.
//
// Vectors and places are those of the caller times 2^-exponent(), which brings the largest
// coordinate of the caller's vectors near to 1.
class BoxLattice {
  public:
    // One to three vectors of three finite coordinates each. Throws MGDT_ERR_INVALID_ARGUMENT if
    // they do not span. The angles of the basis are obtuse within rounding.
    BoxLattice(unsigned dimensions, const double* vectors);
    // The lattice of the caller's vectors after rounding to multiples of a unit, a power of two,
    // for each axis. The unit is at least 2^-48 of the largest coordinate of the basis; axes whose
    // unit is 0 have none. Its own basis is exact and exactly obtuse. Throws
    // MGDT_ERR_INVALID_ARGUMENT if what is left does not span, or hardly.
    BoxLattice rounded_to(const double (&units)[3]) const;

    unsigned dimensions() const { return dimensions_; }
    int exponent() const { return exponent_; }
    double from_callers(double x) const { return x * factors_[0] * factors_[1]; }
    double to_callers(double x) const { return x / factors_[0] / factors_[1]; }
    // A vector of the basis, shortest first, and from dimensions() on an orthogonal complement.
    const double* vector(unsigned k) const { return basis_[k]; }
    // The coordinates of a place with respect to the three vectors. Their errors are at most
    // error_of().
    void coordinates(const double* x, double (&s)[3]) const {
        for (unsigned k = 0; k < 3; ++k)
            s[k] = dual_[k][0] * x[0] + dual_[k][1] * x[1] + dual_[k][2] * x[2];
    }
    double error_of(unsigned k, double distance_from_origin) const {
        return coordinate_error * slope_[k] * distance_from_origin;
    }
    // The largest change of coordinate k over a distance of 1.
    double slope(unsigned k) const { return slope_[k]; }
    // An upper bound of the distance of any place in the span from the nearest lattice point.
    double covering_radius() const { return covering_radius_; }
    // Converts multiples of the basis to multiples of the caller's vectors. Multiples of the basis
    // may be slightly larger than 2^30.
    std::array<std::int64_t, 3> multiples_of_callers(const Multiples& of_basis) const;
    // Converts multiples of the caller's vectors to multiples of the basis, modulo 2^64.
    std::array<std::int64_t, 3> multiples_of_basis(
        const std::array<std::int64_t, 3>& of_callers) const;

    // The caller's vector k. In a lattice that rounded_to() has made, the vector is rounded.
    const double* callers_vector(unsigned k) const { return given_[k]; }

    // An upper bound of the ratio between the extent of the points and the thickness of the box.
    // Beyond it, coordinates are too rough to find the images of points.
    static constexpr double largest_ratio = 0x1p38;

  private:
    // A vector as integral multiples of the caller's vectors.
    struct Combination {
        std::int64_t of[3];
        double x[3];
    };
    static constexpr double coordinate_error = 0x1p-49;  // docs/theory.md, "Periodic boxes"

    void set(Combination& v) const;
    void add(Combination& v, const Combination& w, double factor) const;
    bool is_shorter(const Combination& v, const Combination& w) const;
    bool is_acute(const Combination& v, const Combination& w) const;
    void reduce();
    void complete();
    void set_dual();

    unsigned dimensions_;
    int exponent_ = 0;
    double factors_[2] = {};  // their product is 2^-exponent_, and may be no double
    bool is_exact_ = false;
    double given_[3][3] = {};
    std::int64_t transform_[3][3] = {};  // the vectors of the basis, by the caller's vectors
    double basis_[3][3] = {}, dual_[3][3] = {};
    double slope_[3] = {};
    double covering_radius_ = 0;
};

}  // namespace mgdt
