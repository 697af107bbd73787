// SPDX-License-Identifier: MIT
// Predicates that compare distances, that test whether points are collinear, and that find the side
// of a plane perpendicular to a triangle.
#include "predicates/determinants.hpp"
#include "predicates/predicates.hpp"
#include "predicates/stages.hpp"

namespace mgdt {
namespace {

using exact::Differences;

// The difference of the squared lengths of two vectors.
struct SquareDifference {
    template <class T>
    auto operator()(const T (&v)[6]) const {
        return ((v[0] * v[0] + v[1] * v[1]) + v[2] * v[2]) -
               ((v[3] * v[3] + v[4] * v[4]) + v[5] * v[5]);
    }
};

// The scalar product of two vectors.
struct Product {
    template <class T>
    auto operator()(const T (&v)[6]) const {
        return exact::scalar_product(v, v + 3);
    }
};

// One coordinate of the cross product of two vectors.
template <int I>
struct Cross {
    static constexpr int j = (I + 1) % 3, k = (I + 2) % 3;

    template <class T>
    auto operator()(const T (&v)[6]) const {
        return v[j] * v[3 + k] - v[k] * v[3 + j];
    }
};

// (e x f) . (e x w) for the edge e: |e|^2 times the scalar product of the components of f and w
// that are perpendicular to e.
struct EdgePlane {
    template <class T>
    auto operator()(const T (&v)[9]) const {
        const T *const e = v, *const f = v + 3, *const w = v + 6;
        using exact::scalar_product;
        return exact::two_products(scalar_product(e, e), scalar_product(f, w), scalar_product(e, w),
                                   scalar_product(e, f));
    }
};

struct TwoVectors : exact::ExactPairs<6> {
    static constexpr int count = 6;
};

MGDT_PREDICATES_INLINE int square_filter(const Differences<6>& v, const exact::Bound& bound) {
    return exact::filtered(v, bound, SquareDifference());
}

MGDT_PREDICATES_INLINE int cross_filter(const Differences<6>& v, const exact::Bound& bound) {
    const bool nonzero = exact::filtered(v, bound, Cross<0>()) != exact::undecided ||
                         exact::filtered(v, bound, Cross<1>()) != exact::undecided ||
                         exact::filtered(v, bound, Cross<2>()) != exact::undecided;
    return nonzero ? 1 : exact::undecided;
}

}  // namespace

bool collinear(const double* a, const double* b, const double* c) {
    int s = cross_filter(exact::differences({b, c}, a), exact::collinear_bound);
    if (s == exact::undecided) s = exact::collinear_ranged(a, b, c);
    return s == exact::undecided ? exact::collinear_integer(a, b, c) : s == 0;
}

void find_rough_turns(const double* a, const double* b, const double* c, int (&turns)[3]) {
    const auto v = exact::differences({b, c}, a);
    turns[0] = exact::filtered(v, exact::collinear_bound, Cross<0>());
    turns[1] = exact::filtered(v, exact::collinear_bound, Cross<1>());
    turns[2] = exact::filtered(v, exact::collinear_bound, Cross<2>());
    for (int& turn : turns)
        if (turn == exact::undecided) turn = 0;
}

int compare_distance(const double* q, const double* a, const double* b) {
    // The vectors are a - q and b - q, whose squares are those of q - a and q - b.
    int s = square_filter(exact::differences({a, b}, q), exact::distance_bound);
    if (s == exact::undecided) s = exact::distance_ranged(q, a, b);
    return s != exact::undecided ? s : exact::distance_integer(q, a, b);
}

int compare_lengths(const double* a, const double* b, const double* c, const double* d) {
    const int s = exact::lengths_filter(a, b, c, d);
    return s != exact::undecided ? s : exact::lengths_integer(a, b, c, d);
}

int side_of_diametral_sphere(const double* a, const double* b, const double* q) {
    const int s = exact::diametral_filter(a, b, q);
    return s != exact::undecided ? s : exact::diametral_integer(a, b, q);
}

int side_of_edge(const double* a, const double* b, const double* c, const double* q) {
    const int s = exact::edge_filter(a, b, c, q);
    return s != exact::undecided ? s : exact::edge_integer(a, b, c, q);
}

namespace exact {

int edge_filter(const double* a, const double* b, const double* c, const double* q,
                const Bound& bound) {
    return filtered(differences({b, c, q}, a), bound, EdgePlane());
}

int edge_integer(const double* a, const double* b, const double* c, const double* q,
                 int least_width) {
    return with_integers(ExactDifferences<9>({b, c, q}, a), least_width,
                         [](const auto& v) { return sign(EdgePlane()(v)); });
}

int lengths_filter(const double* a, const double* b, const double* c, const double* d,
                   const Bound& bound) {
    // The two vectors have no common origin, so differences() cannot compute them.
    Differences<6> v = {{}, a, {}, 0};
    each<3>([&](auto k) {
        v.rounded[k] = a[k] - b[k];
        v.rounded[k + 3] = c[k] - d[k];
    });
    v.largest = largest_of<0, 6>(v.rounded);
    return filtered(v, bound, SquareDifference());
}

int lengths_integer(const double* a, const double* b, const double* c, const double* d,
                    int least_width) {
    TwoVectors v;
    for (std::size_t k = 0; k < 3; ++k) {
        v.set(k, a[k], b[k]);
        v.set(k + 3, c[k], d[k]);
    }
    return with_integers(v, least_width,
                         [](const auto& of) { return sign(SquareDifference()(of)); });
}

int diametral_filter(const double* a, const double* b, const double* q, const Bound& bound) {
    const int s = filtered(differences({a, b}, q), bound, Product());
    return s == undecided ? undecided : -s;
}

int diametral_integer(const double* a, const double* b, const double* q, int least_width) {
    return with_integers(ExactDifferences<6>({a, b}, q), least_width,
                         [](const auto& v) { return -sign(Product()(v)); });
}

int collinear_filter(const double* a, const double* b, const double* c, const Bound& bound) {
    return cross_filter(differences({b, c}, a), bound);
}

int collinear_ranged(const double* a, const double* b, const double* c, double bound) {
    const RangedDifferences<6> v({b, c}, a);
    const int x = v.sign(Cross<0>(), bound), y = v.sign(Cross<1>(), bound),
              z = v.sign(Cross<2>(), bound);
    if (x == 0 && y == 0 && z == 0) return 0;
    const auto is_sure = [](int s) { return s == 1 || s == -1; };
    return is_sure(x) || is_sure(y) || is_sure(z) ? 1 : undecided;
}

bool collinear_integer(const double* a, const double* b, const double* c, int least_width) {
    const auto is_zero = [](const auto& v) -> int {
        return sign(Cross<0>()(v)) == 0 && sign(Cross<1>()(v)) == 0 && sign(Cross<2>()(v)) == 0;
    };
    return with_integers(ExactDifferences<6>({b, c}, a), least_width, is_zero) != 0;
}

int distance_filter(const double* q, const double* a, const double* b, const Bound& bound) {
    return square_filter(differences({a, b}, q), bound);
}

int distance_ranged(const double* q, const double* a, const double* b, double bound) {
    return RangedDifferences<6>({a, b}, q).sign(SquareDifference(), bound);
}

int distance_integer(const double* q, const double* a, const double* b, int least_width) {
    return with_integers(ExactDifferences<6>({a, b}, q), least_width,
                         [](const auto& v) { return sign(SquareDifference()(v)); });
}

}  // namespace exact
}  // namespace mgdt
