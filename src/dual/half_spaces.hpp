// SPDX-License-Identifier: MIT
// Half-spaces that bound a cell or a region, with numbers, and exact decisions about the points
// where three of their planes meet. docs/theory.md, "Cells".
#pragma once

#include "dual/corner.hpp"
#include "predicates/bounded_numbers.hpp"

namespace mgdt {

using PlaneNumber = std::uint32_t;

// Beyond the numbers of half-spaces: planes that are farther away than everything, three for each
// axis. With an axis along which a plane's normal has an extent, they cut a triangle out of that
// plane.
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

class HalfSpaces {
  public:
    explicit HalfSpaces(Allocator& allocator)
        : sources_(allocator),
          sides_(allocator),
          in_doubles_(allocator),
          in_twofold_(allocator),
          exact_(allocator),
          memory_(allocator) {}

    // Begins anew. The origin is a point that stays where it is. Approximate lengths are multiplied
    // by `factor`, a power of two.
    void clear(const double* origin, double factor);
    // Each gets the next number. What is nearer to the origin than to this point, which stays.
    void add_nearer_side(const double* point);
    // normal . x <= offset 2^scale, where x is not relative to the origin. The four numbers stay.
    void add_plane(const double* normal_and_offset, int scale);

    // Rounded. The error of the offset is infinite where doubles are of no use.
    const Side& side(PlaneNumber p) const noexcept { return sides_[p]; }

    // +1 where the point in which the planes p, q and r meet is outside the half-space s, 0 on its
    // plane, -1 inside. The normals of p, q and r are positively oriented. Planes q and r may be
    // far.
    int side_of_corner(PlaneNumber p, PlaneNumber q, PlaneNumber r, PlaneNumber s);
    // Sign of the scalar product of two normals.
    int sign_of_product(PlaneNumber p, PlaneNumber q);
    // The axis along which a normal has its largest extent, and the sign of that.
    int main_axis(PlaneNumber p, int& sign);

    // Whether the plane is halfway between the origin and another point, which is its normal then.
    bool is_bisector(PlaneNumber p) const noexcept { return !sources_[p].is_plane; }
    // In numbers with bounds, relative to the origin.
    template <class Real>
    PlaneRow<BoundedFloat<Real>> row(BoundedFloats<Real>&, PlaneNumber p) {
        prepare<BoundedFloat<Real>>();
        return rows<BoundedFloat<Real>>()[p];
    }
    PlaneRow<BoundedLong> row(BoundedLongs& numbers, PlaneNumber p) const {
        return row_of(numbers, sources_[p]);
    }

    // The point where three planes meet, rounded, not relative to the origin. The error is relative
    // to each coordinate, below corner_error; false where twofold numbers do not hold it.
    bool round_corner(PlaneNumber p, PlaneNumber q, PlaneNumber r, Vector<Twofold>& x);
    static constexpr double corner_error = 0x1p-100;

  private:
    struct Source {
        const double* numbers;  // a point, or a normal and an offset
        bool is_plane;
        int scale;
    };
    template <class Numbers>
    PlaneRow<typename Numbers::B> row_of(Numbers& numbers, const Source& source) const;
    // Rows of all half-spaces in the order of their numbers.
    template <class Number>
    Buffer<PlaneRow<Number>>& rows();
    // Finds the rows, if they are not there yet, and forgets other exact numbers.
    template <class Number>
    void prepare();
    template <class Number>
    Number number(double x);
    template <class Number>
    PlaneRow<Number> far_row(PlaneNumber p, bool is_offset_far);
    template <class Number>
    PlaneRow<Number> any_row(PlaneNumber p, bool is_far_part);
    // 2 where the numbers do not tell it.
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
    std::size_t end_of_rows_ = 0;  // in memory_
};

}  // namespace mgdt
