// SPDX-License-Identifier: MIT
// What the value at a place is made of: weights of values at vertices, and of their gradients.
#pragma once

#include <optional>

#include "interpolation/gradient.hpp"
#include "interpolation/hull_place.hpp"
#include "interpolation/natural_weights.hpp"
#include "query/flat_hull.hpp"

namespace mgdt {

enum class Method { linear, nearest, sibson, laplace, sibson_c1 };
enum class Outside { none, nearest, boundary, linear };

// The value is the sum of weights times the values at vertices, and for each slope the product of
// its factor, its way and the gradient at its vertex, in the lengths of the mesh's scale. Empty
// where there is no value.
struct PlaceRow {
    explicit PlaceRow(Allocator& allocator) : weights(allocator), slopes(allocator) {}
    struct Weight {
        VertexId vertex;
        double weight;
    };
    struct Slope {
        VertexId vertex;
        double factor;
        Vector<Twofold> way;  // as long gradients across thin neighbourhoods cancel along it
    };
    Buffer<Weight> weights;  // none is 0; in the order of the caller's indices
    Buffer<Slope> slopes;
};

// One place after another, in the same memory: each thread has its own.
class Interpolator {
  public:
    Interpolator(const Locator& where, Allocator& allocator, Method method, Outside outside);

    // Of q, found in tetrahedron t or, with no_tetrahedron, outside the hull and near `near`, as
    // Locator::locate() says.
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
    double q_[3] = {};       // in the mesh's scale
    bool is_exact_ = false;  // but for its rounding
    PlaceRow row_;
    std::optional<PlaceStar> star_;
    NaturalWeights natural_;
    std::optional<FlatHull> flat_hull_;  // if there are no tetrahedra and nothing outside it
};

}  // namespace mgdt
