// SPDX-License-Identifier: MIT
// The natural-neighbour coordinates of a place: the weights that the interpolations of Sibson and
// Laplace give to the vertices around it.
#pragma once

#include "interpolation/place_star.hpp"
#include "kernel/circumsphere.hpp"

namespace mgdt {

enum class Natural { sibson, laplace };

// natural_weight_error is the largest error of a weight, where all weights add up to 1.
// natural_place_error is the largest distance between the place and the weighted mean of its
// neighbours, relative to their mean distance.
inline constexpr double natural_weight_error = 0x1p-30;
inline constexpr double natural_place_error = 0x1p-47;

// Computes the weights of the vertices in the star of q, by their local numbers. The coordinates of
// q are in the mesh's scale, and q is not on a ridge of the hull. Weights are not negative, add up
// to 1 except for rounding, and depend on the points alone.
class NaturalWeights {
  public:
    explicit NaturalWeights(Allocator& allocator)
        : weights_(allocator), x_(allocator), centers_(allocator), sums_(allocator) {}

    void find(const Mesh& mesh, const PlaceStar& star, const double* q, Natural natural);
    const Buffer<double>& weights() const noexcept { return weights_; }

    // The stages of find(), which tests call one by one: doubles; doubles with corrected
    // circumcentres; twofold numbers and long numbers, which bound their errors. The first two
    // stages may write weights even if they return false, because the weights are uncertain. The
    // other two return false if the weights are not known to 2^-52. Long numbers are cut off to
    // `bits`; with enough bits the stage succeeds.
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
    // Turns sums that are proportional to the weights into weights: divides non-negative sums by
    // their total; negative ones become 0.
    void normalize();
    bool is_in_place(double (&off)[3]) const;
    bool correct(const double (&off)[3]);

    Buffer<double> weights_;
    Buffer<LocalVertex> x_;  // by local number: coordinates relative to the place, scaled so that
                             // the largest is near 1
    Buffer<Center> centers_;
    Buffer<std::uint64_t> sums_;  // sums of integers, modulo 2^64
    double factor_ = 1;
};

}  // namespace mgdt
