// SPDX-License-Identifier: MIT
// Divides a loop among the members of a team, reports its progress, and stops it on request.
#pragma once

#include <algorithm>

#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

// Calls body(begin, end) for consecutive ranges of 0..n-1, which are much shorter than the share of
// a member, as Team::split() does for these shares. The loop is a stage of `progress`.
template <class Body>
void watched_split(Team& team, StageProgress& progress, std::size_t n,
                   std::size_t min_items_per_thread, Body&& body) {
    constexpr std::size_t most = 1024;
    team.split(n, min_items_per_thread, [&](std::size_t begin, std::size_t end, unsigned member) {
        for (std::size_t from = begin; from < end; from += most) {
            progress.look(from - begin, end - begin, member);
            body(from, std::min(from + most, end));
        }
    });
}

}  // namespace mgdt
