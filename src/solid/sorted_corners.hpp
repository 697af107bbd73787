// SPDX-License-Identifier: MIT
// Tetrahedra and faces in the order in which a mesh lists them: by their corners.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

namespace mgdt {

// A tetrahedron or a face for sorting: its corners in ascending order, and its number.
template <int n>
struct SortedCorners {
    std::uint32_t v[n];
    std::uint32_t from;
    bool is_odd;  // whether sorting has changed the orientation

    friend bool operator<(const SortedCorners& a, const SortedCorners& b) {
        return std::lexicographical_compare(a.v, a.v + n, b.v, b.v + n);
    }
    bool has_same_corners(const SortedCorners& other) const {
        return std::equal(v, v + n, other.v);
    }
    void sort() {
        is_odd = false;
        for (int i = 1; i < n; ++i)
            for (int j = i; j > 0 && v[j] < v[j - 1]; --j) {
                std::swap(v[j], v[j - 1]);
                is_odd = !is_odd;
            }
    }
};

}  // namespace mgdt
