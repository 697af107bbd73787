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

// Numbers with bounds, and an array of them that stays while what is computed meanwhile is
// forgotten. Twofold numbers need a common factor that brings them near 1.
template <class Real>
class BoundedNumbers;

template <>
class BoundedNumbers<Twofold> {
  public:
    using B = Bounded<Twofold>;
    BoundedNumbers(Allocator&, std::size_t, double factor) : factor_(factor) {}
    B number(double x) const { return {{x, 0}, 0}; }
    B difference(double a, double b) const {
        const Twofold exact = Twofold::sum(a, -b);
        return {{exact.high * factor_, exact.low * factor_}, 0};
    }
    void forget() {}

    class Array {
      public:
        Array(Allocator& allocator, std::size_t size, std::size_t) : numbers_(allocator) {
            numbers_.resize(size, B{{0, 0}, 0});
        }
        B get(const BoundedNumbers&, std::size_t i) const { return numbers_[i]; }
        void set(std::size_t i, const B& x) { numbers_[i] = x; }

      private:
        Buffer<B> numbers_;
    };

  private:
    double factor_;
};

template <>
class BoundedNumbers<LongNumber> {
  public:
    using B = Bounded<LongNumber>;
    BoundedNumbers(Allocator& allocator, std::size_t limbs, double) : memory_(allocator, limbs) {}
    B number(double x) { return {memory_.number(x), {}}; }
    B difference(double a, double b) { return number(a) - number(b); }
    void forget() { memory_.release(0); }

    class Array {
      public:
        Array(Allocator& allocator, std::size_t size, std::size_t limbs)
            : numbers_(allocator, size, limbs), errors_(allocator) {
            errors_.resize(size, WideDouble());
        }
        B get(BoundedNumbers& in, std::size_t i) const {
            return {in.memory_.copy(numbers_[i]), errors_[i]};
        }
        void set(std::size_t i, const B& x) {
            numbers_.set(i, x.value);
            errors_[i] = x.error;
        }

      private:
        LongNumbers numbers_;
        Buffer<WideDouble> errors_;
    };

  private:
    LongMemory memory_;
};

template <class Real>
class BoundedStar {
  public:
    using B = Bounded<Real>;
    using V = Vector<B>;

    BoundedStar(Allocator& allocator, const Mesh& mesh, const PlaceStar& star, const double* q,
                double factor, std::size_t limbs)
        : mesh_(mesh),
          star_(star),
          numbers_(allocator, limbs, factor),
          x_(allocator, 3 * star.size(), limbs),
          centers_(allocator, 3 * (star.removed().size() + star.created().size()), limbs),
          sums_(allocator, star.size(), limbs) {
        for (PlaceStar::Number k = 0; k < star.size(); ++k) {
            set(x_, k, difference(point(k), q));
            numbers_.forget();
        }
    }

    // Leave what is proportional to the weights.
    void measure_in_space(Natural natural);
    void measure_on_hull(Natural natural);
    // The weights; false if they are not known well enough.
    bool give(Buffer<double>& weights);

  private:
    using Numbers = BoundedNumbers<Real>;
    using Array = typename Numbers::Array;
    V get(const Array& from, std::size_t i) {
        return {{from.get(numbers_, 3 * i), from.get(numbers_, 3 * i + 1),
                 from.get(numbers_, 3 * i + 2)}};
    }
    static void set(Array& to, std::size_t i, const V& x) {
        for (std::size_t k = 0; k < 3; ++k) to.set(3 * i + k, x.x[k]);
    }
    const double* point(PlaceStar::Number k) const { return mesh_.point(star_.vertex(k)); }
    V difference(const double* a, const double* b) {
        return {{numbers_.difference(a[0], b[0]), numbers_.difference(a[1], b[1]),
                 numbers_.difference(a[2], b[2])}};
    }
    void add_to(PlaceStar::Number k, const B& term, bool is_negative) {
        const B sum = sums_.get(numbers_, k);
        sums_.set(k, is_negative ? sum - term : sum + term);
    }
    // Relative to the corner that all vectors are relative to.
    MGDT_NOT_INLINE static V center(const V& a, const V& b, const V& c);
    MGDT_NOT_INLINE static V center(const V& a, const V& b);
    void divide_by_squares() {
        for (PlaceStar::Number k = 0; k < star_.size(); ++k) {
            const V x = get(x_, k);
            sums_.set(k, sums_.get(numbers_, k) / dot(x, x));
            numbers_.forget();
        }
    }

