// SPDX-License-Identifier: MIT
#include "dual/half_spaces.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "predicates/differences.hpp"

namespace mgdt {
namespace {

// Products of three lengths in this range do not leave the range of doubles.
constexpr double least_length = 0x1p-250, most_length = 0x1p250;

// The height over plane s of the point where p, q and r meet, times the determinant of the normals
// of p, q and r.
template <class Number>
Number height_of(const PlaneRow<Number>& p, const PlaneRow<Number>& q, const PlaneRow<Number>& r,
                 const PlaneRow<Number>& s) {
    const Vector<Number> qr = cross(q.normal, r.normal), ps = cross(p.normal, s.normal);
    return (p.offset * dot(s.normal, qr) - s.offset * dot(p.normal, qr)) +
           (q.offset * dot(r.normal, ps) - r.offset * dot(q.normal, ps));
}

}  // namespace

void HalfSpaces::clear(const double* origin, double factor) {
    origin_ = origin;
    factor_ = factor;
    sources_.clear();
    sides_.clear();
    in_doubles_.clear();
    in_twofold_.clear();
    exact_.clear();
    memory_.release(0);
}

void HalfSpaces::add_nearer_side(const double* point) {
    sources_.push_back({point, false, 0});
    Side side;
    side.normal = scaled_by(difference<double>(point, origin_), factor_);
    side.offset = 0.5 * dot(side.normal, side.normal);
    side.size = std::sqrt(2 * side.offset);
    side.error = 5 * rounding_of<double> * side.offset;
    if (!(side.size > least_length && side.size < most_length))
        side.error = std::numeric_limits<double>::infinity();
    sides_.push_back(side);
}

void HalfSpaces::add_plane(const double* of, int scale) {
    sources_.push_back({of, true, scale});
    const double largest = exact::largest_of<0, 3>(of);
    // Scales normals to lengths between 1 and 4.
    const int shift = -std::ilogb(largest);
    Side side;
    Twofold offset = {std::ldexp(of[3], shift + scale), 0};
    double terms = std::fabs(offset.high);
    for (int i = 0; i < 3; ++i) {
        side.normal.x[i] = std::ldexp(of[i], shift);
        offset = offset - Twofold::product(side.normal.x[i], origin_[i]);
        terms += std::fabs(side.normal.x[i] * origin_[i]);
    }
    side.size = length(side.normal);
    side.offset = offset.high * factor_;
    side.error = (rounding_of<double> * std::fabs(offset.high) + 8 * rounding_of<Twofold> * terms +
                  0x1p-1000) *
                 factor_;
    if (!(terms < 0x1p900 && terms * factor_ < 0x1p900)) {
        side.offset = 0;  // the computed offset may be NaN
        side.error = std::numeric_limits<double>::infinity();
    }
    sides_.push_back(side);
}

template <class Numbers>
PlaneRow<typename Numbers::B> HalfSpaces::row_of(Numbers& numbers, const Source& source) const {
    PlaneRow<typename Numbers::B> row;
    if (!source.is_plane) {
        for (int k = 0; k < 3; ++k)
            row.normal.x[k] = numbers.difference(source.numbers[k], origin_[k]);
        row.offset = numbers.number(0.5) * dot(row.normal, row.normal);
        return row;
    }
    Vector<typename Numbers::B> at;
    for (int k = 0; k < 3; ++k) {
        row.normal.x[k] = numbers.number(source.numbers[k]);
        at.x[k] = numbers.number(origin_[k]);
    }
    row.offset = numbers.number(source.numbers[3], source.scale) - dot(row.normal, at);
    return row;
}
template PlaneRow<BoundedLong> HalfSpaces::row_of(BoundedLongs&, const Source&) const;

template <>
Buffer<PlaneRow<BoundedFloat<double>>>& HalfSpaces::rows<BoundedFloat<double>>() {
    return in_doubles_;
}
template <>
Buffer<PlaneRow<BoundedFloat<Twofold>>>& HalfSpaces::rows<BoundedFloat<Twofold>>() {
    return in_twofold_;
}
template <>
Buffer<PlaneRow<LongNumber>>& HalfSpaces::rows<LongNumber>() {
    return exact_;
}

template <>
void HalfSpaces::prepare<BoundedFloat<Twofold>>() {
    if (in_twofold_.size() == sources_.size()) return;
    BoundedFloats<Twofold> numbers;
    in_twofold_.clear();
    for (const Source& source : sources_) in_twofold_.push_back(row_of(numbers, source));
}
// Converts twofold numbers to doubles. If a plane of the region is much closer to the origin than
// the coordinates are large, computing in doubles would lose the offset of the plane.
template <>
void HalfSpaces::prepare<BoundedFloat<double>>() {
    if (in_doubles_.size() == sources_.size()) return;
    prepare<BoundedFloat<Twofold>>();
    in_doubles_.clear();
    for (const PlaneRow<BoundedFloat<Twofold>>& row : in_twofold_) {
        PlaneRow<BoundedFloat<double>> rounded;
        for (int k = 0; k < 3; ++k) rounded.normal.x[k] = narrowed(row.normal.x[k]);
        rounded.offset = narrowed(row.offset);
        in_doubles_.push_back(rounded);
    }
}
template <>
void HalfSpaces::prepare<LongNumber>() {
    if (exact_.size() == sources_.size()) return memory_.release(end_of_rows_);
    // Numbers of unlimited length.
    struct Exact {
        using B = LongNumber;
        LongMemory& memory;
        B number(double x, std::int64_t exponent = 0) { return memory.number(x, exponent); }
        B difference(double a, double b) { return number(a) - number(b); }
    } numbers = {memory_};
    exact_.clear();
    memory_.release(0);
    for (const Source& source : sources_) exact_.push_back(row_of(numbers, source));
    end_of_rows_ = memory_.mark();
}

template <class Number>
Number HalfSpaces::number(double x) {
    if constexpr (std::is_same_v<Number, LongNumber>)
        return memory_.number(x);
    else
        return Number::number(x);
}

// The row of a far plane, whose offset is M, a number larger than all others. If is_offset_far is
// true, the offset in the row is the coefficient of M, which is 1. Otherwise the offset is the part
// without M, which is 0.
template <class Number>
PlaneRow<Number> HalfSpaces::far_row(PlaneNumber p, bool is_offset_far) {
    const int axis = static_cast<int>(p - first_far_plane) / 3,
              which = static_cast<int>(p - first_far_plane) % 3;
    PlaneRow<Number> row = {};
    if (which < 2)
        row.normal.x[(axis + 1 + which) % 3] = number<Number>(-1);
    else
        row.normal.x[(axis + 1) % 3] = row.normal.x[(axis + 2) % 3] = number<Number>(1);
    if (is_offset_far) row.offset = number<Number>(1);
    return row;
}

template <class Number>
PlaneRow<Number> HalfSpaces::any_row(PlaneNumber p, bool is_far_part) {
    if (is_far(p)) return far_row<Number>(p, is_far_part);
    PlaneRow<Number> row = rows<Number>()[p];
    if (is_far_part) row.offset = Number{};
    return row;
}

template <class Number>
int HalfSpaces::side_in(PlaneNumber p, PlaneNumber q, PlaneNumber r, PlaneNumber s) {
    prepare<Number>();
    if (is_far(q) || is_far(r)) {
        const int sign = height_of(any_row<Number>(p, true), any_row<Number>(q, true),
                                   any_row<Number>(r, true), any_row<Number>(s, true))
                             .sign();
        if (sign != 0) return sign;
    }
    return height_of(any_row<Number>(p, false), any_row<Number>(q, false),
                     any_row<Number>(r, false), any_row<Number>(s, false))
        .sign();
}

int HalfSpaces::side_of_corner(PlaneNumber p, PlaneNumber q, PlaneNumber r, PlaneNumber s) {
    int side = side_in<BoundedFloat<double>>(p, q, r, s);
    if (side == 2) side = side_in<BoundedFloat<Twofold>>(p, q, r, s);
    return side == 2 ? side_in<LongNumber>(p, q, r, s) : side;
}

int HalfSpaces::sign_of_product(PlaneNumber p, PlaneNumber q) {
    prepare<LongNumber>();
    return dot(exact_[p].normal, exact_[q].normal).sign();
}

int HalfSpaces::main_axis(PlaneNumber p, int& sign) {
    prepare<BoundedFloat<Twofold>>();
    // Differences of two doubles are exact in twofold numbers.
    const Vector<BoundedFloat<Twofold>>& normal = in_twofold_[p].normal;
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (magnitude(normal.x[axis].wide()) < magnitude(normal.x[k].wide())) axis = k;
    sign = normal.x[axis].sign();
    return axis;
}

MeetingPoint<LongNumber> HalfSpaces::exact_corner(PlaneNumber p, PlaneNumber q, PlaneNumber r) {
    prepare<LongNumber>();
    return meeting_point(exact_[p], exact_[q], exact_[r]);
}

bool HalfSpaces::round_corner(PlaneNumber p, PlaneNumber q, PlaneNumber r, Vector<Twofold>& x) {
    const MeetingPoint<LongNumber> corner = exact_corner(p, q, r);
    // The numerators and the determinant are cut off to 192 bits. The relative error of a quotient
    // is then below 2^-110.
    cut_off_.release(0);
    const LongNumber weight = cut_off_.copy(corner.determinant);
    for (int k = 0; k < 3; ++k) {
        const LongNumber at = corner.numerator.x[k] +
                              corner.determinant * memory_.number(origin_[k]),
                         rounded = cut_off_.copy(at) / weight;
        x.x[k] = rounded.twofold();
        const double size = std::fabs(x.x[k].high);
        if (rounded.sign() != 0 && !(size > 0x1p-600 && size < 0x1p600)) return false;
    }
    return true;
}

void HalfSpaces::nearest_corner(PlaneNumber p, PlaneNumber q, PlaneNumber r, int scale,
                                double (&x)[3]) {
    const MeetingPoint<LongNumber> corner = exact_corner(p, q, r);
    const LongNumber& weight = corner.determinant;
    cut_off_.release(0);
    for (int k = 0; k < 3; ++k) {
        const LongNumber at = (corner.numerator.x[k] + weight * memory_.number(origin_[k])) *
                              memory_.number(1, -scale);
        // The quotient, cut off to doubles, is off by at most one double. The sign of a midpoint's
        // distance from the quotient decides between two doubles.
        x[k] = (cut_off_.copy(at) / cut_off_.copy(weight)).wide().in_double();
        const int beyond = (at - weight * memory_.number(x[k])).sign() * weight.sign();
        if (beyond == 0) continue;
        const double other = std::nextafter(x[k], beyond * std::numeric_limits<double>::infinity());
        if (std::isinf(other)) continue;
        const LongNumber middle = memory_.number(x[k], -1) + memory_.number(other, -1);
        const int side = (at - weight * middle).sign() * weight.sign() * beyond;
        std::int64_t bits;
        std::memcpy(&bits, &x[k], sizeof bits);
        if (side > 0 || (side == 0 && (bits & 1) != 0)) x[k] = other;
    }
}

}  // namespace mgdt
