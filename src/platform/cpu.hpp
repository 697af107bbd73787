// SPDX-License-Identifier: MIT
// The instruction sets of the processor.
#pragma once

namespace mgdt {

struct CpuFeatures {
    bool avx2 = false;    // and FMA, BMI 1 and 2, LZCNT, POPCNT
    bool avx512 = false;  // F, VL, DQ, BW, and all of avx2
};

// Executes CPUID, which Valgrind intercepts to hide AVX-512. The compiler's __builtin_cpu_supports
// would do the same, but runs code when the library is loaded.
CpuFeatures cpu_features() noexcept;

}  // namespace mgdt
