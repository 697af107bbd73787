// SPDX-License-Identifier: MIT
// Functions that turn a facet, a cycle of three vertices, so that a certain vertex comes first.
#pragma once

#include <cassert>

namespace mgdt {

// Rotates v so that v[first] comes first.
template <class T>
inline void turn_to(T (&v)[3], int first) {
    assert(first >= 0 && first < 3 && "a facet has three vertices");
    const T a = v[0], b = v[1], c = v[2];
    if (first == 1) {
        v[0] = b;
        v[1] = c;
        v[2] = a;
    } else if (first == 2) {
        v[0] = c;
        v[1] = a;
        v[2] = b;
    }
}

// Rotates v so that its least element comes first.
template <class T>
inline void turn_to_least(T (&v)[3]) {
    assert(v[0] != v[1] && v[1] != v[2] && v[2] != v[0] && "two vertices of a facet are the same");
    const int of_two = v[1] < v[0] ? 1 : 0;
    turn_to(v, v[2] < v[of_two] ? 2 : of_two);
}

}  // namespace mgdt
