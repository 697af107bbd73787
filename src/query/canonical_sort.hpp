// SPDX-License-Identifier: MIT
// Sorts records of indices. Records are distributed into buckets by their first index in linear
// time; few records share a bucket, so sorting the buckets is cheap.
#pragma once

#include <algorithm>

#include "parallel/team_lists.hpp"

namespace mgdt {

// each(begin, end, f) calls f(first, value) for the records of items begin..end-1, where `first` is
// a record's first index and less than `firsts`. each() sees each item twice. Then several threads
// at the same time call sorted(first, position, value) for every record, where `position` is the
// position of the record in sorted order.
template <class Value, class Each, class Sorted>
void canonical_sort(Team& team, Allocator& allocator, std::size_t items,
                    std::size_t min_items_per_thread, std::size_t firsts, Each each,
                    Sorted sorted) {
    Buffer<Value> values(allocator);
    Buffer<std::uint32_t> ends(allocator, firsts + 1);
    make_lists(
        team, allocator, items, min_items_per_thread, firsts, ends.data(), each,
        [&](std::size_t size) { values.resize(size); },
        [&](std::size_t position, const Value& value) { values[position] = value; });
    constexpr std::size_t firsts_per_thread = 16384;
    team.split(firsts, firsts_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t k = begin; k < end; ++k) {
            std::sort(values.begin() + ends[k], values.begin() + ends[k + 1]);
            for (std::size_t i = ends[k]; i < ends[k + 1]; ++i) sorted(k, i, values[i]);
        }
    });
}

}  // namespace mgdt
