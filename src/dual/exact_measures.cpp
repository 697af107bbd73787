// SPDX-License-Identifier: MIT
#include "dual/exact_measures.hpp"

#include <limits>

#include "mesh/scale.hpp"
#include "predicates/bounded_long.hpp"

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

// x / sqrt(y), y being above 0; with a few roundings.
WideDouble over_root(const WideDouble& x, const WideDouble& y) {
    const bool is_odd = y.exponent % 2 != 0;
    const double root = std::sqrt(is_odd ? 2 * y.mantissa : y.mantissa);
    return WideDouble(x.mantissa / root, x.exponent - (y.exponent - is_odd) / 2);
}

// The sums over the faces in numbers that bound their own errors.
class LongSums {
  public:
    LongSums(Allocator& allocator, std::size_t limbs)
        : memory_(allocator, limbs), sums_(allocator, 4, limbs), corners_(allocator) {}

    void add(CellFaces& faces, const CellFaces::Face& face, Measure measure);
    bool give(const double* point, int scale, Measure measure, double* x);

  private:
    using B = BoundedLong;
    using V = Vector<B>;

    B number(double x) { return {memory_.number(x), {}}; }
    B rounded(const LongNumber& x) { return B::rounded(memory_.copy(x), {}); }
    B sum(std::size_t i) { return {memory_.copy(sums_[i]), errors_[i]}; }
    void add_to_sum(std::size_t i, const B& term) {
        const B all = sum(i) + term;
        sums_.set(i, all.value);
        errors_[i] = all.error;
    }

    LongMemory memory_;
    LongNumbers sums_;  // twelve times the volume and the moment, or twice the area
    WideDouble errors_[4];
    WideDouble extent_;
    Buffer<V> corners_;
};

void LongSums::add(CellFaces& faces, const CellFaces::Face& face, Measure measure) {
    HalfSpaces& half_spaces = faces.half_spaces();
    memory_.release(0);
    corners_.clear();
    for (std::size_t i = face.begin; i < face.end; ++i) {
        const HalfSpaces::Point exact = half_spaces.meeting_point(
            face.plane, faces.edge(i == face.begin ? face.end - 1 : i - 1), faces.edge(i));
        const B weight = rounded(exact.weight);
        V corner;
        for (int k = 0; k < 3; ++k) {
            corner.x[k] = rounded(exact.x[k]) / weight;
            const WideDouble size = magnitude(corner.x[k].wide());
            if (extent_ < size) extent_ = size;
        }
        corners_.push_back(corner);
    }
    const HalfSpaces::Row& row = half_spaces.row(face.plane);
    const V normal = {{rounded(row.normal[0]), rounded(row.normal[1]), rounded(row.normal[2])}};
    const B square = dot(normal, normal), weight = rounded(row.offset) * (number(2) / square);
    const std::size_t mark = memory_.mark();
    B doubled_area = number(0);  // times the length of the normal
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const V &a = corners_[i], &b = corners_[i + 1 == corners_.size() ? 0 : i + 1];
        const B along = dot(normal, cross(a, b));
        if (measure == Measure::area) {
            doubled_area = doubled_area + along;
            continue;
        }
        const B volume = weight * along;
        add_to_sum(0, volume);
        if (measure == Measure::centroid)
            for (std::size_t k = 0; k < 3; ++k)
                add_to_sum(1 + k,
                           volume * (number(0.5) * weight * normal.x[k] + (a.x[k] + b.x[k])));
        memory_.release(mark);
    }
    if (measure != Measure::area) return;
    const WideDouble length2 = square.value.wide(),
                     area = over_root(doubled_area.value.wide(), length2),
                     error = over_root(doubled_area.error, length2);
    add_to_sum(0, {memory_.number(area.mantissa, area.exponent), error * WideDouble(1 + 0x1p-30)});
}

bool LongSums::give(const double* point, int scale, Measure measure, double* x) {
    const auto is_below = [](const WideDouble& a, const WideDouble& b, double factor) {
        return !(b * WideDouble(factor) < a);
    };
    memory_.release(0);
    const B whole = sum(0);
    if (whole.value.sign() <= 0 ||
        !is_below(whole.error, magnitude(whole.wide()), 0.9 * measure_error))
        return false;
    const WideDouble value = whole.value.wide();
    if (measure == Measure::volume) {
        const WideDouble volume = value / WideDouble(12);
        x[0] = WideDouble(volume.mantissa, volume.exponent - 3 * scale).in_double();
    } else if (measure == Measure::area) {
        x[0] = WideDouble(value.mantissa, value.exponent - 1 - 2 * scale).in_double();
    } else {
        for (std::size_t k = 0; k < 3; ++k) {
            const B moment = sum(1 + k);
            if (!is_below(moment.error, extent_ * magnitude(whole.wide()), measure_error))
                return false;
            const WideDouble offset = moment.value.wide() / (value * WideDouble(4)),
                             at = WideDouble(point[k]) + offset;
            x[k] = WideDouble(at.mantissa, at.exponent - scale).in_double();
        }
    }
    return true;
}

}  // namespace

bool ExactMeasures::in_long(CellFaces& faces, const double* point, int scale, std::size_t limbs,
                            Measure measure, double* x) {
    LongSums sums(corners_.allocator(), limbs);
    for (std::size_t f = 0; f < faces.size(); ++f) sums.add(faces, faces.face(f), measure);
    return sums.give(point, scale, measure, x);
}

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
    if (in_twofold(faces, point, scale, faces.exponent(), measure, x)) return;
    // A cell has a volume, so that enough limbs tell it.
    for (std::size_t limbs = 512 / exact::limb_bits;; limbs *= 4)
        if (in_long(faces, point, scale, limbs, measure, x)) return;
}

}  // namespace mgdt
