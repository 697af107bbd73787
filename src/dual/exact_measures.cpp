// SPDX-License-Identifier: MIT
#include "dual/exact_measures.hpp"

#include <limits>

#include "mesh/scale.hpp"
#include "predicates/bounded.hpp"

namespace mgdt {

template <Measure M>
bool ExactMeasures::add_twofold(CellFaces& faces, int exponent) {
    HalfSpaces& half_spaces = faces.half_spaces();
    sums_.clear();
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const CellFaces::Face& face = faces.face(f);
        Side<Twofold> plane, before, after;
        if (!half_spaces.round_side(face.plane, exponent, plane)) return false;
        if (!half_spaces.round_side(faces.edge(face.end - 1), exponent, before)) return false;
        corners_.clear();
        for (std::size_t i = face.begin; i < face.end; ++i) {
            if (!half_spaces.round_side(faces.edge(i), exponent, after)) return false;
            Corner<Twofold> corner;
            if (!meet(plane, before, after, corner)) {
                const PlaneNumber edge_before = faces.edge(i == face.begin ? face.end - 1 : i - 1);
                if (!half_spaces.round_corner(face.plane, edge_before, faces.edge(i), exponent,
                                              true, corner.x))
                    return false;
                corner.size = length(corner.x);
                corner.error = 2 * HalfSpaces::corner_error * corner.size;
                corner.is_ideal = false;
            }
            corners_.push_back(corner);
            sums_.reach(corner.size);
            before = after;
        }
        const auto of_sums = FaceSums<Twofold>::face_in_plane(plane);
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const Corner<Twofold>&a = corners_[i],
                  &b = corners_[i + 1 == corners_.size() ? 0 : i + 1];
            sums_.add_edge<M>(of_sums, a, b, cross(a.x, b.x));
        }
    }
    return sums_.is_sure<M>();
}

bool ExactMeasures::in_twofold(CellFaces& faces, const double* point, int scale, int exponent,
                               Measure measure, double* x) {
    const int back = -(exponent + scale);
    switch (measure) {
        case Measure::volume:
            if (!add_twofold<Measure::volume>(faces, exponent)) return false;
            x[0] = std::ldexp(sums_.volume(), 3 * back);
            return true;
        case Measure::area:
            if (!add_twofold<Measure::area>(faces, exponent)) return false;
            x[0] = std::ldexp(sums_.area(), 2 * back);
            return true;
        default:
            if (!add_twofold<Measure::centroid>(faces, exponent)) return false;
            for (int k = 0; k < 3; ++k)
                x[k] = scaled(point[k] + std::ldexp(sums_.centroid(k), -exponent), -scale);
            return true;
    }
}

namespace {

// A double with an exponent of its own: of a number that may be beyond the range of doubles.
struct WideDouble {
    double mantissa;
    std::int64_t exponent;
};

template <int Bits>
WideDouble wide(LongFloat<Bits> x) {
    const std::int64_t exponent = x.exponent;
    x.exponent = 0;
    return {x.in_double(), exponent};
}

template <int Bits>
LongFloat<Bits> long_float(const WideDouble& x) {
    LongFloat<Bits> r(x.mantissa);
    r.exponent += x.exponent;
    return r;
}

// x / sqrt(y), y being above 0; with a few roundings.
WideDouble over_root(const WideDouble& x, const WideDouble& y) {
    const bool is_odd = y.exponent % 2 != 0;
    const double root = std::sqrt(is_odd ? 2 * y.mantissa : y.mantissa);
    return {x.mantissa / root, x.exponent - (y.exponent - is_odd) / 2};
}

// The sums over the faces in numbers that bound their own errors.
template <int Bits>
class LongSums {
  public:
    using L = LongFloat<Bits>;
    using B = Bounded<L>;
    using V = Vector<B>;

    explicit LongSums(Allocator& allocator) : corners_(allocator) {
        for (B& sum : sums_) sum = number(0);
    }
    void add(CellFaces& faces, const CellFaces::Face& face, Measure measure);
    bool give(const double* point, int scale, Measure measure, double* x) const;

  private:
    using Bound = typename B::Bound;
    static B number(double x) { return {L(x), Bound()}; }
    static B rounded(const ExactNumber& x) {
        return B::rounded(x.template rounded<Bits>(), Bound());
    }
    static bool is_below(const Bound& a, const Bound& b, double factor) {
        return !(b * Bound(factor) < a);
    }

