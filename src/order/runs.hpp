// SPDX-License-Identifier: MIT
// Runs of consecutive items that are equal.
#pragma once

#include <cstddef>

namespace mgdt {

// Calls each(begin, end) for the runs of items begin..end-1 with equal(i, j).
template <class Equal, class Each>
void for_each_run(std::size_t begin, std::size_t end, Equal equal, Each each) {
    for (std::size_t k = begin; k < end;) {
        std::size_t next = k + 1;
        while (next < end && equal(k, next)) ++next;
        each(k, next);
        k = next;
    }
}

}  // namespace mgdt
