// SPDX-License-Identifier: MIT
#include "dual/half_spaces.hpp"

#include <limits>

namespace mgdt {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double u = rounding_of<double>;
// Products of three lengths within these stay in the range of doubles.
constexpr double least_length = 0x1p-250, most_length = 0x1p250;

using Row = HalfSpaces::Row;
using Numbers3 = LongNumber[3];

LongNumber dot(const Numbers3& a, const Numbers3& b) {
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}
void set_cross(const Numbers3& a, const Numbers3& b, Numbers3& c) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        c[i] = a[j] * b[k] - a[k] * b[j];
    }
}

// The height of the point where p, q and r meet over s, times the determinant of their normals.
LongNumber height_of(const Row& p, const Row& q, const Row& r, const Row& s) {
    LongNumber qr[3], ps[3];
    set_cross(q.normal, r.normal, qr);
    set_cross(p.normal, s.normal, ps);
    return (p.offset * dot(s.normal, qr) - s.offset * dot(p.normal, qr)) +
           (q.offset * dot(r.normal, ps) - r.offset * dot(q.normal, ps));
}

}  // namespace

void HalfSpaces::clear(const double* origin, double factor) {
    origin_ = origin;
    factor_ = factor;
    sources_.clear();
    sides_.clear();
    rows_.clear();
    memory_.release(0);
}

void HalfSpaces::add_nothing() {
    sources_.push_back({nullptr, false, 0});
    sides_.push_back({});
}

void HalfSpaces::add_nearer_side(const double* point) {
    sources_.push_back({point, false, 0});
    Side<double> side;
    side.normal = scaled_by(difference<double>(point, origin_), factor_);
    side.offset = 0.5 * dot(side.normal, side.normal);
    side.size = std::sqrt(2 * side.offset);
    side.error = 5 * u * side.offset;
    if (!(side.size > least_length && side.size < most_length)) side.error = infinity;
    sides_.push_back(side);
}

void HalfSpaces::add_plane(const double* of, int scale) {
    sources_.push_back({of, true, scale});
    const double largest =
        std::fmax(std::fmax(std::fabs(of[0]), std::fabs(of[1])), std::fabs(of[2]));
    // Lengths of normals between 1 and 4.
    const int shift = -std::ilogb(largest);
    Side<double> side;
    Twofold offset = {std::ldexp(of[3], shift + scale), 0};
    double terms = std::fabs(offset.high);
    for (int i = 0; i < 3; ++i) {
        side.normal.x[i] = std::ldexp(of[i], shift);
        offset = offset - Twofold::product(side.normal.x[i], origin_[i]);
        terms += std::fabs(side.normal.x[i] * origin_[i]);
    }
    side.size = length(side.normal);
    side.offset = offset.high * factor_;
    side.error =
        (u * std::fabs(offset.high) + 8 * rounding_of<Twofold> * terms + 0x1p-1000) * factor_;
    if (!(terms < 0x1p900 && terms * factor_ < 0x1p900)) side.error = infinity;
    sides_.push_back(side);
}

void HalfSpaces::set_row(const Source& source, Row& row) {
    if (!source.numbers) return;
    LongNumber at[3];
    for (int i = 0; i < 3; ++i) {
        at[i] = memory_.number(origin_[i]);
        const LongNumber x = memory_.number(source.numbers[i]);
        row.normal[i] = source.is_plane ? x : x - at[i];
    }
    // Half the square of the normal.
    row.offset = source.is_plane
                     ? memory_.number(source.numbers[3], source.scale) - dot(row.normal, at)
                     : dot(row.normal, row.normal) * memory_.number(0.5);
}

void HalfSpaces::prepare() {
    if (rows_.size() == sources_.size()) {
        memory_.release(end_of_rows_);
        return;
    }
    rows_.clear();
    memory_.release(0);
    for (const Source& source : sources_) {
        Row row;
        set_row(source, row);
        rows_.push_back(row);
    }
    end_of_rows_ = memory_.mark();
}

const Row& HalfSpaces::row(PlaneNumber p) {
    prepare();
    return rows_[p];
}