    B sums_[4];  // 12 times the volume and the moment; or twice the area
    Bound extent_;
    Buffer<V> corners_;
};

template <int Bits>
void LongSums<Bits>::add(CellFaces& faces, const CellFaces::Face& face, Measure measure) {
    HalfSpaces& half_spaces = faces.half_spaces();
    corners_.clear();
    for (std::size_t i = face.begin; i < face.end; ++i) {
        const HalfSpaces::Point exact = half_spaces.meeting_point(
            face.plane, faces.edge(i == face.begin ? face.end - 1 : i - 1), faces.edge(i));
        const B weight = rounded(exact.weight);
        V corner;
        for (int k = 0; k < 3; ++k) {
            corner.x[k] = rounded(exact.x[k]) / weight;
            const Bound size = corner.x[k].magnitude();
            if (extent_ < size) extent_ = size;
        }
        corners_.push_back(corner);
    }
    const HalfSpaces::Row& row = half_spaces.row(face.plane);
    const V normal = {{rounded(row.normal[0]), rounded(row.normal[1]), rounded(row.normal[2])}};
    const B square = dot(normal, normal), twice_over_square = number(2) / square,
            weight = rounded(row.offset) * twice_over_square;
    B doubled_area = number(0);  // times the length of the normal
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const V &a = corners_[i], &b = corners_[i + 1 == corners_.size() ? 0 : i + 1];
        const B along = dot(normal, cross(a, b));
        doubled_area = doubled_area + along;
        if (measure != Measure::centroid) continue;
        const B volume = weight * along;
        for (int k = 0; k < 3; ++k)
            sums_[1 + k] =
                sums_[1 + k] + volume * (number(0.5) * weight * normal.x[k] + (a.x[k] + b.x[k]));
    }
    if (measure != Measure::area) {
        sums_[0] = sums_[0] + weight * doubled_area;
        return;
    }
    const WideDouble length2 = wide(square.value);
    const auto term = [&](const L& x) { return long_float<Bits>(over_root(wide(x), length2)); };
    Bound error = doubled_area.error;
    L of_error(0.0);
    for (int i = 0; i < error.size; ++i)
        of_error.limb[of_error.size - error.size + i] = error.limb[i];
    of_error.exponent = error.exponent;
    const B area = {term(doubled_area.value),
                    BoundsOf<L>::magnitude(term(of_error)) * Bound(1 + 0x1p-30)};
    sums_[0] = sums_[0] + area;
}

template <int Bits>
bool LongSums<Bits>::give(const double* point, int scale, Measure measure, double* x) const {
    const B& whole = sums_[0];
    bool is_sure = whole.value.is_zero() || whole.value.is_negative
                       ? false
                       : is_below(whole.error, whole.magnitude(), 0.9 * measure_error);
    const auto in_double = [](L value, std::int64_t exponent) {
        value.exponent += exponent;
        return value.is_negative ? 0.0 : value.in_double();
    };
    if (measure == Measure::volume) {
        x[0] = in_double(whole.value * (L(1.0) / L(12.0)), -3 * std::int64_t{scale});
    } else if (measure == Measure::area) {
        x[0] = in_double(whole.value * L(0.5), -2 * std::int64_t{scale});
    } else {
        const L inverse = L(1.0) / (whole.value * L(4.0));
        for (int k = 0; k < 3; ++k) {
            is_sure &= is_below(sums_[1 + k].error, extent_ * whole.magnitude(), measure_error);
            L offset = sums_[1 + k].value * inverse;
            // Beyond what these numbers can tell, the vertex is a point of the cell.
            if (!is_sure && extent_ < BoundsOf<L>::magnitude(offset)) offset = L(0.0);
            L at = L(point[k]) + offset;
            at.exponent -= scale;
            x[k] = at.in_double();
        }
    }
    return is_sure;
}

}  // namespace

template <int Bits>
bool ExactMeasures::in_long(CellFaces& faces, const double* point, int scale, Measure measure,
                            double* x) {
    LongSums<Bits> sums(corners_.allocator());
    for (std::size_t f = 0; f < faces.size(); ++f) sums.add(faces, faces.face(f), measure);
    return sums.give(point, scale, measure, x);
}
template bool ExactMeasures::in_long<512>(CellFaces&, const double*, int, Measure, double*);
template bool ExactMeasures::in_long<2048>(CellFaces&, const double*, int, Measure, double*);

void ExactMeasures::measure(CellFaces& faces, const double* point, int scale, Measure measure,
                            double* x) {
    if (faces.size() == 0) {
        // The region may leave nothing of a cell of a point that is outside by rounding.
        if (measure == Measure::centroid)
            for (int k = 0; k < 3; ++k) x[k] = scaled(point[k], -scale);
        else
            x[0] = 0;
        return;
    }
    const int exponent = faces.exponent();
    if (in_twofold(faces, point, scale, exponent, measure, x)) return;
    if (in_long<512>(faces, point, scale, measure, x)) return;
    in_long<2048>(faces, point, scale, measure, x);
}

}  // namespace mgdt
