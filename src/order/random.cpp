// SPDX-License-Identifier: MIT
// The order scheme that shuffles.
#include "platform/random.hpp"

#include <utility>

#include "order/schemes.hpp"

namespace mgdt {

// The shuffle of Fisher and Yates.
void order_random(Team&, const PointSet& points, const OrderParameters& parameters, Schedule& out) {
    Random random(parameters.seed);
    for (std::size_t i = 0; i < points.size; ++i) out.order[i] = static_cast<std::uint32_t>(i);
    for (std::size_t left = points.size; left > 1; --left) {
        std::swap(out.order[left - 1], out.order[random.below(static_cast<std::uint32_t>(left))]);
    }
}

}  // namespace mgdt
