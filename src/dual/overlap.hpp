// SPDX-License-Identifier: MIT
// Whether a polygon in a plane of the region overlaps with a cell.
#pragma once

#include <cstddef>

namespace mgdt {

enum class Overlap { some, none, unknown };

// The polygon is either a face of the cell or has no area in common with the cell. One corner can
// decide which: a corner outside the cell, or a corner inside all half-spaces of the cell except
// those of the two edges at the corner. has_edge(i, b) says whether an edge at corner i is in the
// plane of half-space b of the cell. sign_at(i, b) says on which side of that plane the corner is:
// +1 is outside. `if_outside` is the result for a corner outside the cell.
template <class HasEdge, class SignAt>
Overlap find_overlap(std::size_t corners, std::size_t half_spaces, HasEdge has_edge, SignAt sign_at,
                     Overlap if_outside) {
    for (std::size_t i = 0; i < corners; ++i) {
        bool is_inside = true;
        for (std::size_t b = 0; b < half_spaces; ++b) {
            if (has_edge(i, b)) continue;
            const int sign = sign_at(i, b);
            if (sign > 0) return if_outside;
            is_inside = sign < 0;
            if (!is_inside) break;
        }
        if (is_inside) return Overlap::some;
    }
    return corners == 0 ? Overlap::none : Overlap::unknown;
}

}  // namespace mgdt
