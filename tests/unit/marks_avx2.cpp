// SPDX-License-Identifier: MIT
#define MGDT_ISA avx2_test
#include "marks.hpp"

FourAtATime four_at_a_time_avx2() {
    return mgdt::four_at_a_time();
}
