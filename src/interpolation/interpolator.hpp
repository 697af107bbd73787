// SPDX-License-Identifier: MIT
// The contributions to the interpolated value at a place: weights of the values at vertices, and of
// the gradients at vertices.
#pragma once

#include <optional>

#include "interpolation/gradient.hpp"
#include "interpolation/hull_place.hpp"
#include "interpolation/natural_weights.hpp"
#include "query/flat_hull.hpp"

namespace mgdt {

enum class Method { linear, nearest, sibson, laplace, sibson_c1 };
enum class Outside { none, nearest, boundary, linear };

// The value at the place is the sum of the weights times the values at the vertices, plus, for each
// slope, its factor times the product of its displacement and the gradient at its vertex, in units
// of the mesh's scale. The row is empty if there is no value.
struct PlaceRow {
    explicit PlaceRow(Allocator& allocator) : weights(allocator), slopes(allocator) {}
    struct Weight {
        VertexId vertex;
        double weight;
    };
    struct Slope {
        VertexId vertex;
        double factor;
        // The displacement is twofold, because its products with large gradients in thin
        // neighbourhoods cancel.
        Vector<Twofold> way;
    };
    Buffer<Weight> weights;  // no weight is 0; sorted by the caller's indices
    Buffer<Slope> slopes;
};

// Computes one row at a time and reuses its memory for the next. Each thread has its own
// interpolator.
class Interpolator {
  public:
    Interpolator(const Locator& where, Allocator& allocator, Method method, Outside outside);

    // The row of q, a place that Locator::locate() has found in tetrahedron t. If t is
    // no_tetrahedron, q is outside the hull. `near` is a tetrahedron near q.
    const PlaceRow& row(const double* q, TetId t, TetId near);
    static bool has_slopes(Method method, Outside outside) {
        return method == Method::sibson_c1 || outside == Outside::linear;
    }

  private:
    void add(VertexId v, double weight);
    void add_nearest(const double* q, TetId near);
    void add_inside(const double* q, TetId t);
    void add_outside(TetId near);
    bool add_natural(TetId t);
    void add_linear(const double* q, TetId t);
    void smooth();
    void extrapolate(const HullPlace& from);
    void sort();

    const Locator where_;
    Allocator& allocator_;
    const Method method_;
    const Outside outside_;
    double q_[3] = {};       // the place in the mesh's scale
    bool is_exact_ = false;  // whether scaling the place to q_ was exact
    PlaceRow row_;
    std::optional<PlaceStar> star_;
    NaturalWeights natural_;
    std::optional<FlatHull> flat_hull_;  // set if there are no tetrahedra and outside_ is none
};

}  // namespace mgdt
