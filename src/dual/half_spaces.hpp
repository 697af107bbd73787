// SPDX-License-Identifier: MIT
// Numbered half-spaces that bound a cell or a region, with exact decisions about the points where
// three of their planes meet. See docs/theory.md, "Cells".
#pragma once

#include "dual/corner.hpp"
#include "predicates/bounded_numbers.hpp"

namespace mgdt {

using PlaneNumber = std::uint32_t;

// Far planes are farther away than everything else. There are three for each axis, with numbers
// above those of half-spaces. If the normal of a plane has a component along an axis, the three far
// planes of that axis cut a triangle out of the plane.
constexpr PlaneNumber first_far_plane = 0xfffffff0;
constexpr bool is_far(PlaneNumber p) {
    return p >= first_far_plane;
}
constexpr PlaneNumber far_plane(int axis, int which) {
    return first_far_plane + static_cast<PlaneNumber>(3 * axis + which);
}

// The plane normal . x = offset.
template <class Number>
struct PlaneRow {
    Vector<Number> normal;
    Number offset;
};

// The point where three planes meet, by Cramer's rule: the numerators of its coordinates, and the
// determinant of the normals.
template <class Number>
struct MeetingPoint {
    Vector<Number> numerator;
    Number determinant;
};
template <class Number>
MeetingPoint<Number> meeting_point(const PlaneRow<Number>& p, const PlaneRow<Number>& q,
                                   const PlaneRow<Number>& r) {
    const Vector<Number> qr = cross(q.normal, r.normal), rp = cross(r.normal, p.normal),
                         pq = cross(p.normal, q.normal);
    MeetingPoint<Number> point;
    point.determinant = dot(p.normal, qr);
    for (int k = 0; k < 3; ++k)
        point.numerator.x[k] = (p.offset * qr.x[k] + q.offset * rp.x[k]) + r.offset * pq.x[k];
    return point;
}

class HalfSpaces {
  public:
    explicit HalfSpaces(Allocator& allocator)
        : sources_(allocator),
          sides_(allocator),
          in_doubles_(allocator),
          in_twofold_(allocator),
          exact_(allocator),
          memory_(allocator),
          cut_off_(allocator, 192 / exact::limb_bits) {}

    // Removes all half-spaces and sets the origin, whose coordinates must not move while
    // half-spaces refer to them. Lengths in doubles are multiplied by `factor`, a power of two.
    void clear(const double* origin, double factor);
    // Adds the half-space of the points that are nearer to the origin than to `point`. Half-spaces
    // are numbered in the order of the calls. The coordinates must not move.
    void add_nearer_side(const double* point);
    // Adds the half-space normal . x <= offset 2^scale, where x is in absolute coordinates, not
    // relative to the origin. The four numbers must not move.
    void add_plane(const double* normal_and_offset, int scale);

    // The half-space in doubles. The error of the offset is infinite if doubles are too inaccurate
    // or leave their range.
    const Side& side(PlaneNumber p) const noexcept { return sides_[p]; }

    // +1 if the point where the planes p, q and r meet is outside half-space s, 0 on its plane, -1
    // inside. The normals of p, q and r are positively oriented. Planes q and r may be far planes.
    int side_of_corner(PlaneNumber p, PlaneNumber q, PlaneNumber r, PlaneNumber s);
    // The sign of the scalar product of two normals.
    int sign_of_product(PlaneNumber p, PlaneNumber q);
    // The axis of the largest component of a normal, and the sign of that component.
    int main_axis(PlaneNumber p, int& sign);

    // Whether the plane is the bisector between the origin and another point. If so, the normal is
    // the vector from the origin to that point.
    bool is_bisector(PlaneNumber p) const noexcept { return !sources_[p].is_plane; }
    // The plane, relative to the origin, in numbers that carry bounds on their errors.
    template <class Real>
    PlaneRow<BoundedFloat<Real>> row(BoundedFloats<Real>&, PlaneNumber p) {
        prepare<BoundedFloat<Real>>();
        return rows<BoundedFloat<Real>>()[p];
    }
    PlaneRow<BoundedLong> row(BoundedLongs& numbers, PlaneNumber p) const {
        return row_of(numbers, sources_[p]);
    }

    // Computes the point where three planes meet, in absolute coordinates. The relative error of
    // each coordinate is below corner_error. Returns false if a coordinate is outside the range in
    // which twofold numbers are that accurate.
    bool round_corner(PlaneNumber p, PlaneNumber q, PlaneNumber r, Vector<Twofold>& x);
    static constexpr double corner_error = 0x1p-100;
    // Rounds the coordinates of that point times 2^-scale to the nearest doubles.
    void nearest_corner(PlaneNumber p, PlaneNumber q, PlaneNumber r, int scale, double (&x)[3]);

  private:
    struct Source {
        const double* numbers;  // the coordinates of a point, or a normal and an offset
        bool is_plane;
        int scale;
    };
    template <class Numbers>
    PlaneRow<typename Numbers::B> row_of(Numbers& numbers, const Source& source) const;
    // One row per half-space, by number.
    template <class Number>
    Buffer<PlaneRow<Number>>& rows();
    // The point where three planes meet, relative to the origin.
    MeetingPoint<LongNumber> exact_corner(PlaneNumber p, PlaneNumber q, PlaneNumber r);
    // Computes the rows unless they are already there. For long numbers, frees all other numbers in
    // memory_.
    template <class Number>
    void prepare();
    template <class Number>
    Number number(double x);
    template <class Number>
    PlaneRow<Number> far_row(PlaneNumber p, bool is_offset_far);
    template <class Number>
    PlaneRow<Number> any_row(PlaneNumber p, bool is_far_part);
    // The result of side_of_corner(), or 2 if numbers of this type are not accurate enough.
    template <class Number>
    int side_in(PlaneNumber p, PlaneNumber q, PlaneNumber r, PlaneNumber s);

    const double* origin_ = nullptr;
    double factor_ = 1;
    Buffer<Source> sources_;
    Buffer<Side> sides_;
    Buffer<PlaneRow<BoundedFloat<double>>> in_doubles_;
    Buffer<PlaneRow<BoundedFloat<Twofold>>> in_twofold_;
    Buffer<PlaneRow<LongNumber>> exact_;
    LongMemory memory_;
    std::size_t end_of_rows_ = 0;  // where the exact rows end in memory_
    LongMemory cut_off_;           // numbers of 192 bits, for quotients
};

}  // namespace mgdt
