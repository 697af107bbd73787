// SPDX-License-Identifier: MIT
// Runs of consecutive items that are equal.
#pragma once

#include <cstddef>

namespace mgdt {

// The end of the run of equal items that begins at `begin`; at most `end`.
template <class Equal>
std::size_t end_of_run(std::size_t begin, std::size_t end, Equal equal) {
    std::size_t next = begin + 1;
    while (next < end && equal(begin, next)) ++next;
    return next;
}

// Calls each(begin, end) for each run of equal items in begin..end-1; equal(i, j) compares items.
template <class Equal, class Each>
void for_each_run(std::size_t begin, std::size_t end, Equal equal, Each each) {
    for (std::size_t k = begin; k < end;) {
        const std::size_t next = end_of_run(k, end, equal);
        each(k, next);
        k = next;
    }
}

}  // namespace mgdt
