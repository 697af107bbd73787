// SPDX-License-Identifier: MIT
// The natural-neighbour coordinates of a place: the weights that Sibson's and Laplace's
// interpolation give the vertices around it.
#pragma once

#include "interpolation/place_star.hpp"
#include "kernel/circumsphere.hpp"

namespace mgdt {

enum class Natural { sibson, laplace };

// How far a weight may be from the exact one, of all weights, which add up to 1; and the place that
// the weights have from where it is, of the mean distance of its neighbours.
inline constexpr double natural_weight_error = 0x1p-30;
inline constexpr double natural_place_error = 0x1p-47;

// Weights of the vertices of the star of q, a place in the mesh's scale that is not on a ridge of
// the hull, by their local numbers: none is negative, and their sum is 1 but for its rounding. They
// do not depend on how the triangulation came about.
class NaturalWeights {
  public:
    explicit NaturalWeights(Allocator& allocator)
        : weights_(allocator), x_(allocator), centers_(allocator), sums_(allocator) {}

    void find(const Mesh& mesh, const PlaceStar& star, const double* q, Natural natural);
    const Buffer<double>& weights() const noexcept { return weights_; }

    // The stages, one by one: doubles, the same with circumcentres that are good to the last bits,
    // and numbers that bound their errors. Doubles leave weights even where they are not sure of
    // them. Others are false where the weights are not known to 2^-52. Long numbers are cut off to
    // `bits`; enough bits always do.
    enum class Stage { doubles, corrected, twofold, long_numbers };
    bool find_in(Stage stage, const Mesh& mesh, const PlaceStar& star, const double* q,
                 Natural natural, int bits = 512);

  private:
    struct Center {
        double x[3], size, error;
    };
    bool in_doubles(const Mesh& mesh, const PlaceStar& star, const double* q, Natural natural,
                    bool is_corrected);
    bool in_twofold(const Mesh& mesh, const PlaceStar& star, const double* q, Natural natural);
    bool in_long(const Mesh& mesh, const PlaceStar& star, const double* q, Natural natural,
                 std::size_t limbs);
    bool set_centers(const Mesh& mesh, const PlaceStar& star, Natural natural);
    void set_corrected_centers(const Mesh& mesh, const PlaceStar& star, const double* q,
                               Natural natural);
    // From sums that are proportional to the weights.
    void normalize();
    bool is_in_place(double (&off)[3]) const;
    bool correct(const double (&off)[3]);

    Buffer<double> weights_;
    Buffer<LocalVertex> x_;  // by local number: relative to the place, the largest near 1
    Buffer<Center> centers_;
    Buffer<std::uint64_t> sums_;  // of integers, modulo 2^64
    double factor_ = 1;
};

}  // namespace mgdt
