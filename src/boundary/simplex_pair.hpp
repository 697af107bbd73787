// SPDX-License-Identifier: MIT
// Pairs of the points, segments and triangles that bound a domain. They form a complex if each two
// of them meet in a common face or not at all.
#pragma once

#include <cstdint>

namespace mgdt {

// A point, a segment or a triangle. The corners of a segment differ, and those of a triangle are
// not on one line.
struct Simplex {
    int size;            // the number of corners, from 1 to 3
    const double* x[3];  // their coordinates
    // The numbers of the corners. Two corners have the same number if and only if their coordinates
    // are equal.
    std::uint32_t number[3];
};

// Whether all points that two simplices have in common belong to the simplex that is spanned by
// their common corners. Facets that cross, touch or overlap fail this test, and so does a point in
// the middle of a facet. A simplex and one of its faces pass, and so does a simplex with itself.
// The decision is exact.
bool meet_in_common_face(const Simplex& a, const Simplex& b);

}  // namespace mgdt
