// SPDX-License-Identifier: MIT
// The points of a segment at which it may be divided: their coordinates are doubles, exactly.
#pragma once

#include <cstdint>

namespace mgdt {

// A segment between two points of a RoundingGrid, in steps, with the points that divide it into
// 2^room equal parts. The coordinates of these points are doubles.
class DividedSegment {
  public:
    static constexpr int most_room = 30;

    DividedSegment(const double* a, const double* b) noexcept;

    std::uint32_t parts() const noexcept { return std::uint32_t{1} << room_; }
    // The point a + k / parts() (b - a), exactly.
    void point(std::uint32_t k, double* x) const noexcept;

  private:
    int room_ = most_room;
    // Coordinate i of point k is (origin_[i] + k step_[i]) 2^-shift_[i].
    std::int64_t origin_[3], step_[3];
    int shift_[3];
};

}  // namespace mgdt
