// SPDX-License-Identifier: MIT
// Runs of consecutive equal items, processed by a team. The result is that of equal_runs.hpp.
#pragma once

#include <mutex>

#include "order/equal_runs.hpp"
#include "parallel/team.hpp"
#include "platform/atomic.hpp"

namespace mgdt {

struct Run {
    std::size_t begin, end;
};

// Finds the runs of at least `least` equal items in begin..end-1. Each thread makes a function each
// = make_each() and calls each(begin, end) for small runs; each() may change the items of its run.
// Large runs are appended to `large`, in any order, for the caller to process with the whole team.
// With one thread all runs are small.
template <class Equal, class MakeEach>
void for_each_run(Team& team, Allocator& allocator, std::size_t begin, std::size_t end,
                  std::size_t least, Equal equal, const MakeEach& make_each, Buffer<Run>& large) {
    constexpr std::size_t min_items_per_thread = 32768;
    const std::size_t n = end - begin;
    const unsigned members = team.members_for(n, min_items_per_thread);
    if (members == 1) {
        auto each = make_each();
        for_each_run(begin, end, equal, [&](std::size_t first, std::size_t last) {
            if (last - first >= least) each(first, last);
        });
        return;
    }
    // Runs of the same length may take different times, so there are more pieces than threads.
    const std::size_t pieces = std::size_t{16} * members;
    // Find where the runs of each piece begin before any items change.
    Buffer<std::size_t> first(allocator);
    first.resize(pieces + 1);
    first[pieces] = end;
    for (std::size_t p = pieces, next = end; p-- > 0;) {
        const std::size_t from = begin + n / pieces * p + n % pieces * p / pieces;
        std::size_t k = from;
        while (k > begin && k < next && equal(k - 1, k)) ++k;
        first[p] = k < next ? k : first[p + 1];
        next = from;
    }
    std::mutex mutex;
    Atomic<std::size_t> taken{0};
    team.run(members, [&](unsigned) {
        auto each = make_each();
        for (std::size_t p = taken++; p < pieces; p = taken++)
            for_each_run(first[p], first[p + 1], equal, [&](std::size_t k, std::size_t next) {
                if (next - k >= 2 * min_items_per_thread) {
                    const std::lock_guard<std::mutex> lock(mutex);
                    large.push_back({k, next});
                } else if (next - k >= least) {
                    each(k, next);
                }
            });
    });
}

}  // namespace mgdt
