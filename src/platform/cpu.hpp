// SPDX-License-Identifier: MIT
// The instruction sets of the processor.
#pragma once

namespace mgdt {

struct CpuFeatures {
    bool avx2 = false;    // AVX2 together with FMA, BMI 1 and 2, LZCNT and POPCNT
    bool avx512 = false;  // AVX-512 F, VL, DQ and BW, together with all of avx2
};

// Executes CPUID, which Valgrind intercepts to hide AVX-512. The compiler's __builtin_cpu_supports
// would do the same, but runs code when the library is loaded.
CpuFeatures cpu_features() noexcept;

}  // namespace mgdt
