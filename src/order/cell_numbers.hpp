// SPDX-License-Identifier: MIT
// Bounding boxes, and the conversion of a coordinate to a cell number, for every finite double.
#pragma once

#include <cstddef>
#include <cstdint>

#include "order/schedule.hpp"

namespace mgdt {

struct Box {
    double low[3], high[3];

    // The result may be infinite.
    double extent(int k) const noexcept { return high[k] - low[k]; }
    double longest() const noexcept {
        double e = extent(0);
        for (int k = 1; k < 3; ++k) {
            if (extent(k) > e) e = extent(k);
        }
        return e;
    }
    void add(const double* p) noexcept {
        for (int k = 0; k < 3; ++k) {
            low[k] = p[k] < low[k] ? p[k] : low[k];
            high[k] = p[k] > high[k] ? p[k] : high[k];
        }
    }
};

inline Box box_of(const PointSet& points) noexcept {
    Box box;
    for (int k = 0; k < 3; ++k) {
        box.low[k] = points.low[k];
        box.high[k] = points.high[k];
    }
    return box;
}

// The bounding box of n >= 1 points; index(j) is the j-th of them.
template <class Index>
Box box_of(const PointSet& points, std::size_t n, Index index) noexcept {
    constexpr std::size_t ahead = 16;
    Box box;
    for (int k = 0; k < 3; ++k) box.low[k] = box.high[k] = points.coordinate(index(0), k);
    for (std::size_t j = 1; j < n; ++j) {
        if (j + ahead < n) points.prefetch(index(j + ahead));
        const std::size_t i = index(j);
        const double p[3] = {points.coordinate(i, 0), points.coordinate(i, 1),
                             points.coordinate(i, 2)};
        box.add(p);
    }
    return box;
}

// Divides a box into count[0] x count[1] x count[2] cells, and gives the cell of a point. Each
// count is at most 2^31 - 1.
class Lattice {
  public:
    // Cells with the proportions of the box.
    static Lattice divide(const PointSet& points, const Box& box,
                          const std::uint32_t count[3]) noexcept {
        Lattice lattice;
        for (int k = 0; k < 3; ++k) {
            const double unit = working_unit(box.extent(k));
            lattice.set_axis(k, points, box, unit, box.high[k] * unit - box.low[k] * unit,
                             count[k]);
        }
        return lattice;
    }

    // count^3 cubes. Together they form the smallest cube that contains the box and has its low
    // corner at box.low.
    static Lattice cubes(const PointSet& points, const Box& box, std::uint32_t count) noexcept {
        Lattice lattice;
        const double unit = working_unit(box.longest());
        double side = 0;
        for (int k = 0; k < 3; ++k) {
            if (!(box.low[k] < box.high[k])) continue;
            const double extent = box.high[k] * unit - box.low[k] * unit;
            if (extent > side) side = extent;
        }
        for (int k = 0; k < 3; ++k) lattice.set_axis(k, points, box, unit, side, count);
        return lattice;
    }

    // The number of the cell of point i along axis k, 0..count-1. In a box that is not flat, the
    // least coordinate is in the first cell, and the largest in the last.
    std::uint32_t step(const PointSet& points, std::size_t i, int k) const noexcept {
        const double x = points.axis[k][static_cast<std::ptrdiff_t>(i) * points.stride];
        double t = (x * unit_[k] - low_[k]) * factor_[k];
        t = t > 0 ? t : 0;
        t = t < last_[k] ? t : last_[k];
        return static_cast<std::uint32_t>(static_cast<std::int32_t>(t));
    }

  private:
    // A power of two that scales an extent so that it and its reciprocal are finite. If an extent
    // is small, so are the coordinates, and scaling does not overflow them.
    static double working_unit(double extent) noexcept {
        if (extent > 0x1p1023) return 0.5;
        return extent < 0x1p-600 ? 0x1p500 : 1.0;
    }

    void set_axis(int k, const PointSet& points, const Box& box, double unit, double side,
                  std::uint32_t count) noexcept {
        const bool flat = !(box.low[k] < box.high[k]);
        unit_[k] = flat ? 0 : points.scale * unit;
        low_[k] = flat ? 0 : box.low[k] * unit;
        factor_[k] = flat ? 0 : count / side;
        last_[k] = count - 1.0;
    }

    double unit_[3], low_[3], factor_[3], last_[3];
};

}  // namespace mgdt
