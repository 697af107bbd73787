// SPDX-License-Identifier: MIT
// What takes four tetrahedra into a cavity at a time, of kernel/cavity_marks.hpp and
// kernel/words.hpp, as it is compiled for one instruction set.
#pragma once

#include "kernel/cavity_marks.hpp"
#include "kernel/words.hpp"

struct FourAtATime {
    std::uint32_t (*put_four)(const mgdt::MarkTable::View& marks, const mgdt::FacetCode* codes,
                              std::uint32_t which);
    std::uint32_t (*mark_four)(const mgdt::FourTetrahedra<mgdt::TetrahedronAndSphere>& four,
                               std::uint32_t which);
    unsigned (*append)(std::uint32_t* to, const std::uint32_t* words, std::uint32_t bits);
};

FourAtATime four_at_a_time_avx2();

namespace mgdt {
inline namespace MGDT_ISLAND {

// That of the including file.
inline FourAtATime four_at_a_time() {
    return {[](const auto& marks, auto codes, auto which) { return put_four(marks, codes, which); },
            [](const auto& four, auto which) { return mark_four(four, which); },
            [](auto to, auto words, auto bits) { return append(to, words, bits); }};
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
