// SPDX-License-Identifier: MIT
// The order in which grids and rules are tried until a domain has a mesh.
#pragma once

#include <cstddef>

#include "solid/rounding_grid.hpp"

namespace mgdt {

// One way to make the mesh. The points are rounded to a grid with this many bits. The rule by which
// segments are divided may avoid short parts, and may take long. The attempt ends without a mesh if
// more than `most_points` points have to be added.
struct Attempt {
    int bits;
    bool avoids_short_parts, may_take_long;
    std::size_t most_points = static_cast<std::size_t>(-1);
};

// The first attempt is on the usual grid. If rounding makes the boundary invalid there, the finest
// grid follows. If a segment cannot be divided as finely as it has to be, or if that would take too
// long, the rule that avoids short parts is tried on the same grid, and then on coarser ones, on
// which a segment has more points at which it can be divided. Last, the coarsest grid on which it
// took too long gets all the time that it needs.
class Attempts {
  public:
    enum class Result {
        too_coarse,  // the boundary is invalid when its points are on the grid
        stuck,       // a segment needs points that the grid does not have
        took_long
    };

    const Attempt& current() const noexcept { return current_; }
    // The share of the remaining progress that has passed when the current attempt begins.
    double share_passed() const noexcept { return share_passed_; }
    // Goes on to the next attempt after one with this result. Returns false if there is none: then
    // the result is final.
    bool advance(Result result) noexcept;
    // Whether an attempt took too long, so that more time might have sufficed.
    bool has_taken_long() const noexcept { return slow_bits_ != 0; }

  private:
    enum class Stage { usual_grid, finest_grid, coarser_grids, last };

    bool coarsen(bool is_same_grid) noexcept;
    bool take_time() noexcept;

    Stage stage_ = Stage::usual_grid;
    Attempt current_ = {RoundingGrid::usual_bits, false, false};
    double share_passed_ = 0;
    int slow_bits_ = 0;  // of the coarsest grid on which it took too long; 0 if there is none
};

}  // namespace mgdt