// As far as M, which is larger than every number, is what counts, its offset is 1; else 0.
Row HalfSpaces::far_row(PlaneNumber p, bool is_offset_far) {
    const int axis = static_cast<int>(p - first_far_plane) / 3,
              which = static_cast<int>(p - first_far_plane) % 3;
    Row row;
    if (which < 2)
        row.normal[(axis + 1 + which) % 3] = memory_.number(-1);
    else
        row.normal[(axis + 1) % 3] = row.normal[(axis + 2) % 3] = memory_.number(1);
    if (is_offset_far) row.offset = memory_.number(1);
    return row;
}

Row HalfSpaces::row_of(PlaneNumber p, bool is_far_part) {
    if (is_far(p)) return far_row(p, is_far_part);
    Row row = rows_[p];
    if (is_far_part) row.offset = LongNumber();
    return row;
}

int HalfSpaces::side_of_corner(PlaneNumber p, PlaneNumber q, PlaneNumber r, PlaneNumber s) {
    prepare();
    if (is_far(q) || is_far(r)) {
        const int sign =
            height_of(row_of(p, true), row_of(q, true), row_of(r, true), row_of(s, true)).sign();
        if (sign != 0) return sign;
    }
    return height_of(row_of(p, false), row_of(q, false), row_of(r, false), row_of(s, false)).sign();
}

int HalfSpaces::sign_of_product(PlaneNumber p, PlaneNumber q) {
    prepare();
    return dot(rows_[p].normal, rows_[q].normal).sign();
}

int HalfSpaces::main_axis(PlaneNumber p, int& sign) {
    prepare();
    const Row& row = rows_[p];
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if ((row.normal[i] * row.normal[i] - row.normal[axis] * row.normal[axis]).sign() > 0)
            axis = i;
    sign = row.normal[axis].sign();
    return axis;
}

HalfSpaces::Point HalfSpaces::meeting_point(PlaneNumber p, PlaneNumber q, PlaneNumber r) {
    prepare();
    const Row *const a = &rows_[p], *const b = &rows_[q], *const c = &rows_[r];
    LongNumber bc[3], ca[3], ab[3];
    set_cross(b->normal, c->normal, bc);
    set_cross(c->normal, a->normal, ca);
    set_cross(a->normal, b->normal, ab);
    Point point;
    point.weight = dot(a->normal, bc);
    for (int i = 0; i < 3; ++i)
        point.x[i] = (a->offset * bc[i] + b->offset * ca[i]) + c->offset * ab[i];
    return point;
}

namespace {

// x 2^exponent with a relative error below 2^-104; false where it is not in the range.
bool round_number(const LongNumber& x, std::int64_t exponent, Twofold& r) {
    r = x.twofold(exponent);
    const double size = std::fabs(r.high);
    return x.sign() == 0 || (size > 0x1p-600 && size < 0x1p600);
}

}  // namespace

bool HalfSpaces::round_side(PlaneNumber p, int exponent, Side<Twofold>& side) {
    prepare();
    const Row& row = rows_[p];
    // The normal of a bisector is a length; those of planes have one near 1.
    int of_normal = exponent;
    if (sources_[p].is_plane) {
        const double* const of = sources_[p].numbers;
        of_normal =
            -std::ilogb(std::fmax(std::fmax(std::fabs(of[0]), std::fabs(of[1])), std::fabs(of[2])));
    }
    for (int i = 0; i < 3; ++i)
        if (!round_number(row.normal[i], of_normal, side.normal.x[i])) return false;
    if (!round_number(row.offset, of_normal + exponent, side.offset)) return false;
    side.size = length(side.normal);
    side.error = rounding_of<Twofold> * std::fabs(side.offset.high);
    return side.size > least_length && side.size < most_length;
}

bool HalfSpaces::round_corner(PlaneNumber p, PlaneNumber q, PlaneNumber r, int exponent,
                              bool is_relative, Vector<Twofold>& x) {
    Point point = meeting_point(p, q, r);
    // Three limbs, or a few more of 32 bits, leave out less than 2^-110 of a quotient.
    LongMemory cut_off(rows_.allocator(), 192 / exact::limb_bits);
    const LongNumber weight = cut_off.copy(point.weight);
    for (int i = 0; i < 3; ++i) {
        if (!is_relative) point.x[i] = point.x[i] + point.weight * memory_.number(origin_[i]);
        if (!round_number(cut_off.copy(point.x[i]) / weight, exponent, x.x[i])) return false;
    }
    return true;
}

}  // namespace mgdt
