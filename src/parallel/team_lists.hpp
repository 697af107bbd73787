// SPDX-License-Identifier: MIT
// A stable counting sort by a team. The result does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <cstdint>

#include "parallel/team.hpp"
#include "platform/memory.hpp"

namespace mgdt {

// Each of `items` items yields values with keys. The function sorts the values into one list per
// key; within a list, values are in the order of the items.
//
// each(begin, end, f) calls f(key, value...) for every value of items begin..end-1, in the order of
// the items. There are fewer than 2^32 values. each() sees each item twice: to count the values,
// and to store them. Members of the team call each() at the same time, for at least
// `min_items_per_thread` items per member. Between the two passes, make_room(size) is told the
// number of values. put(position, value...) stores a value. List k is at positions ends[k] to
// ends[k + 1] - 1; `ends` has keys + 1 elements.
template <class Int, class Each, class MakeRoom, class Put>
void make_lists(Team& team, Allocator& allocator, std::size_t items,
                std::size_t min_items_per_thread, std::size_t keys, Int* ends, Each each,
                MakeRoom make_room, Put put) {
    ends[0] = 0;
    // Each member has a counter per key. With more members, the memory for counters would grow by
    // more than the time shrinks.
    constexpr unsigned most_members = 16;
    const unsigned members = std::min(most_members, team.members_for(items, min_items_per_thread));
    if (members == 1) {
        // ends[k + 1] is first the length of list k, then its beginning. Storing the values
        // advances the beginning to the end of the list.
        std::fill_n(ends + 1, keys, Int{0});
        each(std::size_t{0}, items, [&](std::size_t key, const auto&...) { ++ends[key + 1]; });
        Int sum = 0;
        for (std::size_t k = 1; k <= keys; ++k) {
            const Int count = ends[k];
            ends[k] = sum;
            sum += count;
        }
        make_room(static_cast<std::size_t>(sum));
        each(std::size_t{0}, items, [&](std::size_t key, const auto&... value) {
            put(static_cast<std::size_t>(ends[key + 1]++), value...);
        });
        return;
    }
    // The counters of each member are on cache lines of their own.
    constexpr std::size_t line = 64 / sizeof(std::uint32_t);
    const std::size_t row = (keys + line - 1) / line * line;
    Buffer<std::uint32_t> next(allocator, members * row);
    const auto next_of = [&](unsigned m) { return next.data() + m * row; };
    const auto each_of = [&](unsigned m, auto f) {
        each(Team::part(items, m, members), Team::part(items, m + 1, members), f);
    };
    team.run(members, [&](unsigned m) {
        std::uint32_t* const count = next_of(m);
        std::fill_n(count, keys, 0u);
        each_of(m, [&](std::size_t key, const auto&...) { ++count[key]; });
    });
    // Prefix sums give the position where the values of each member begin in each list. The members
    // divide the keys among themselves.
    const auto first_key = [&](unsigned m) { return Team::part(keys, m, members); };
    std::uint32_t sums[most_members + 1] = {};
    team.run(members, [&](unsigned part) {
        std::uint32_t sum = 0;
        for (unsigned m = 0; m < members; ++m)
            for (std::size_t k = first_key(part); k < first_key(part + 1); ++k)
                sum += next_of(m)[k];
        sums[part + 1] = sum;
    });
    for (unsigned m = 0; m < members; ++m) sums[m + 1] += sums[m];
    make_room(std::size_t{sums[members]});
    team.run(members, [&](unsigned part) {
        std::uint32_t sum = sums[part];
        for (std::size_t k = first_key(part); k < first_key(part + 1); ++k) {
            for (unsigned m = 0; m < members; ++m) {
                const std::uint32_t count = next_of(m)[k];
                next_of(m)[k] = sum;
                sum += count;
            }
            ends[k + 1] = static_cast<Int>(sum);
        }
    });
    team.run(members, [&](unsigned m) {
        std::uint32_t* const to = next_of(m);
        each_of(m, [&](std::size_t key, const auto&... value) {
            put(std::size_t{to[key]++}, value...);
        });
    });
}

}  // namespace mgdt
