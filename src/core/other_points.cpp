// SPDX-License-Identifier: MIT
#include "core/other_points.hpp"

#include <algorithm>

namespace mgdt {

void OtherPoints::find() {
    if (state_.statistics.duplicates == 0) return;
    if (is_alone_) {
        state_.points.equals.update(state_.points.map, state_.mesh.vertices);
        return;
    }
    // Whether some of the points share a vertex with others, or have done so.
    const bool are_some_shared =
        std::any_of(leaving_.begin(), leaving_.end(), [this](std::uint32_t i) {
            return state_.mesh.vertices[state_.points.map[i]].moved_to == has_equals;
        });
    if (are_some_shared) among_.find(state_.points.map, leaving_);
}

std::uint32_t OtherPoints::least(VertexId v, std::uint32_t than) {
    return is_alone_ ? state_.points.equals.least_other(state_.points.map, state_.mesh.vertices[v],
                                                        v, than)
                     : among_.least_other(state_.points.map, v, than);
}

void OtherPoints::join(VertexId v, std::uint32_t point) {
    among_.join(v, point);
    state_.points.equals.forget();
}

}  // namespace mgdt
