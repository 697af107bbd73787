// SPDX-License-Identifier: MIT
// Marks on four tetrahedra: see kernel/cavity_marks.hpp.
#pragma once

#include "kernel/mark_one_by_one.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

MGDT_ALWAYS_INLINE std::uint32_t put_four(const MarkTable::View& marks, const FacetCode* codes,
                                          std::uint32_t which) {
    return put_one_by_one(marks, codes, which);
}

template <class Tetrahedra>
MGDT_ALWAYS_INLINE std::uint32_t mark_four(const Tetrahedra& four, std::uint32_t which) {
    std::uint32_t marked = 0;
    for (unsigned k = 0; k < 4; ++k) {
        const VertexId second = four[k].v[1];
        marked |= second >> 31 << k;
        four[k].v[1] = second | (hide_from_optimizer(which >> k) << 31);
    }
    return which & ~marked;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
