// SPDX-License-Identifier: MIT
//
// If a place were a vertex, its cell would take a part of the cell of each neighbour. Sibson's
// weight of a neighbour is proportional to the volume of this part. Laplace's weight is
// proportional to the area of the face to the neighbour divided by the neighbour's distance. Both
// are sums over edges of Voronoi cells, from one circumcentre to the next, with the place as the
// origin (docs/theory.md, "Values between points").
#include "interpolation/natural_weights.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/circumcenter.hpp"
#include "predicates/long_number.hpp"

namespace mgdt {
namespace {

constexpr double u = unit_roundoff;

}  // namespace

void NaturalWeights::find(const Mesh& mesh, const PlaceStar& star, const double* q,
                          Natural natural) {
    for (const Stage stage : {Stage::doubles, Stage::corrected, Stage::twofold})
        if (find_in(stage, mesh, star, q, natural)) return;
    for (int bits = 256; !find_in(Stage::long_numbers, mesh, star, q, natural, bits);) bits *= 2;
}

bool NaturalWeights::find_in(Stage stage, const Mesh& mesh, const PlaceStar& star, const double* q,
                             Natural natural, int bits) {
    double largest = 0;
    for (PlaceStar::Number k = 0; k < star.size(); ++k)
        for (unsigned axis = 0; axis < 3; ++axis)
            largest = std::max(largest, std::fabs(mesh.point(star.vertex(k))[axis] - q[axis]));
    // Differences of scaled coordinates do not overflow.
    const int exponent = std::ilogb(largest);
    factor_ = std::ldexp(1.0, -exponent);
    weights_.clear();
    weights_.resize(star.size(), 0.0);
    const bool is_ordinary = std::abs(exponent) < 400;
    switch (stage) {
        case Stage::doubles:
        case Stage::corrected:
            return is_ordinary && !star.is_on_hull() &&
                   in_doubles(mesh, star, q, natural, stage == Stage::corrected);
        case Stage::twofold:
            return in_twofold(mesh, star, q, natural);
        default:
            return in_long(mesh, star, q, natural,
                           static_cast<std::size_t>(bits / exact::limb_bits));
    }
}

void NaturalWeights::normalize() {
    double sum = 0;
    for (double& w : weights_) {
        w = std::max(w, 0.0);
        sum += w;
    }
    for (double& w : weights_) w /= sum;
}

// Computes the distance between the place and the weighted mean of its neighbours. Returns whether
// it is below the bound.
bool NaturalWeights::is_in_place(double (&off)[3]) const {
    double mean = 0;
    std::fill_n(off, 3, 0.0);
    for (std::size_t k = 0; k < weights_.size(); ++k) {
        off[0] += weights_[k] * x_[k].x;
        off[1] += weights_[k] * x_[k].y;
        off[2] += weights_[k] * x_[k].z;
        mean += weights_[k] * x_[k].largest;
    }
    return max_magnitude(off[0], off[1], off[2]) <= natural_place_error * mean;
}

// Corrects the weights, since rounding errors of distant circumcentres may add up to more than is
// allowed. Multiplying the weights by 1 + x . y moves the mean from `off` to off + M y, where M is
// the sum of the weights times x x^T. Returns false if a weight would change too much.
bool NaturalWeights::correct(const double (&off)[3]) {
    double m[6] = {};
    for (std::size_t k = 0; k < weights_.size(); ++k) {
        const LocalVertex& v = x_[k];
        const double wx = weights_[k] * v.x, wy = weights_[k] * v.y;
        m[0] += wx * v.x;
        m[1] += wx * v.y;
        m[2] += wx * v.z;
        m[3] += wy * v.y;
        m[4] += wy * v.z;
        m[5] += weights_[k] * v.z * v.z;
    }
    // The adjugate of M, which is symmetric.
    const double a = m[3] * m[5] - m[4] * m[4], b = m[2] * m[4] - m[1] * m[5],
                 c = m[1] * m[4] - m[2] * m[3], d = m[0] * m[5] - m[2] * m[2],
                 e = m[1] * m[2] - m[0] * m[4], f = m[0] * m[3] - m[1] * m[1];
    const double minus_inverse = -1 / (m[0] * a + m[1] * b + m[2] * c);
    const double y[3] = {(a * off[0] + b * off[1] + c * off[2]) * minus_inverse,
                         (b * off[0] + d * off[1] + e * off[2]) * minus_inverse,
                         (c * off[0] + e * off[1] + f * off[2]) * minus_inverse};
    for (std::size_t k = 0; k < weights_.size(); ++k) {
        const double more = x_[k].x * y[0] + x_[k].y * y[1] + x_[k].z * y[2];
        if (!(std::fabs(more) < 0.01 * natural_weight_error)) return false;
        weights_[k] += weights_[k] * more;
    }
    normalize();
    return true;
}

// Computes the circumcentres relative to the place. Returns false if the error of one of them
// has no known bound.
bool NaturalWeights::set_centers(const Mesh& mesh, const PlaceStar& star, Natural natural) {
    // Shorter vectors are not used, because a product of five of their coordinates may underflow.
    constexpr double least = 0x1p-190;
    const std::size_t removed = star.removed().size(), created = star.created().size();
    centers_.clear();
    centers_.resize(removed + created);
    const auto set = [](const LocalVertex& a, const LocalVertex& b, const LocalVertex& c,
                        bool is_odd, Sphere& s) {
        if (!(std::min(std::min(a.largest, b.largest), c.largest) > least)) return false;
        if (is_odd)
            set_sphere(a, c, b, s);
        else
            set_sphere(a, b, c, s);
        return s.e < infinity;
    };
    Sphere s;
    for (std::size_t i = 0; i < (natural == Natural::sibson ? removed : 0); ++i) {
        const PlaceStar::Removed& r = star.removed()[i];
        const double* const base = mesh.point(star.vertex(r.corner[0]));
        LocalVertex side[3];
        for (unsigned k = 0; k < 3; ++k) {
            const double* const p = mesh.point(star.vertex(r.corner[k + 1]));
            side[k] = local_vertex((p[0] - base[0]) * factor_, (p[1] - base[1]) * factor_,
                                   (p[2] - base[2]) * factor_);
        }
        if (!set(side[0], side[1], side[2], r.is_odd, s)) return false;
        const LocalVertex& x = x_[r.corner[0]];
        Center& c = centers_[i];
        c.x[0] = x.x + 0.5 * s.w[0];
        c.x[1] = x.y + 0.5 * s.w[1];
        c.x[2] = x.z + 0.5 * s.w[2];
        c.size = max_magnitude(c.x[0], c.x[1], c.x[2]);
        c.error = 0.5 * s.e + u * (x.largest + c.size);
    }
    for (std::size_t i = 0; i < created; ++i) {
        const PlaceStar::Created& t = star.created()[i];
        if (!set(x_[t.corner[0]], x_[t.corner[1]], x_[t.corner[2]], t.is_odd, s)) return false;
        Center& c = centers_[removed + i];
        for (unsigned k = 0; k < 3; ++k) c.x[k] = 0.5 * s.w[k];
        c.size = max_magnitude(c.x[0], c.x[1], c.x[2]);
        c.error = 0.5 * s.e;
    }
    return true;
}

void NaturalWeights::set_corrected_centers(const Mesh& mesh, const PlaceStar& star, const double* q,
                                           Natural natural) {
    const std::size_t removed = star.removed().size(), created = star.created().size();
    centers_.clear();
    centers_.resize(removed + created);
    const auto point = [&](PlaceStar::Number k) { return mesh.point(star.vertex(k)); };
    const auto set = [&](const double* base, const PlaceStar::Number* corner, bool is_odd,
                         const LocalVertex* from, Center& c) {
        double offset[3];
        center_offset(
            {base, point(corner[0]), point(corner[is_odd ? 2 : 1]), point(corner[is_odd ? 1 : 2])},
            offset);
        for (double& x : offset) x *= factor_;
        const double length = max_magnitude(offset[0], offset[1], offset[2]);
        c.x[0] = from ? from->x + offset[0] : offset[0];
        c.x[1] = from ? from->y + offset[1] : offset[1];
        c.x[2] = from ? from->z + offset[2] : offset[2];
        c.size = max_magnitude(c.x[0], c.x[1], c.x[2]);
        c.error = center_offset_error * length + (from ? u * (from->largest + c.size) : 0);
    };
    for (std::size_t i = 0; i < (natural == Natural::sibson ? removed : 0); ++i) {
        const PlaceStar::Removed& r = star.removed()[i];
        set(point(r.corner[0]), r.corner + 1, r.is_odd, &x_[r.corner[0]], centers_[i]);
    }
    for (std::size_t i = 0; i < created; ++i) {
        const PlaceStar::Created& t = star.created()[i];
        set(q, t.corner, t.is_odd, nullptr, centers_[removed + i]);
    }
}

bool NaturalWeights::in_doubles(const Mesh& mesh, const PlaceStar& star, const double* q,
                                Natural natural, bool is_corrected) {
    const PlaceStar::Number n = star.size();
    x_.clear();
    x_.resize(n);
    for (PlaceStar::Number k = 0; k < n; ++k) {
        const double* const p = mesh.point(star.vertex(k));
        x_[k] =
            local_vertex((p[0] - q[0]) * factor_, (p[1] - q[1]) * factor_, (p[2] - q[2]) * factor_);
    }
    if (is_corrected)
        set_corrected_centers(mesh, star, q, natural);
    else if (!set_centers(mesh, star, natural))
        return false;
    double largest = 0;
    const std::size_t first = natural == Natural::sibson ? 0 : star.removed().size();
    for (std::size_t i = first; i < centers_.size(); ++i)
        largest = std::max(largest, centers_[i].size + centers_[i].error);
    if (!(largest < 0x1p200)) return false;
    // Coordinates are below 2, so a term is below 24 largest^2. The sum of a vertex is 12 times a
    // part of the place's cell. The cell is in a cube with edges of length 2 largest, so the sum is
    // also below 96 largest^3. Intermediate sums may overflow, but they wrap around, so the final
    // sum is right.
    const std::size_t terms = star.old_facets().size() + star.new_facets().size();
    const int exponent = std::ilogb(largest) + 1, of_term = 5 + 2 * exponent,
              of_whole = std::min(of_term + static_cast<int>(bit_width(terms)), 7 + 3 * exponent);
    const double one = std::ldexp(1.0, 62 - std::max(of_term, of_whole));
    const bool is_sibson = natural == Natural::sibson;
    sums_.clear();
    sums_.resize(n, 0);
    double error = 0;
    // `span` is the sum of the magnitudes of the differences that multiply the cross product.
    // `reach` is the distance of the corners.
    const auto cross_of = [&](std::uint32_t near, std::uint32_t beyond, bool is_odd, double span,
                              double reach, double(&x)[3]) {
        const Center &a = centers_[near], &b = centers_[beyond];
        const double to_units = is_odd == is_sibson ? one : -one;
        x[0] = (a.x[1] * b.x[2] - a.x[2] * b.x[1]) * to_units;
        x[1] = (a.x[2] * b.x[0] - a.x[0] * b.x[2]) * to_units;
        x[2] = (a.x[0] * b.x[1] - a.x[1] * b.x[0]) * to_units;
        const double size = u * (a.size * b.size);
        error += span * (2 * (a.error * (b.size + b.error) + b.error * a.size) + 13 * size) +
                 40 * (reach * size);
    };
    const auto give = [&](std::uint32_t to, const double* x, const double* d) {
        const double term = (x[0] * d[0] + x[1] * d[1]) + x[2] * d[2];
        sums_[to] += static_cast<std::uint64_t>(static_cast<std::int64_t>(term));
    };
    const auto length = [](const double* d) {
        return std::fabs(d[0]) + std::fabs(d[1]) + std::fabs(d[2]);
    };
    double x[3];
    if (is_sibson)
        for (const auto& f : star.old_facets()) {
            const LocalVertex &i = x_[f.corner[0]], &j = x_[f.corner[1]], &k = x_[f.corner[2]];
            const double to_i[3] = {j.x - k.x, j.y - k.y, j.z - k.z},
                         to_j[3] = {k.x - i.x, k.y - i.y, k.z - i.z},
                         to_k[3] = {i.x - j.x, i.y - j.y, i.z - j.z};
            cross_of(f.near, f.beyond, f.is_odd, length(to_i) + length(to_j) + length(to_k),
                     std::max({i.largest, j.largest, k.largest}), x);
            give(f.corner[0], x, to_i);
            give(f.corner[1], x, to_j);
            give(f.corner[2], x, to_k);
        }
    for (const auto& f : star.new_facets()) {
        const LocalVertex &i = x_[f.corner[0]], &j = x_[f.corner[1]];
        const LocalVertex &first = is_sibson ? j : i, &second = is_sibson ? i : j;
        const double to_i[3] = {-first.x, -first.y, -first.z},
                     to_j[3] = {second.x, second.y, second.z};
        cross_of(f.near, f.beyond, f.is_odd, length(to_i) + length(to_j), 0, x);
        give(f.corner[0], x, to_i);
        give(f.corner[1], x, to_j);
    }
    double total = 0, error_of_all = 0;
    // A bound on the error of all sums together, in units of the integers.
    const double error_of_sums = error * one + 3 * static_cast<double>(terms);
    for (PlaceStar::Number k = 0; k < n; ++k) {
        const double square = is_sibson ? 1 : x_[k].square;
        weights_[k] = static_cast<double>(static_cast<std::int64_t>(sums_[k])) / square;
        total += weights_[k];
        error_of_all = std::max(error_of_all, error_of_sums / square);
    }
    const bool is_known =
        error_of_sums < 0x1p61 && 2.05 * error_of_all < 0.9 * natural_weight_error * total;
    normalize();
    double off[3];
    return is_known && (is_in_place(off) || (correct(off) && is_in_place(off)));
}

}  // namespace mgdt
