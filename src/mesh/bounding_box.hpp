// SPDX-License-Identifier: MIT
// Boxes parallel to the axes, with their boundaries.
#pragma once

#include <algorithm>
#include <limits>

namespace mgdt {

struct BoundingBox {
    double low[3], high[3];

    BoundingBox() = default;
    explicit BoundingBox(const double* point) {
        std::copy_n(point, 3, low);
        std::copy_n(point, 3, high);
    }
    static BoundingBox empty() {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        BoundingBox box;
        std::fill_n(box.low, 3, infinity);
        std::fill_n(box.high, 3, -infinity);
        return box;
    }

    bool is_empty() const { return !(low[0] <= high[0]); }
    void include(const double* point) {
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], point[k]);
            high[k] = std::max(high[k], point[k]);
        }
    }
    void include(const BoundingBox& other) {
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], other.low[k]);
            high[k] = std::max(high[k], other.high[k]);
        }
    }
    bool overlaps(const BoundingBox& other) const {
        for (int k = 0; k < 3; ++k)
            if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
        return true;
    }
    // Whether points are all beyond one side of the box, so that nothing between them meets it.
    template <class... Point>
    bool has_beside(const Point*... p) const noexcept {
        for (int k = 0; k < 3; ++k)
            if (((p[k] < low[k]) && ...) || ((p[k] > high[k]) && ...)) return true;
        return false;
    }
    // The axis of the longest side. Halves are compared, because a side may be longer than doubles.
    int longest_axis() const {
        const auto half = [this](int k) { return high[k] / 2 - low[k] / 2; };
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (half(k) > half(axis)) axis = k;
        return axis;
    }
    // The middle of the box along an axis.
    double middle(int axis) const { return low[axis] / 2 + high[axis] / 2; }
};

}  // namespace mgdt
