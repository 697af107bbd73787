// SPDX-License-Identifier: MIT
// What the faces of a cell add up to, with a bound of the error: volume, area or moment, from the
// corners of each face in turn. The sums are the same in whatever order the faces come.
#pragma once

#include "dual/corner.hpp"
#include "dual/order_free_sum.hpp"
#include "platform/memory.hpp"

namespace mgdt {

enum class Measure { volume, area, centroid, faces };

// Relative error of volumes and areas, and that of centroids in units of the distance of the
// farthest corner.
constexpr double measure_error = 1e-12;

// Terms, and a bound of the error of each.
template <class Real>
class ErrorBoundSum {
  public:
    explicit ErrorBoundSum(Allocator& allocator) : terms_(allocator), errors_(allocator) {}
    void clear() noexcept {
        terms_.clear();
        errors_.clear();
        largest_ = largest_error_ = 0;
    }
    void add(const Real& term, double error) {
        push(term);
        errors_.push_back(error);
        largest_ = std::fmax(largest_, std::fabs(nearest_double(term)));
        largest_error_ = std::fmax(largest_error_, error);
    }
    double value() const { return order_free_sum(terms_.data(), terms_.size(), largest_); }
    double error() const { return order_free_sum(errors_.data(), errors_.size(), largest_error_); }

  private:
    void push(double term) { terms_.push_back(term); }
    void push(const Twofold& term) {
        terms_.push_back(term.high);
        terms_.push_back(term.low);
    }
    Buffer<double> terms_, errors_;
    double largest_ = 0, largest_error_ = 0;
};

template <class Real>
class FaceSums {
  public:
    explicit FaceSums(Allocator& allocator)
        : sums_{Sum(allocator), Sum(allocator), Sum(allocator), Sum(allocator)} {}

    // A face's side, and twice the multiple of its normal that lies in the face.
    struct Face {
        const Side<Real>& side;
        Real weight;
        double error;  // of the weight
    };
    // The face in a plane that is no bisector.
    static Face face_in_plane(const Side<Real>& side) {
        const Real squared = dot(side.normal, side.normal),
                   weight = scaled_by(side.offset, 2) / squared;
        return {side, weight,
                2 * side.error / nearest_double(squared) +
                    8 * rounding_of<Real> * std::fabs(nearest_double(weight))};
    }

    void clear() {
        for (Sum& sum : sums_) sum.clear();
        extent_ = 0;
    }
    // Bounds the distance of corners from the vertex.
    void reach(double distance) { extent_ = std::fmax(extent_, distance); }
    // What the triangle of the vertex and an edge of the face adds, the face turning round its
    // outward normal. Volumes are 12 times too large and areas twice; docs/theory.md, "Cells".
    template <Measure M>
    void add_edge(const Face& face, const Corner<Real>& a, const Corner<Real>& b,
                  const Vector<Real>& a_cross_b);
    // An area of the face that may be there or not.
    template <Measure M>
    void add_doubt(const Face& face, double area);

    // Whether the error is below measure_error for sure.
    template <Measure M>
    bool is_sure() const;
    double volume() const { return std::fmax(sums_[0].value() / 12, 0); }
    double area() const { return std::fmax(sums_[0].value() / 2, 0); }
    // A coordinate of the centroid relative to the vertex.
    double centroid(int axis) const { return sums_[1 + axis].value() / (4 * sums_[0].value()); }
    double extent() const noexcept { return extent_; }

  private:
    using Sum = ErrorBoundSum<Real>;
    Sum sums_[4];
    double extent_ = 0;
};

template <class Real>
template <Measure M>
void FaceSums<Real>::add_edge(const Face& face, const Corner<Real>& a, const Corner<Real>& b,
                              const Vector<Real>& a_cross_b) {
    constexpr double u = rounding_of<Real>;
    const Side<Real>& side = face.side;
    const Real along = dot(side.normal, a_cross_b);
    const double error = side.size * (a.size * b.error + b.size * a.error + a.error * b.error +
                                      24 * u * a.size * b.size);
    if constexpr (M == Measure::volume || M == Measure::centroid) {
        const Real volume = face.weight * along;
        const double w = std::fabs(nearest_double(face.weight)),
                     volume_error = w * error + face.error * std::fabs(nearest_double(along));
        sums_[0].add(volume, volume_error);
        if constexpr (M == Measure::centroid) {
            const Real half = scaled_by(face.weight, 0.5);
            const double distance = 0.5 * w * side.size + a.size + b.size;
            const double moved = 0.5 * face.error * side.size + a.error + b.error;
            for (int k = 0; k < 3; ++k)
                sums_[1 + k].add(
                    volume * (half * side.normal.x[k] + (a.x.x[k] + b.x.x[k])),
                    volume_error * (distance + moved) +
                        std::fabs(nearest_double(volume)) * (moved + 8 * u * distance));
        }
    } else {
        const Real one_over_size = to_real<Real>(1 / side.size);
        sums_[0].add(one_over_size * along, error / side.size);
    }
}

template <class Real>
template <Measure M>
void FaceSums<Real>::add_doubt(const Face& face, double area) {
    const double w =
        M == Measure::area ? 1 / face.side.size : std::fabs(nearest_double(face.weight));
    const double error = 2 * w * face.side.size * area;
    const Real nothing = to_real<Real>(0);
    sums_[0].add(nothing, error);
    if constexpr (M == Measure::centroid)
        for (int k = 1; k < 4; ++k) sums_[k].add(nothing, 3 * extent_ * error);
}

template <class Real>
template <Measure M>
bool FaceSums<Real>::is_sure() const {
    // Terms of such a sum that are lost below the range of doubles do not count.
    constexpr double least = 0x1p-900, most = 0x1p900;
    const double value = sums_[0].value();
    if (!(value > least && value < most)) return false;
    if (!(sums_[0].error() <= 0.9 * measure_error * value)) return false;
    if constexpr (M == Measure::centroid)
        for (int k = 1; k < 4; ++k)
            if (!(sums_[k].error() <= measure_error * extent_ * value)) return false;
    return true;
}

}  // namespace mgdt
