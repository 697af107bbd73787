// SPDX-License-Identifier: MIT
#include "voronoi/face_measure.hpp"

#include <algorithm>
#include <limits>

#include "dual/face_sums.hpp"

namespace mgdt {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Products of three lengths in this range are in the range of doubles.
constexpr double least_length = 0x1p-300, most_length = 0x1p300;
// An error of an area that does not matter, in units of the square of the distance between the two
// points.
constexpr double tiny_area = 1e-14;
// The largest accepted relative error of an area in doubles. It is so much below measure_error
// because the errors of all faces of a cell add up.
constexpr double enough_in_doubles = 0.05 * measure_error;
// The relative error that the normal and the result have because they are rounded to doubles. The
// error bounds of sums in doubles include it.
template <class Real>
constexpr double own_error = 0;
template <>
constexpr double own_error<Twofold> = normal_error + 4 * rounding_of<double>;

}  // namespace

FacePlane bisector(const double* a, const double* b) {
    const Vector<double> way = difference<double>(b, a);
    const double size = length(way);
    FacePlane plane;
    plane.normal = (1 / size) * way;
    plane.distance = 0.5 * size;
    plane.distance_error = normal_error * plane.distance;
    plane.spacing = size;
    return plane;
}

namespace {

// Whether the error of the area is below `part` times the area, and that of the centroid below 0.9
// measure_error times the reach. An area of at most tiny_area times the square of the distance
// between the two points always passes, because any of its corners may then serve as its centroid.
bool is_below(const FaceMeasure& m, double part, const FacePlane& plane) {
    if (!(m.area_error < infinite)) return false;
    const double tiny = 0.9 * tiny_area * plane.spacing * plane.spacing;
    if (m.area + m.area_error <= tiny) return true;
    return (m.area_error <= part * m.area || m.area_error <= tiny) &&
           m.centroid_error <= 0.9 * measure_error * m.reach;
}

// docs/theory.md, "Voronoi faces", derives the bounds.
template <class Real>
FaceMeasure measure_in(const double* a, const FacePlane& plane, const SplitPoint* const* corners,
                       std::size_t n, double unit) {
    constexpr double u = rounding_of<Real>;
    FaceMeasure result = {0, infinite, {}, infinite, 0, 0, {}};
    double& farthest = result.reach;
    double correction_error = 0, diameter = 0;
    const auto relative = [&](std::size_t i) {
        const SplitPoint& corner = *corners[i];
        Vector<Real> y = difference<Real>(corner.x, a);
        for (int k = 0; k < 3; ++k)
            y.x[k] = y.x[k] + to_real<Real>(static_cast<double>(corner.low[k]) * unit);
        farthest = std::max(farthest, length(y));
        correction_error = std::max(correction_error, static_cast<double>(corner.error));
        return y;
    };
    const Vector<Real> first = relative(0), normal = to_vector<Real>(plane.normal);
    Vector<Real> before = relative(1) - first;
    double length_before = length(before);
    diameter = length_before;
    Real doubled = to_real<Real>(0);
    double lengths = 0, products = 0;
    Vector<Real> moment = to_vector<Real>({});
    for (std::size_t i = 2; i < n; ++i) {
        const Vector<Real> here = relative(i) - first;
        const double length_here = length(here);
        const Real weight = dot(normal, cross(before, here));
        doubled = doubled + weight;
        moment = moment + weight * (before + here);
        lengths += length_before + length_here;
        diameter = std::max(diameter, length_here);
        products += length_before * length_here;
        before = here;
        length_before = length_here;
    }
    if (!(farthest < most_length && plane.distance < most_length &&
          farthest + plane.distance > least_length))
        return result;
    // An upper bound on the distance of each corner from where it should be.
    const double moved = 4 * u * farthest + 2 * correction_error * unit;
    const double count = static_cast<double>(n), sum = nearest_double(doubled);
    const double error = 2 * moved * (lengths + 2 * count * moved) + (24 + count) * u * products +
                         own_error<Real> * std::fabs(sum);
    if (!(error < infinite)) return result;
    result.area = 0.5 * std::max(0.0, sum);
    result.area_error = 0.5 * error;
    diameter += 2 * moved;
    if (error < 0x1p-10 * sum) {
        const Vector<Real> centroid =
            first + (to_real<Real>(1) / (to_real<Real>(3) * doubled)) * moment;
        for (int k = 0; k < 3; ++k) result.centroid.x[k] = nearest_double(centroid.x[k]);
        result.centroid_error =
            4 * moved + 4 * diameter * (error / sum) + own_error<Real> * farthest;
    } else {
        // The face is so small that any of its points can be the centroid.
        for (int k = 0; k < 3; ++k) result.centroid.x[k] = nearest_double(first.x[k]);
        result.centroid_error = diameter;
    }
    return result;
}

}  // namespace

bool is_accurate(const FaceMeasure& measure, const FacePlane& plane) {
    return is_below(measure, 0.9 * measure_error, plane);
}

