// SPDX-License-Identifier: MIT
// Runs of consecutive items that are equal, dealt to a team: as runs.hpp, whatever its size.
#pragma once

#include <mutex>

#include "order/runs.hpp"
#include "parallel/team.hpp"
#include "platform/atomic.hpp"

namespace mgdt {

// Calls each(team, begin, end) for the runs of items 0..n-1 with equal(i, j) from `least` items on:
// the members side by side, each as a team of its own, for the small ones; then once with all of
// `team` for each large one. each() may change the items of its run.
template <class Equal, class Each>
void for_each_run(Team& team, Allocator& allocator, std::size_t n, std::size_t least, Equal equal,
                  Each each) {
    constexpr std::size_t share = 32768;
    const unsigned members = team.members_for(n, share);
    if (members == 1) {
        Team alone;
        for_each_run(0, n, equal, [&](std::size_t begin, std::size_t end) {
            if (end - begin >= least) each(alone, begin, end);
        });
        return;
    }
    // Runs can take much longer than others of the same length: more pieces than members.
    const std::size_t pieces = std::size_t{16} * members;
    // Where each piece's runs begin, before any of them may be changed.
    Buffer<std::size_t> first(allocator);
    first.resize(pieces + 1);
    first[pieces] = n;
    for (std::size_t p = pieces, next = n; p-- > 0;) {
        const std::size_t begin = n / pieces * p + n % pieces * p / pieces;
        std::size_t k = begin;
        while (k > 0 && k < next && equal(k - 1, k)) ++k;
        first[p] = k < next ? k : first[p + 1];
        next = begin;
    }
    struct Run {
        std::size_t begin, end;
    };
    Buffer<Run> large(allocator);
    std::mutex mutex;
    Atomic<std::size_t> taken{0};
    team.run(members, [&](unsigned) {
        Team alone;
        for (std::size_t p = taken++; p < pieces; p = taken++)
            for_each_run(first[p], first[p + 1], equal, [&](std::size_t begin, std::size_t end) {
                if (end - begin >= 2 * share) {
                    const std::lock_guard<std::mutex> lock(mutex);
                    large.push_back({begin, end});
                } else if (end - begin >= least) {
                    each(alone, begin, end);
                }
            });
    });
    for (const Run& run : large) each(team, run.begin, run.end);
}

}  // namespace mgdt
