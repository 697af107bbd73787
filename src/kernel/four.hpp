// SPDX-License-Identifier: MIT
// Registers of four elements, for the islands that have them: the algorithms in kernel/four/ are
// written with these types alone. Each of those islands has
//
//   Four                 four doubles, with arithmetic, comparisons and permutations
//   FourMask, FourSigns  four truth values, each in all bits of an element or in its sign bit
//   FourIntegers         four integers of 64 bits
//   FourWords            four words of 32 bits
//   FourPositions        four positions among four words, for tables of permutations
//   Transpose4           four rows of doubles, or of their upper halves, as columns
#pragma once

#include "kernel/sphere_columns.hpp"
#include MGDT_IN_ISLAND(four.hpp)

namespace mgdt {
inline namespace MGDT_ISLAND {

// The points in the first three columns of `rows`, relative to the points `origin`.
MGDT_ALWAYS_INLINE PointColumns<Four> relative_to(const Transpose4& rows,
                                                  const PointColumns<Four>& origin) {
    return {rows.first - origin.x, rows.second - origin.y, rows.third - origin.z};
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
