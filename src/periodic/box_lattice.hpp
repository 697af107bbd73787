// SPDX-License-Identifier: MIT
// The lattice of a periodic box, and a basis of it that consists of short vectors.
#pragma once

#include <array>
#include <cstdint>

namespace mgdt {

// How many times each vector of a basis is taken.
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

// The basis is part of an obtuse superbase: no two of its vectors, and of these and minus their
// sum, make an acute angle (Conway and Sloane, Low-dimensional lattices VI, 1992). So the cell of a
// lattice point is bounded by planes towards sums of subsets of the basis and their opposites, and
// no other lattice points.
class BoxLattice {
  public:
    // One to three vectors of three finite coordinates each. Throws MGDT_ERR_INVALID_ARGUMENT if
    // they do not span.
    BoxLattice(unsigned dimensions, const double* vectors);

    unsigned dimensions() const { return dimensions_; }
    // A vector of the basis, shortest first, and from dimensions() on an orthogonal complement.
    const double* vector(unsigned k) const { return basis_[k]; }
    // How often a place contains each of the three vectors. Rounded.
    void coordinates(const double* x, double (&s)[3]) const;
    // How much coordinate k changes at most over a distance of 1.
    double slope(unsigned k) const { return slope_[k]; }
    // A distance from the next lattice point that no place in the span exceeds.
    double covering_radius() const { return covering_radius_; }
    // Converts multiples of the basis, of which none exceeds 2^30 by much, to multiples of the
    // caller's vectors.
    std::array<std::int64_t, 3> to_callers(const Multiples& of_basis) const;

  private:
    // A vector as integral multiples of the caller's vectors.
    struct Combination {
        std::int64_t of[3];
        double x[3];
    };
    void set(Combination& v) const;
    void add(Combination& v, const Combination& w, double factor) const;
    void reduce();
    void complete();
    void set_dual();

    unsigned dimensions_;
    double given_[3][3] = {};
    std::int64_t transform_[3][3] = {};  // the vectors of the basis, by the caller's vectors
    double basis_[3][3] = {}, dual_[3][3] = {};
    double slope_[3] = {};
    double covering_radius_ = 0;
};

}  // namespace mgdt
