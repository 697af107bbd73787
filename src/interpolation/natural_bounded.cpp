// SPDX-License-Identifier: MIT
// Natural-neighbour coordinates in numbers that bound their own errors, in space and in planes of
// the hull.
#include <algorithm>
#include <iterator>

#include "interpolation/natural_weights.hpp"
#include "predicates/bounded_numbers.hpp"

namespace mgdt {
namespace {

// The largest error of a weight before it is rounded to a double, about as large as the rounding
// error of a number near 1.
constexpr double weight_error = 0x1p-52;

template <class Numbers>
class BoundedStar {
  public:
    using B = typename Numbers::B;
    using V = Vector<B>;

    BoundedStar(Allocator& allocator, Numbers& numbers, const Mesh& mesh, const PlaceStar& star,
                const double* q)
        : mesh_(mesh),
          star_(star),
          numbers_(numbers),
          x_(numbers.array(allocator, 3 * star.size())),
          centers_(numbers.array(allocator, 3 * star.simplices())),
          sums_(numbers.array(allocator, star.size())),
          order_(allocator) {
        for (PlaceStar::Number k = 0; k < star.size(); ++k) {
            set(x_, k, difference(point(k), q));
            numbers_.forget();
        }
    }

    // These functions compute sums that are proportional to the weights.
    void measure_in_space(Natural natural);
    void measure_on_hull(Natural natural);
    // Writes the weights. Returns false if they are not known well enough.
    bool give(Buffer<double>& weights);

  private:
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
    // Calls f for each part in the order of its corners. This order depends on the points alone, so
    // sums over the parts do too.
    template <class Part, class F>
    void for_each(const Buffer<Part>& parts, F f) {
        order_.clear();
        for (std::uint32_t i = 0; i < parts.size(); ++i) order_.push_back(i);
        std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
            const auto &of_a = parts[a].corner, &of_b = parts[b].corner;
            return std::lexicographical_compare(std::begin(of_a), std::end(of_a), std::begin(of_b),
                                                std::end(of_b));
        });
        for (const std::uint32_t i : order_) f(parts[i]);
    }
    void add_to(PlaceStar::Number k, const B& term, bool is_negative) {
        const B sum = sums_.get(numbers_, k);
        sums_.set(k, is_negative ? sum - term : sum + term);
    }
    // The circumcentre of a tetrahedron or triangle with one corner at the origin, relative to that
    // corner.
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
    Numbers& numbers_;
    Array x_, centers_, sums_;
    Buffer<std::uint32_t> order_;
};

// The circumcentre of a tetrahedron of either orientation.
template <class Numbers>
auto BoundedStar<Numbers>::center(const V& a, const V& b, const V& c) -> V {
    const V bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const B two_volumes = dot(a, bc) + dot(a, bc);
    V sum = dot(a, a) * bc + dot(b, b) * ca;
    sum = sum + dot(c, c) * ab;
    for (B& x : sum.x) x = x / two_volumes;
    return sum;
}

// The circumcentre of a triangle.
template <class Numbers>
auto BoundedStar<Numbers>::center(const V& a, const V& b) -> V {
    const V normal = cross(a, b);
    V sum = cross(dot(a, a) * b - dot(b, b) * a, normal);
    const B two_squares = dot(normal, normal) + dot(normal, normal);
    for (B& x : sum.x) x = x / two_squares;
    return sum;
}

template <class Numbers>
void BoundedStar<Numbers>::measure_in_space(Natural natural) {
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
        for_each(star_.old_facets(), [&](const auto& f) {
            const V c = cross(get(centers_, f.near), get(centers_, f.beyond));
            const PlaceStar::Number(&v)[3] = f.corner;
            for (int k = 0; k < 3; ++k)
                add_to(v[k], dot(get(x_, v[(k + 1) % 3]) - get(x_, v[(k + 2) % 3]), c), f.is_odd);
            numbers_.forget();
        });
    for_each(star_.new_facets(), [&](const auto& f) {
        const V c = cross(get(centers_, f.near), get(centers_, f.beyond));
        const PlaceStar::Number(&v)[2] = f.corner;
        add_to(v[0], dot(get(x_, v[is_sibson ? 1 : 0]), c), !f.is_odd);
        add_to(v[1], dot(get(x_, v[is_sibson ? 0 : 1]), c), f.is_odd);
        numbers_.forget();
    });
    if (!is_sibson) divide_by_squares();
}