    const Mesh& mesh_;
    const PlaceStar& star_;
    Numbers numbers_;
    Array x_, centers_, sums_;
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
        set(centers_, i,
            get(x_, v[0]) + center(difference(point(v[1]), base), difference(point(v[2]), base),
                                   difference(point(v[3]), base)));
        numbers_.forget();
    }
    for (std::size_t i = 0; i < star_.created().size(); ++i) {
        const PlaceStar::Number(&v)[3] = star_.created()[i].corner;
        set(centers_, removed + i, center(get(x_, v[0]), get(x_, v[1]), get(x_, v[2])));
        numbers_.forget();
    }
    if (is_sibson)
        for (const auto& f : star_.old_facets()) {
            const V c = cross(get(centers_, f.near), get(centers_, f.beyond));
            const PlaceStar::Number(&v)[3] = f.corner;
            for (int k = 0; k < 3; ++k)
                add_to(v[k], dot(get(x_, v[(k + 1) % 3]) - get(x_, v[(k + 2) % 3]), c), f.is_odd);
            numbers_.forget();
        }
    for (const auto& f : star_.new_facets()) {
        const V c = cross(get(centers_, f.near), get(centers_, f.beyond));
        const PlaceStar::Number(&v)[2] = f.corner;
        add_to(v[0], dot(get(x_, v[is_sibson ? 1 : 0]), c), !f.is_odd);
        add_to(v[1], dot(get(x_, v[is_sibson ? 0 : 1]), c), f.is_odd);
        numbers_.forget();
    }
    if (!is_sibson) divide_by_squares();
}

template <class Real>
void BoundedStar<Real>::measure_on_hull(Natural natural) {
    const std::size_t removed = star_.removed_triangles().size();
    int axis = 0;
    for (std::size_t i = 0; i < removed; ++i) {
        const PlaceStar::Number(&v)[4] = star_.removed_triangles()[i].corner;
        const double* const base = point(v[0]);
        const V a = difference(point(v[1]), base), b = difference(point(v[2]), base);
        if (i == 0) {
            // Areas of the shadow along one axis are proportional to those in the plane.
            const V normal = cross(a, b);
            for (int k = 1; k < 3; ++k)
                if (normal.x[axis].magnitude() < normal.x[k].magnitude()) axis = k;
        }
        set(centers_, i, get(x_, v[0]) + center(a, b));
        numbers_.forget();
    }
    for (std::size_t i = 0; i < star_.created_triangles().size(); ++i) {
        const PlaceStar::Number(&v)[3] = star_.created_triangles()[i].corner;
        set(centers_, removed + i, center(get(x_, v[0]), get(x_, v[1])));
        numbers_.forget();
    }
    const auto area = [&](std::uint32_t near, std::uint32_t beyond) {
        const V a = get(centers_, near), b = get(centers_, beyond);
        const int y = (axis + 1) % 3, z = (axis + 2) % 3;
        return a.x[y] * b.x[z] - a.x[z] * b.x[y];
    };
    if (natural == Natural::sibson)
        for (const auto& e : star_.old_edges()) {
            const B a = area(e.near, e.beyond);
            add_to(e.corner[0], a, !e.is_odd);
            add_to(e.corner[1], a, e.is_odd);
            numbers_.forget();
        }
    for (const auto& e : star_.new_edges()) {
        add_to(e.corner, area(e.near, e.beyond), false);
        numbers_.forget();
    }
    if (natural == Natural::laplace) divide_by_squares();
}

template <class Real>
bool BoundedStar<Real>::give(Buffer<double>& weights) {
    B total = numbers_.number(0);
    for (PlaceStar::Number k = 0; k < star_.size(); ++k) total = total + sums_.get(numbers_, k);
    for (PlaceStar::Number k = 0; k < star_.size(); ++k) {
        const B weight = sums_.get(numbers_, k) / total;
        if (!(weight.error < typename B::Bound(weight_error))) return false;
        if constexpr (std::is_same_v<Real, Twofold>)
            weights[k] = weight.value.high;
        else
            weights[k] = weight.value.wide().in_double();
    }
    return true;
}

}  // namespace

template <class Real>
bool NaturalWeights::in_real(const Mesh& mesh, const PlaceStar& star, const double* q,
                             Natural natural, std::size_t limbs) {
    BoundedStar<Real> measured(weights_.allocator(), mesh, star, q, factor_, limbs);
    if (star.is_on_hull())
        measured.measure_on_hull(natural);
    else
        measured.measure_in_space(natural);
    if (!measured.give(weights_)) return false;
    normalize();
    return true;
}
template bool NaturalWeights::in_real<Twofold>(const Mesh&, const PlaceStar&, const double*,
                                               Natural, std::size_t);
template bool NaturalWeights::in_real<LongNumber>(const Mesh&, const PlaceStar&, const double*,
                                                  Natural, std::size_t);

}  // namespace mgdt
