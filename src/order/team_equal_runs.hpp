// SPDX-License-Identifier: MIT
// Runs of consecutive items that are equal, shared among a team: as equal_runs.hpp, whatever its
// size.
#pragma once

#include <mutex>

#include "order/equal_runs.hpp"
#include "parallel/team.hpp"
#include "platform/atomic.hpp"

namespace mgdt {

struct Run {
    std::size_t begin, end;
};

// Finds the runs of items begin..end-1 with equal(i, j) from `least` items on. Each member of the
// team that takes part makes itself each = make_each() and calls each(begin, end) for small runs,
// whose items that may change. The large ones are added to `large`, in any order, for all of the
// team to take one after another; with one member all are small.
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
    // Runs can take much longer than others of the same length: more pieces than members.
    const std::size_t pieces = std::size_t{16} * members;
    // Where each piece's runs begin, before any of them may be changed.
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
