// SPDX-License-Identifier: MIT
// The radix sort of radix.hpp by a team. The result does not depend on the number of threads.
#pragma once

#include <algorithm>

#include "order/radix.hpp"
#include "parallel/team_lists.hpp"
#include "platform/atomic.hpp"

namespace mgdt {

// Sorts words as the radix_sort() of radix.hpp does. Distributes the words into buckets first if
// there are many words or several threads. The arrays must not overlap.
inline void radix_sort(Team& team, Allocator& allocator, std::uint64_t* a, std::uint64_t* scratch,
                       std::size_t n, unsigned low, unsigned high) {
    constexpr std::size_t min_items_per_thread = 32768, many = std::size_t{1} << 19;
    constexpr unsigned most_bits = 11;
    const unsigned members = team.members_for(n, min_items_per_thread);
    if (members == 1 && n <= many) {
        radix_sort(a, scratch, n, low, high);
        return;
    }
    Atomic<std::uint64_t> all_differ{0};
    team.split(n, min_items_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
        std::uint64_t differ = 0;
        for (std::size_t i = begin; i < end; ++i) differ |= a[i] ^ a[0];
        all_differ |= differ;
    });
    high = std::min(high, bit_width(all_differ));
    if (high <= low) return;

    // Distribute the words into buckets by their top bits.
    const unsigned shift = high - std::min(high - low, most_bits);
    const std::size_t values = std::size_t{1} << (high - shift);
    Buffer<std::uint32_t> ends(allocator, values + 1);
    make_lists(
        team, allocator, n, min_items_per_thread, values, ends.data(),
        [a, shift, mask = values - 1](std::size_t begin, std::size_t end, auto f) {
            for (std::size_t i = begin; i < end; ++i)
                f(static_cast<std::size_t>(a[i] >> shift & mask), a[i]);
        },
        [](std::size_t) {},
        [scratch](std::size_t position, std::uint64_t word) { scratch[position] = word; });

    // One thread sorts each bucket, except for buckets that are so large that the other threads
    // would have to wait: these are sorted by the whole team.
    const std::size_t large =
        std::max({2 * min_items_per_thread, n / (4 * members),
                  std::min(members * min_items_per_thread / 2, 2 * n / members)});
    const auto is_large = [&](std::size_t v) { return ends[v + 1] - ends[v] >= large; };
    const auto copy_back = [&](std::size_t begin, std::size_t end) {
        std::copy(scratch + begin, scratch + end, a + begin);
    };
    Atomic<std::size_t> taken{0};
    team.run(members, [&](unsigned) {
        for (std::size_t v = taken++; v < values; v = taken++) {
            if (is_large(v) || ends[v] == ends[v + 1]) continue;
            copy_back(ends[v], ends[v + 1]);
            if (low < shift)
                radix_sort(a + ends[v], scratch + ends[v], ends[v + 1] - ends[v], low, shift);
        }
    });
    for (std::size_t v = 0; v < values; ++v) {
        if (!is_large(v)) continue;
        const std::size_t first = ends[v], size = ends[v + 1] - first;
        team.split(size, min_items_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
            copy_back(first + begin, first + end);
        });
        if (low < shift) radix_sort(team, allocator, a + first, scratch + first, size, low, shift);
    }
}

}  // namespace mgdt