template <class Numbers>
void BoundedStar<Numbers>::measure_on_hull(Natural natural) {
    const std::size_t removed = star_.removed_triangles().size();
    int axis = 0;
    bool is_first = true;
    for_each(star_.removed_triangles(), [&](const auto& t) {
        const PlaceStar::Number(&v)[3] = t.corner;
        const double* const base = point(v[0]);
        const V a = difference(point(v[1]), base), b = difference(point(v[2]), base);
        if (is_first) {
            // Areas of the projection along one axis are proportional to areas in the plane of the
            // triangles.
            const V normal = cross(a, b);
            for (int k = 1; k < 3; ++k)
                if (magnitude(normal.x[axis].wide()) < magnitude(normal.x[k].wide())) axis = k;
            is_first = false;
        }
        const auto i = static_cast<std::size_t>(&t - star_.removed_triangles().data());
        set(centers_, i, get(x_, v[0]) + center(a, b));
        numbers_.forget();
    });
    for (std::size_t i = 0; i < star_.created_triangles().size(); ++i) {
        const PlaceStar::Number(&v)[2] = star_.created_triangles()[i].corner;
        set(centers_, removed + i, center(get(x_, v[0]), get(x_, v[1])));
        numbers_.forget();
    }
    const auto area = [&](std::uint32_t near, std::uint32_t beyond) {
        const V a = get(centers_, near), b = get(centers_, beyond);
        const int y = (axis + 1) % 3, z = (axis + 2) % 3;
        return a.x[y] * b.x[z] - a.x[z] * b.x[y];
    };
    if (natural == Natural::sibson)
        for_each(star_.old_edges(), [&](const auto& e) {
            const B a = area(e.near, e.beyond);
            add_to(e.corner[0], a, !e.is_odd);
            add_to(e.corner[1], a, e.is_odd);
            numbers_.forget();
        });
    for_each(star_.new_edges(), [&](const auto& e) {
        add_to(e.corner[0], area(e.near, e.beyond), false);
        numbers_.forget();
    });
    if (natural == Natural::laplace) divide_by_squares();
}

template <class Numbers>
bool BoundedStar<Numbers>::give(Buffer<double>& weights) {
    B total = sums_.get(numbers_, 0);
    for (PlaceStar::Number k = 1; k < star_.size(); ++k) total = total + sums_.get(numbers_, k);
    for (PlaceStar::Number k = 0; k < star_.size(); ++k) {
        const B weight = sums_.get(numbers_, k) / total;
        if (!(weight.wide_error() < WideDouble(weight_error))) return false;
        weights[k] = weight.wide().in_double();
    }
    return true;
}

template <class Numbers>
bool give_weights(Numbers& numbers, const Mesh& mesh, const PlaceStar& star, const double* q,
                  Natural natural, Buffer<double>& weights) {
    BoundedStar<Numbers> measured(weights.allocator(), numbers, mesh, star, q);
    if (star.is_on_hull())
        measured.measure_on_hull(natural);
    else
        measured.measure_in_space(natural);
    return measured.give(weights);
}

}  // namespace

bool NaturalWeights::in_twofold(const Mesh& mesh, const PlaceStar& star, const double* q,
                                Natural natural) {
    BoundedFloats<Twofold> numbers;
    if (!give_weights(numbers, mesh, star, q, natural, weights_)) return false;
    normalize();
    return true;
}

bool NaturalWeights::in_long(const Mesh& mesh, const PlaceStar& star, const double* q,
                             Natural natural, std::size_t limbs) {
    BoundedLongs numbers(weights_.allocator(), limbs);
    if (!give_weights(numbers, mesh, star, q, natural, weights_)) return false;
    normalize();
    return true;
}

}  // namespace mgdt
