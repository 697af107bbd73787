// SPDX-License-Identifier: MIT
// What the processor can do.
#pragma once

namespace mgdt {

struct CpuFeatures {
    bool avx2 = false;    // and FMA, BMI 1 and 2, LZCNT, POPCNT
    bool avx512 = false;  // F, VL, DQ, BW, and all of avx2
};

// Asked of the processor itself: Valgrind, which has no AVX-512, hides it there. The compiler's
// own __builtin_cpu_supports would do the same, but runs code when the library is loaded.
CpuFeatures cpu_features() noexcept;

}  // namespace mgdt
