// SPDX-License-Identifier: MIT
#define MGDT_ISA avx2_test
#include "kernel/marks.hpp"
#include "marks.hpp"

FourAtATime four_at_a_time_avx2() {
    return {[](const auto& marks, auto codes, auto which) {
                return mgdt::put_four(marks, codes, which);
            },
            [](const auto& four, auto which) { return mgdt::mark_four(four, which); },
            [](auto to, auto words, auto bits) { return mgdt::append(to, words, bits); }};
}
