// SPDX-License-Identifier: MIT
// Natural-neighbour coordinates in numbers that bound their own errors, in space and in planes of
// the hull.
#include <algorithm>

#include "interpolation/natural_weights.hpp"
#include "predicates/bounded.hpp"

namespace mgdt {
namespace {

// Of each weight: so that its rounding is the larger part of what it is off.
constexpr double weight_error = 0x1p-52;

void set_difference(Bounded<Twofold>& d, double a, double b, double factor) {
    const Twofold exact = Twofold::sum(a, -b);
    d = {{exact.high * factor, exact.low * factor}, 0};
}
// Where no number is too small or too large.
template <int Bits>
void set_difference(Bounded<LongFloat<Bits>>& d, double a, double b, double) {
    using B = Bounded<LongFloat<Bits>>;
    d = B{LongFloat<Bits>(a), {}} - B{LongFloat<Bits>(b), {}};
}

template <class Real>
class BoundedStar {
  public:
    using B = Bounded<Real>;
    using V = Vector<B>;

    BoundedStar(Allocator& allocator, const Mesh& mesh, const PlaceStar& star, const double* q,
                double factor)
        : mesh_(mesh),
          star_(star),
          factor_(factor),
          x_(allocator, star.size()),
          centers_(allocator, star.removed().size() + star.created().size()),
          sums_(allocator, star.size()) {
        for (PlaceStar::Number k = 0; k < star.size(); ++k) {
            x_[k] = difference(point(k), q);
            sums_[k] = number(0);
        }
    }

    // Leave what is proportional to the weights.
    void measure_in_space(Natural natural);
    void measure_on_hull(Natural natural);
    // The weights; false if they are not known well enough.
    bool give(Buffer<double>& weights);

  private:
    static B number(double x) {
        B b{};
        b.value = real(x);
        return b;
    }
    static Real real(double x) {
        if constexpr (std::is_same_v<Real, Twofold>)
            return {x, 0};
        else
            return Real(x);
    }
    const double* point(PlaceStar::Number k) const { return mesh_.point(star_.vertex(k)); }
    V difference(const double* a, const double* b) const {
        V d;
        for (int axis = 0; axis < 3; ++axis) set_difference(d.x[axis], a[axis], b[axis], factor_);
        return d;
    }
    void add_to(PlaceStar::Number k, const B& term, bool is_negative) {
        sums_[k] = is_negative ? sums_[k] - term : sums_[k] + term;
    }
    // Relative to the corner that all vectors are relative to.
    MGDT_NOT_INLINE static V center(const V& a, const V& b, const V& c);
    MGDT_NOT_INLINE static V center(const V& a, const V& b);
    void divide_by_squares() {
        for (PlaceStar::Number k = 0; k < star_.size(); ++k)
            sums_[k] = sums_[k] / dot(x_[k], x_[k]);
    }

