// SPDX-License-Identifier: MIT
#include "dual/exact_measures.hpp"

#include "mesh/scale.hpp"

namespace mgdt {
namespace {

// Sums over the faces, in numbers that carry bounds on their errors.
template <class Numbers>
class BoundedSums {
  public:
    BoundedSums(Allocator& allocator, Numbers& numbers, CellFaces& faces)
        : numbers_(numbers),
          faces_(faces),
          sums_(numbers.array(allocator, 4)),
          corners_(numbers.array(allocator, 3 * faces.corners().size())) {}

    void add(Measure measure);
    bool give(const double* point, int scale, Measure measure, double* x);

  private:
    using B = typename Numbers::B;
    using V = Vector<B>;
    using Row = PlaneRow<B>;

    void set_corners();
    void add_face(const CellFaces::Face& face, Measure measure);
    // Twice the factor by which the normal of the face has to be multiplied to reach the foot of
    // the perpendicular from the vertex to the plane of the face.
    B weight_of(PlaneNumber p, const Row& row) {
        if (faces_.half_spaces().is_bisector(p)) return numbers_.number(1);
        return (row.offset + row.offset) / dot(row.normal, row.normal);
    }
    V corner_before(std::size_t edge) {
        const std::size_t i = 3 * faces_.corner_before(edge);
        return {{corners_.get(numbers_, i), corners_.get(numbers_, i + 1),
                 corners_.get(numbers_, i + 2)}};
    }
    void add_to_sum(std::size_t i, const B& term) { sums_.set(i, sums_.get(numbers_, i) + term); }

    Numbers& numbers_;
    CellFaces& faces_;
    typename Numbers::Array sums_;  // 12 times the volume, 48 times the moment, or twice the area
    typename Numbers::Array corners_;
    WideDouble extent_;
};

// Computes the corners by Cramer's rule.
template <class Numbers>
void BoundedSums<Numbers>::set_corners() {
    HalfSpaces& half_spaces = faces_.half_spaces();
    for (std::size_t i = 0; i < faces_.corners().size(); ++i) {
        const PlaneNumber(&plane)[3] = faces_.corners()[i].plane;
        const Row p = half_spaces.row(numbers_, plane[0]), q = half_spaces.row(numbers_, plane[1]),
                  r = half_spaces.row(numbers_, plane[2]);
        const MeetingPoint<B> point = meeting_point(p, q, r);
        const B inverse = numbers_.number(1) / point.determinant;
        for (std::size_t k = 0; k < 3; ++k) {
            const B x = point.numerator.x[k] * inverse;
            const WideDouble size = magnitude(x.wide());
            if (extent_ < size) extent_ = size;
            corners_.set(3 * i + k, x);
        }
        numbers_.forget();
    }
}

template <class Numbers>
void BoundedSums<Numbers>::add_face(const CellFaces::Face& face, Measure measure) {
    const Row row = faces_.half_spaces().row(numbers_, face.plane);
    const V first = corner_before(face.begin);
    V a = first;
    V doubled_area = cross(a, a);
    const B weight = weight_of(face.plane, row);
    for (std::size_t i = face.begin; i < face.end; ++i) {
        const V b = i + 1 == face.end ? first : corner_before(i + 1), a_cross_b = cross(a, b);
        doubled_area = doubled_area + a_cross_b;
        if (width_of(measure) == 3) {
            const B volume = weight * dot(row.normal, a_cross_b);
            const V middle = numbers_.number(0.5) * weight * row.normal + (a + b);
            for (std::size_t k = 0; k < 3; ++k) add_to_sum(1 + k, volume * middle.x[k]);
        }
        a = b;
    }
    const B along = dot(row.normal, doubled_area);
    if (measure != Measure::area) {
        add_to_sum(0, weight * along);
    } else {
        // Divides by the length of the normal, which gives twice the area.
        const WideDouble length2 = dot(row.normal, row.normal).wide(),
                         area = over_root(along.wide(), length2),
                         error = over_root(along.wide_error(), length2);
        add_to_sum(0, numbers_.number(area, error + WideDouble(0x1p-50) * magnitude(area)));
    }
    numbers_.forget();
}

template <class Numbers>
void BoundedSums<Numbers>::add(Measure measure) {
    set_corners();
    for (std::size_t f = 0; f < faces_.size(); ++f) add_face(faces_.face(f), measure);
}

template <class Numbers>
bool BoundedSums<Numbers>::give(const double* point, int scale, Measure measure, double* x) {
    // Whether a < factor b. The comparison is false if the error is NaN.
    const auto is_below = [](const WideDouble& a, const WideDouble& b, double factor) {
        return a < b * WideDouble(factor);
    };
    const B whole = sums_.get(numbers_, 0);
    const WideDouble value = whole.wide();
    if (!(WideDouble() < value) || !is_below(whole.wide_error(), value, 0.9 * measure_error))
        return false;
    if (measure == Measure::volume) {
        const WideDouble volume = value / WideDouble(12);
        x[0] = WideDouble(volume.mantissa, volume.exponent - 3 * scale).in_double();
    } else if (measure == Measure::area) {
        x[0] = WideDouble(value.mantissa, value.exponent - 1 - 2 * scale).in_double();
    } else {
        for (std::size_t k = 0; k < 3; ++k) {
            const B moment = sums_.get(numbers_, 1 + k);
            if (!is_below(moment.wide_error(), extent_ * value, measure_error)) return false;
            const WideDouble offset = moment.wide() / (value * WideDouble(4)),
                             at = measure == Measure::centroid ? WideDouble(point[k]) + offset
                                                               : offset;
            x[k] = WideDouble(at.mantissa, at.exponent - scale).in_double();
        }
    }
    return true;
}

template <class Numbers>
bool measure_with(Numbers numbers, CellFaces& faces, const double* point, int scale,
                  Measure measure, double* x) {
    BoundedSums<Numbers> sums(faces.corners().allocator(), numbers, faces);
    sums.add(measure);
    return sums.give(point, scale, measure, x);
}

}  // namespace

bool ExactMeasures::measure_in(Stage stage, CellFaces& faces, const double* point, int scale,
                               Measure measure, double* x, std::size_t limbs) {
    switch (stage) {
        case Stage::doubles:
            return measure_with(BoundedFloats<double>(), faces, point, scale, measure, x);
        case Stage::twofold:
            return measure_with(BoundedFloats<Twofold>(), faces, point, scale, measure, x);
        default:
            return measure_with(BoundedLongs(faces.corners().allocator(), limbs), faces, point,
                                scale, measure, x);
    }
}

void ExactMeasures::measure(CellFaces& faces, const double* point, int scale, Measure measure,
                            double* x) {
    if (faces.size() == 0) {
        // If the point is outside the region by rounding, the region may leave nothing of its cell.
        if (measure == Measure::centroid)
            for (int k = 0; k < 3; ++k) x[k] = scaled(point[k], -scale);
        else
            std::fill_n(x, width_of(measure), 0.0);
        return;
    }
    for (const Stage stage : {Stage::doubles, Stage::twofold})
        if (measure_in(stage, faces, point, scale, measure, x)) return;
    // The volume is not 0, so there is a number of limbs that gives it to the wanted accuracy.
    std::size_t limbs = 256 / exact::limb_bits;
    while (!measure_in(Stage::long_numbers, faces, point, scale, measure, x, limbs)) limbs *= 2;
}

}  // namespace mgdt
