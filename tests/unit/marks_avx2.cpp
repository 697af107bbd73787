// SPDX-License-Identifier: MIT
#define MGDT_ISLAND avx2
#include "marks.hpp"

FourAtATime four_at_a_time_avx2() {
    return mgdt::four_at_a_time();
}
