// SPDX-License-Identifier: MIT
// Marks members of a cavity in the thread-local table, one after the other.
#pragma once

#include "kernel/thread_state.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// Adds the tetrahedra whose bits are set, and returns which of them are new. The view is passed by
// value, so that the caller can keep its own in registers.
inline std::uint32_t put_one_by_one(MarkTable::View marks, const FacetCode* codes,
                                    std::uint32_t which) {
    std::uint32_t fresh = 0;
    for (unsigned k = 0; k < 4; ++k) {
        const std::uint32_t is_in = which >> k & 1;
        fresh |= (is_in & marks.put(tetrahedron_of(codes[k]), is_in)) << k;
    }
    return fresh;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
