// SPDX-License-Identifier: MIT
#include "domain/attempts.hpp"

namespace mgdt {

bool Attempts::advance(Result result) noexcept {
    if (result == Result::took_long) slow_bits_ = current_.bits;
    switch (stage_) {
        case Stage::usual_grid:
            if (result != Result::too_coarse) return coarsen(true);
            stage_ = Stage::finest_grid;
            current_.bits = RoundingGrid::most_bits;
            share_passed_ = 0.1;
            return true;
        case Stage::finest_grid:
            return result != Result::too_coarse && coarsen(true);
        case Stage::coarser_grids:
            return result == Result::too_coarse ? take_time() : coarsen(false);
        default:
            return false;
    }
}

bool Attempts::coarsen(bool is_same_grid) noexcept {
    constexpr int step = 4;
    if (current_.bits <= RoundingGrid::least_bits) return take_time();
    stage_ = Stage::coarser_grids;
    current_ = {is_same_grid ? current_.bits : current_.bits - step, true, false};
    share_passed_ = 0.8;
    return true;
}

bool Attempts::take_time() noexcept {
    if (slow_bits_ == 0) return false;
    stage_ = Stage::last;
    current_ = {slow_bits_, true, true};
    share_passed_ = 0.8;
    return true;
}

}  // namespace mgdt
