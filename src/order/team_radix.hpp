// SPDX-License-Identifier: MIT
// The radix sort of radix.hpp by a team: the same result, whatever its size.
#pragma once

#include <algorithm>

#include "order/radix.hpp"
#include "parallel/team.hpp"

namespace mgdt {

// Runs of consecutive items, of which a team takes the large ones together.
class Runs {
  public:
    struct Run {
        std::size_t begin, end;
    };
    explicit Runs(Allocator& allocator) : large_(allocator) {}

    // Calls each(begin, end) for the runs of items 0..n-1 with equal(i, j) from `least` items on:
    // the members side by side for the small ones, then, for each large one, once with `team`.
    template <class Equal, class Each>
    void for_each(Team& team, std::size_t n, std::size_t least, Equal equal, Each each) {
        constexpr std::size_t share = 32768;
        const unsigned members = team.members_for(n, share);
        large_.clear();
        // Where each one's runs begin, before any of them may be changed.
        std::size_t first[Team::most + 1];
        first[members] = n;
        team.run(members, [&](unsigned member) {
            std::size_t k = Team::part(n, member, members);
            while (k > 0 && k < n && equal(k - 1, k)) ++k;
            first[member] = k;
        });
        team.run(members, [&](unsigned member) {
            Team alone;
            const std::size_t stop = first[member + 1];
            for (std::size_t k = first[member]; k < stop;) {
                std::size_t next = k + 1;
                while (next < stop && equal(k, next)) ++next;
                if (members > 1 && next - k >= 2 * share) {
                    const std::lock_guard<std::mutex> lock(mutex_);
                    large_.push_back({k, next});
                } else if (next - k >= least) {
                    each(alone, k, next);
                }
                k = next;
            }
        });
        for (const Run& run : large_) each(team, run.begin, run.end);
    }

  private:
    std::mutex mutex_;
    Buffer<Run> large_;
};

// As radix_sort() of single words. The arrays must not overlap.
inline void radix_sort(Team& team, Allocator& allocator, std::uint64_t* a, std::uint64_t* scratch,
                       std::size_t n, unsigned low, unsigned high) {
    constexpr std::size_t share = 32768;
    const unsigned members = team.members_for(n, share);
    if (members == 1) {
        radix_sort(a, scratch, n, low, high);
        return;
    }
    const auto first = [&](unsigned member) { return Team::part(n, member, members); };
    Atomic<std::uint64_t> all_differ{0};
    team.run(members, [&](unsigned m) {
        std::uint64_t differ = 0;
        for (std::size_t i = first(m); i < first(m + 1); ++i) differ |= a[i] ^ a[0];
        all_differ |= differ;
    });
    high = std::min(high, bit_width(all_differ));
    if (high <= low) return;
    const unsigned width = radix_detail::first_width(n, low, high);
    high -= width;

    // Passes from the least digit, each stable: a member moves the words of its part to where the
    // words of the members before it end.
    const radix_detail::Digits digits(width);
    const std::size_t values = digits.values();
    Buffer<std::uint32_t> counts(allocator, values * members);
    std::uint64_t *from = a, *to = scratch;
    for (unsigned d = 0; d < digits.count; ++d) {
        const unsigned shift = high + d * digits.bits;
        const auto digit = [&](std::uint64_t word) { return word >> shift & (values - 1); };
        team.run(members, [&](unsigned m) {
            std::uint32_t* const count = counts.data() + m * values;
            std::fill_n(count, values, 0u);
            for (std::size_t i = first(m); i < first(m + 1); ++i) ++count[digit(from[i])];
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
            for (std::size_t i = first(m); i < first(m + 1); ++i)
                to[next[digit(from[i])]++] = from[i];
        });
        std::swap(from, to);
    }
    if (from != a)
        team.split(n, share, [&](std::size_t begin, std::size_t end, unsigned) {
            std::copy(from + begin, from + end, a + begin);
        });
    if (high <= low) return;
    const unsigned sorted = high;
    Runs(allocator).for_each(
        team, n, 2, [&](std::size_t i, std::size_t j) { return a[i] >> sorted == a[j] >> sorted; },
        [&](Team& t, std::size_t begin, std::size_t end) {
            radix_sort(t, allocator, a + begin, scratch + begin, end - begin, low, sorted);
        });
}

}  // namespace mgdt