FaceMeasure measure_face(const double* a, const FacePlane& plane, const SplitPoint* const* corners,
                         std::size_t n, double unit) {
    const FaceMeasure result = measure_in<double>(a, plane, corners, n, unit);
    if (is_below(result, enough_in_doubles, plane)) return result;
    return measure_in<Twofold>(a, plane, corners, n, unit);
}

namespace {

// Computes the result, except for the error of the area, with numbers that bound their errors.
// Returns false if these errors are too large.
template <class Numbers>
bool measure_with(Numbers numbers, Allocator& allocator, HalfSpaces& half_spaces, std::size_t n,
                  int scale, FaceMeasure& result) {
    using B = typename Numbers::B;
    using V = Vector<B>;
    typename Numbers::Array corners = numbers.array(allocator, 3 * n),
                            sums = numbers.array(allocator, 4);  // the moment, and the whole
    WideDouble reach;  // the largest coordinate of a corner, which is at most its distance
    const auto row = [&](std::size_t plane) {
        return half_spaces.row(numbers, static_cast<PlaneNumber>(plane));
    };
    const auto corner = [&](std::size_t i) {
        return V{{corners.get(numbers, 3 * i), corners.get(numbers, 3 * i + 1),
                  corners.get(numbers, 3 * i + 2)}};
    };
    // Corner i is before edge i.
    for (std::size_t i = 0; i < n; ++i) {
        const auto p = row(0), q = row(1 + (i == 0 ? n - 1 : i - 1)), r = row(1 + i);
        const MeetingPoint<B> point = meeting_point(p, q, r);
        const B inverse = numbers.number(1) / point.determinant;
        for (std::size_t k = 0; k < 3; ++k) {
            const B x = point.numerator.x[k] * inverse;
            const WideDouble size = magnitude(x.wide());
            if (reach < size) reach = size;
            corners.set(3 * i + k, x);
        }
        numbers.forget();
    }
    for (std::size_t k = 0; k < 4; ++k) sums.set(k, numbers.number(0));
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const V first = corner(0), before = corner(i) - first, here = corner(i + 1) - first;
        const B weight = dot(row(0).normal, cross(before, here));
        for (std::size_t k = 0; k < 3; ++k)
            sums.set(k, sums.get(numbers, k) + weight * (before.x[k] + here.x[k]));
        sums.set(3, sums.get(numbers, 3) + weight);
        numbers.forget();
    }
    // The area is `along` divided by twice the length of the normal.
    const V normal = row(0).normal;
    const B along = sums.get(numbers, 3);
    const WideDouble squared = dot(normal, normal).wide(), half(0.5),
                     area = half * over_root(along.wide(), squared),
                     error = half * over_root(along.wide_error(), squared);
    // An infinite error fails the comparison.
    const bool is_known = error < magnitude(area) * WideDouble(0.2 * measure_error);
    const WideDouble tiny =
        half_spaces.is_bisector(0) ? WideDouble(0.2 * tiny_area) * squared : WideDouble();
    const auto set = [&](std::size_t k, const WideDouble& x) {
        result.centroid.x[k] = x.in_double();
        result.unscaled_centroid.x[k] = WideDouble(x.mantissa, x.exponent - scale).in_double();
    };
    if (magnitude(area) + error < tiny) {
        for (std::size_t k = 0; k < 3; ++k) set(k, corners.get(numbers, k).wide());
        result.centroid_error = 4 * reach.in_double();
    } else {
        if (!is_known) return false;
        for (std::size_t k = 0; k < 3; ++k) {
            const B x =
                corners.get(numbers, k) + sums.get(numbers, k) / (numbers.number(3) * along);
            if (!(x.wide_error() < reach * WideDouble(0.2 * measure_error))) return false;
            set(k, x.wide());
        }
        result.centroid_error = 0.25 * measure_error * reach.in_double();
    }
    result.reach = reach.in_double();
    result.area = std::max(0.0, area.in_double());
    result.unscaled_area =
        std::max(0.0, WideDouble(area.mantissa, area.exponent - 2 * scale).in_double());
    return true;
}

}  // namespace

FaceMeasure measure_exactly(Allocator& allocator, HalfSpaces& half_spaces, std::size_t n,
                            const FacePlane& plane, int scale) {
    FaceMeasure result = {};
    if (!measure_with(BoundedFloats<double>(), allocator, half_spaces, n, scale, result) &&
        !measure_with(BoundedFloats<Twofold>(), allocator, half_spaces, n, scale, result)) {
        std::size_t limbs = 256 / exact::limb_bits;
        while (
            !measure_with(BoundedLongs(allocator, limbs), allocator, half_spaces, n, scale, result))
            limbs *= 2;
    }
    result.area_error =
        0.25 * (measure_error * result.area + tiny_area * plane.spacing * plane.spacing) +
        std::numeric_limits<double>::min();
    return result;
}

}  // namespace mgdt
