// SPDX-License-Identifier: MIT
// The radix sort of radix.hpp by a team: the same result, whatever its size.
#pragma once

#include <algorithm>

#include "order/radix.hpp"
#include "parallel/team.hpp"
#include "platform/atomic.hpp"

namespace mgdt {

// As radix_sort() of single words. The arrays must not overlap.
inline void radix_sort(Team& team, Allocator& allocator, std::uint64_t* a, std::uint64_t* scratch,
                       std::size_t n, unsigned low, unsigned high) {
    constexpr std::size_t share = 32768;
    const unsigned members = team.members_for(n, share);
    if (members == 1) {
        radix_sort(a, scratch, n, low, high);
        return;
    }
    const auto for_each_of = [&](unsigned member, auto f) {
        const std::size_t end = Team::part(n, member + 1, members);
        for (std::size_t i = Team::part(n, member, members); i < end; ++i) f(a[i]);
    };
    Atomic<std::uint64_t> all_differ{0};
    team.run(members, [&](unsigned m) {
        std::uint64_t differ = 0;
        for_each_of(m, [&, any = a[0]](std::uint64_t word) { differ |= word ^ any; });
        all_differ |= differ;
    });
    high = std::min(high, bit_width(all_differ));
    if (high <= low) return;

    // To buckets: a member moves the words of its part to where those of the members before it end.
    const unsigned shift = high - radix_detail::bucket_bits(high - low);
    const std::size_t values = std::size_t{1} << (high - shift);
    const auto bucket = [shift, mask = values - 1](std::uint64_t word) {
        return word >> shift & mask;
    };
    Buffer<std::uint32_t> counts(allocator, values * members);
    team.run(members, [&](unsigned m) {
        std::uint32_t* const count = counts.data() + m * values;
        std::fill_n(count, values, 0u);
        for_each_of(m, [count, bucket](std::uint64_t word) { ++count[bucket(word)]; });
    });
    std::uint32_t sum = 0;
    for (std::size_t v = 0; v < values; ++v) {
        for (unsigned m = 0; m < members; ++m) {
            std::uint32_t& count = counts[m * values + v];
            const std::uint32_t here = count;
            count = sum;
            sum += here;
        }
    }
    team.run(members, [&](unsigned m) {
        std::uint32_t* const next = counts.data() + m * values;
        for_each_of(m, [next, bucket, to = scratch](std::uint64_t word) {
            to[next[bucket(word)]++] = word;
        });
    });

    // Each bucket by one member, but for those that would keep it busy when all others are done.
    // The last member's words of a bucket are its last ones.
    const std::uint32_t* const ends = counts.data() + (members - 1) * values;
    const auto begin_of = [&](std::size_t v) { return v > 0 ? ends[v - 1] : 0; };
    // Either half of the members find work in the least of them, or they are at most half as many.
    const std::size_t large =
        std::max({2 * share, n / (4 * members), std::min(members * share / 2, 2 * n / members)});
    const auto is_large = [&](std::size_t v) { return ends[v] - begin_of(v) >= large; };
    Atomic<std::size_t> taken{0};
    team.run(members, [&](unsigned) {
        for (std::size_t v = taken++; v < values; v = taken++)
            if (!is_large(v))
                radix_detail::sort_bucket(a, scratch, begin_of(v), ends[v], low, shift);
    });
    for (std::size_t v = 0; v < values; ++v) {
        if (!is_large(v)) continue;
        const std::size_t begin = begin_of(v), size = ends[v] - begin;
        team.split(size, share, [&](std::size_t from, std::size_t to, unsigned) {
            std::copy(scratch + begin + from, scratch + begin + to, a + begin + from);
        });
        if (low < shift) radix_sort(team, allocator, a + begin, scratch + begin, size, low, shift);
    }
}

}  // namespace mgdt