    const Mesh& mesh_;
    const PlaceStar& star_;
    const double factor_;
    Buffer<V> x_, centers_;
    Buffer<B> sums_;
};

// Of a tetrahedron, however it is oriented.
template <class Real>
auto BoundedStar<Real>::center(const V& a, const V& b, const V& c) -> V {
    const V bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const B two_volumes = dot(a, bc) + dot(a, bc);
    V sum = dot(a, a) * bc + dot(b, b) * ca;
    sum = sum + dot(c, c) * ab;
    for (B& x : sum.x) x = x / two_volumes;
    return sum;
}

// Of a triangle.
template <class Real>
auto BoundedStar<Real>::center(const V& a, const V& b) -> V {
    const V normal = cross(a, b);
    V sum = cross(dot(a, a) * b - dot(b, b) * a, normal);
    const B two_squares = dot(normal, normal) + dot(normal, normal);
    for (B& x : sum.x) x = x / two_squares;
    return sum;
}

template <class Real>
void BoundedStar<Real>::measure_in_space(Natural natural) {
    const bool is_sibson = natural == Natural::sibson;
    const std::size_t removed = star_.removed().size();
    for (std::size_t i = 0; i < (is_sibson ? removed : 0); ++i) {
        const PlaceStar::Number(&v)[4] = star_.removed()[i].corner;
        const double* const base = point(v[0]);
        centers_[i] =
            x_[v[0]] + center(difference(point(v[1]), base), difference(point(v[2]), base),
                              difference(point(v[3]), base));
    }
    for (std::size_t i = 0; i < star_.created().size(); ++i) {
        const PlaceStar::Number(&v)[3] = star_.created()[i].corner;
        centers_[removed + i] = center(x_[v[0]], x_[v[1]], x_[v[2]]);
    }
    if (is_sibson)
        for (const auto& f : star_.old_facets()) {
            const V c = cross(centers_[f.near], centers_[f.beyond]);
            const PlaceStar::Number(&v)[3] = f.corner;
            for (int k = 0; k < 3; ++k)
                add_to(v[k], dot(x_[v[(k + 1) % 3]] - x_[v[(k + 2) % 3]], c), f.is_odd);
        }
    for (const auto& f : star_.new_facets()) {
        const V c = cross(centers_[f.near], centers_[f.beyond]);
        const PlaceStar::Number(&v)[2] = f.corner;
        add_to(v[0], dot(x_[v[is_sibson ? 1 : 0]], c), !f.is_odd);
        add_to(v[1], dot(x_[v[is_sibson ? 0 : 1]], c), f.is_odd);
    }
    if (!is_sibson) divide_by_squares();
}

template <class Real>
void BoundedStar<Real>::measure_on_hull(Natural natural) {
    const std::size_t removed = star_.removed_triangles().size();
    V normal{};
    for (std::size_t i = 0; i < removed; ++i) {
        const PlaceStar::Number(&v)[4] = star_.removed_triangles()[i].corner;
        const double* const base = point(v[0]);
        const V a = difference(point(v[1]), base), b = difference(point(v[2]), base);
        if (i == 0) normal = cross(a, b);
        centers_[i] = x_[v[0]] + center(a, b);
    }
    for (std::size_t i = 0; i < star_.created_triangles().size(); ++i) {
        const PlaceStar::Number(&v)[3] = star_.created_triangles()[i].corner;
        centers_[removed + i] = center(x_[v[0]], x_[v[1]]);
    }
    // Areas of the shadow along one axis are proportional to those in the plane.
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (normal.x[axis].magnitude() < normal.x[k].magnitude()) axis = k;
    const auto area = [&](std::uint32_t near, std::uint32_t beyond) {
        const V &a = centers_[near], &b = centers_[beyond];
        const int y = (axis + 1) % 3, z = (axis + 2) % 3;
        return a.x[y] * b.x[z] - a.x[z] * b.x[y];
    };
    if (natural == Natural::sibson)
        for (const auto& e : star_.old_edges()) {
            const B a = area(e.near, e.beyond);
            add_to(e.corner[0], a, !e.is_odd);
            add_to(e.corner[1], a, e.is_odd);
        }
    for (const auto& e : star_.new_edges()) add_to(e.corner, area(e.near, e.beyond), false);
    if (natural == Natural::laplace) divide_by_squares();
}

template <class Real>
bool BoundedStar<Real>::give(Buffer<double>& weights) {
    B total = number(0);
    for (const B& s : sums_) total = total + s;
    for (PlaceStar::Number k = 0; k < star_.size(); ++k) {
        const B weight = sums_[k] / total;
        if (!(weight.error < typename B::Bound(weight_error))) return false;
        if constexpr (std::is_same_v<Real, Twofold>)
            weights[k] = weight.value.high;
        else
            weights[k] = weight.value.in_double();
    }
    return true;
}

}  // namespace

template <class Real>
bool NaturalWeights::in_real(const Mesh& mesh, const PlaceStar& star, const double* q,
                             Natural natural) {
    BoundedStar<Real> measured(weights_.allocator(), mesh, star, q, factor_);
    if (star.is_on_hull())
        measured.measure_on_hull(natural);
    else
        measured.measure_in_space(natural);
    if (!measured.give(weights_)) return false;
    normalize();
    return true;
}
template bool NaturalWeights::in_real<Twofold>(const Mesh&, const PlaceStar&, const double*,
                                               Natural);
template bool NaturalWeights::in_real<LongFloat<512>>(const Mesh&, const PlaceStar&, const double*,
                                                      Natural);
template bool NaturalWeights::in_real<LongFloat<2048>>(const Mesh&, const PlaceStar&, const double*,
                                                       Natural);

}  // namespace mgdt
