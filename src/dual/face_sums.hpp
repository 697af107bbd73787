// SPDX-License-Identifier: MIT
// Sums over the faces of a cell, with bounds on their errors: volume, area or moment, from the
// corners of each face in cyclic order. The sums do not depend on the order of the faces.
#pragma once

#include <algorithm>

#include "dual/corner.hpp"
#include "dual/order_free_sum.hpp"
#include "platform/memory.hpp"

namespace mgdt {

// centroid_offset is the centroid relative to the cell's point.
enum class Measure { volume, area, centroid, centroid_offset, faces };

// How many numbers a measure has.
constexpr std::size_t width_of(Measure measure) {
    return measure == Measure::centroid || measure == Measure::centroid_offset ? 3 : 1;
}

// The largest allowed relative error of volumes and areas, and the largest allowed error of
// centroids in units of the distance of the farthest corner.
constexpr double measure_error = 1e-12;

// A sum with a bound on the error of each term.
class ErrorBoundSum {
  public:
    explicit ErrorBoundSum(Allocator& allocator) : terms_(allocator), errors_(allocator) {}
    void clear() noexcept {
        terms_.clear();
        errors_.clear();
        largest_ = largest_error_ = 0;
    }
    void add(double term, double error) {
        constexpr double most = std::numeric_limits<double>::max();
        if (!(std::fabs(term) <= most && error <= most)) {
            term = 0;
            error = std::numeric_limits<double>::infinity();
        }
        terms_.push_back(term);
        errors_.push_back(error);
        largest_ = std::max(largest_, std::fabs(term));
        largest_error_ = std::max(largest_error_, error);
    }
    double value() const { return order_free_sum(terms_.data(), terms_.size(), largest_); }
    double error() const { return order_free_sum(errors_.data(), errors_.size(), largest_error_); }

  private:
    Buffer<double> terms_, errors_;
    double largest_ = 0, largest_error_ = 0;
};

class FaceSums {
  public:
    explicit FaceSums(Allocator& allocator)
        : sums_{ErrorBoundSum(allocator), ErrorBoundSum(allocator), ErrorBoundSum(allocator),
                ErrorBoundSum(allocator)} {}

    // A face: its half-space and its weight, which is twice the factor by which the normal has to
    // be multiplied to end in the plane of the face.
    struct Face {
        const Side& side;
        double weight;
        double error;  // a bound on the error of the weight
    };
    // Returns the face in a plane that is not the bisector between two vertices.
    static Face face_in_plane(const Side& side) {
        const double squared = dot(side.normal, side.normal), weight = 2 * side.offset / squared;
        return {side, weight,
                2 * side.error / squared + 8 * rounding_of<double> * std::fabs(weight)};
    }

    void clear() {
        for (ErrorBoundSum& sum : sums_) sum.clear();
        extent_ = 0;
    }
    // Raises the extent of the cell to the distance of a corner from the vertex.
    void reach(double distance) { extent_ = std::max(extent_, distance); }
    // Adds the contribution of the triangle between the vertex and an edge of the face; edges are
    // counter-clockwise about the outward normal. The sums are 12 times the volume, twice the area
    // and 48 times the moment; see docs/theory.md, "Cells".
    template <Measure M>
    void add_edge(const Face& face, const Corner& a, const Corner& b,
                  const Vector<double>& a_cross_b);
    // Adds to the error bound an area of which it is uncertain whether the face has it.
    template <Measure M>
    void add_doubt(const Face& face, double area);

    // Whether the error is certainly below measure_error.
    template <Measure M>
    bool is_sure() const;
    double volume() const { return std::max(0.0, sums_[0].value() / 12); }
    double area() const { return std::max(0.0, sums_[0].value() / 2); }
    // A coordinate of the centroid, relative to the vertex.
    double centroid(int axis) const { return sums_[1 + axis].value() / (4 * sums_[0].value()); }

  private:
    ErrorBoundSum sums_[4];
    double extent_ = 0;
};

template <Measure M>
void FaceSums::add_edge(const Face& face, const Corner& a, const Corner& b,
                        const Vector<double>& a_cross_b) {
    constexpr double u = rounding_of<double>;
    const Side& side = face.side;
    const double along = dot(side.normal, a_cross_b);
    const double error = side.size * (a.size * b.error + b.size * a.error + a.error * b.error +
                                      24 * u * a.size * b.size);
    if constexpr (M == Measure::volume || M == Measure::centroid) {
        const double volume = face.weight * along;
        const double w = std::fabs(face.weight),
                     volume_error = w * error + face.error * std::fabs(along);
        sums_[0].add(volume, volume_error);
        if constexpr (M == Measure::centroid) {
            const double half = 0.5 * face.weight;
            const double distance = 0.5 * w * side.size + a.size + b.size;
            const double moved = 0.5 * face.error * side.size + a.error + b.error;
            for (int k = 0; k < 3; ++k)
                sums_[1 + k].add(volume * (half * side.normal.x[k] + (a.x.x[k] + b.x.x[k])),
                                 volume_error * (distance + moved) +
                                     std::fabs(volume) * (moved + 8 * u * distance));
        }
    } else {
        sums_[0].add(along * (1 / side.size), error / side.size);
    }
}

template <Measure M>
void FaceSums::add_doubt(const Face& face, double area) {
    const double w = M == Measure::area ? 1 / face.side.size : std::fabs(face.weight);
    const double error = 2 * w * face.side.size * area;
    sums_[0].add(0, error);
    if constexpr (M == Measure::centroid)
        for (int k = 1; k < 4; ++k) sums_[k].add(0, 3 * extent_ * error);
}

template <Measure M>
bool FaceSums::is_sure() const {
    // Terms that underflow in a sum of this magnitude do not matter.
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
