// SPDX-License-Identifier: MIT
#define MGDT_ISA avx2_test
#include "kernel/marks.hpp"
#include "marks.hpp"

std::uint32_t put_four_avx2(const mgdt::MarkTable::View& marks, const mgdt::FacetCode* codes,
                            std::uint32_t which) {
    return mgdt::put_four(marks, codes, which);
}
