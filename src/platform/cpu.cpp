// SPDX-License-Identifier: MIT
#include "platform/cpu.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#include <cpuid.h>
#endif

namespace mgdt {

CpuFeatures cpu_features() noexcept {
    CpuFeatures features;
#if defined(__x86_64__) && defined(__GNUC__)
    unsigned eax, ebx, ecx, edx;
    if (!__get_cpuid(1, &eax, &ebx, &ecx, &edx)) return features;
    const bool fma = ecx & bit_FMA, saves = ecx & bit_OSXSAVE;
    if (!saves || !__get_cpuid_count(7, 0, &eax, &ebx, &ecx, &edx)) return features;
    // The system must save the registers too: bits 1, 2 for AVX, 5 to 7 for AVX-512.
    unsigned low, high;
    __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    features.avx2 = (low & 0x06) == 0x06 && fma && (ebx & bit_AVX2);
    constexpr unsigned needed = bit_AVX512F | bit_AVX512VL | bit_AVX512DQ | bit_AVX512BW;
    features.avx512 = features.avx2 && (low & 0xE0) == 0xE0 && (ebx & needed) == needed;
#endif
    return features;
}

}  // namespace mgdt
