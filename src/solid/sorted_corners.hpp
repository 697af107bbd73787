// SPDX-License-Identifier: MIT
// Tetrahedra and faces in the order in which a mesh lists them: by their corners.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "query/canonical_sort.hpp"

namespace mgdt {

// A tetrahedron or a face for sorting: its corners in ascending order, and its number.
template <int n>
struct SortedCorners {
    std::uint32_t v[n];
    std::uint32_t from;
    bool is_odd;  // whether sorting has changed the orientation

    // By corners, and among those with the same corners by number.
    friend bool operator<(const SortedCorners& a, const SortedCorners& b) {
        for (int i = 0; i < n; ++i)
            if (a.v[i] != b.v[i]) return a.v[i] < b.v[i];
        return a.from < b.from;
    }
    bool has_smaller_corners(const SortedCorners& other) const {
        return std::lexicographical_compare(v, v + n, other.v, other.v + n);
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

// Sorts records in ascending order.
template <int n>
void sort_by_corners(Team& team, Allocator& allocator, Buffer<SortedCorners<n>>& records) {
    constexpr std::size_t records_per_thread = 65536;
    std::uint32_t last = 0;
    for (const SortedCorners<n>& record : records) last = std::max(last, record.v[0]);
    canonical_sort<SortedCorners<n>>(
        team, allocator, records.size(), records_per_thread, std::size_t{last} + 1,
        [&](std::size_t begin, std::size_t end, const auto& add) {
            for (std::size_t i = begin; i < end; ++i) add(records[i].v[0], records[i]);
        },
        [&](std::size_t, std::size_t i, const SortedCorners<n>& record) { records[i] = record; });
}

}  // namespace mgdt
