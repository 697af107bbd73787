// SPDX-License-Identifier: MIT
// Marks of the members of a cavity in a table of the thread's own, one after the other.
#pragma once

#include "kernel/thread_state.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// Puts those in whose bits are set; returns which of them were not in before. A view by value,
// which stays in registers elsewhere.
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
