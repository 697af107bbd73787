// SPDX-License-Identifier: MIT
#include "platform/cpu.hpp"

#include "platform/atomic.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#include <cpuid.h>
#endif

namespace mgdt {

static CpuFeatures ask() noexcept {
    CpuFeatures features;
#if defined(__x86_64__) && defined(__GNUC__)
    unsigned eax, ebx, ecx, edx;
    if (!__get_cpuid(1, &eax, &ebx, &ecx, &edx)) return features;
    const bool fma = ecx & bit_FMA, popcnt = ecx & bit_POPCNT, saves = ecx & bit_OSXSAVE;
    const bool lzcnt = __get_cpuid(0x80000001, &eax, &ebx, &ecx, &edx) && (ecx & bit_LZCNT);
    if (!saves || !__get_cpuid_count(7, 0, &eax, &ebx, &ecx, &edx)) return features;
    const bool bits = popcnt && lzcnt && (ebx & bit_BMI) && (ebx & bit_BMI2);
    // The operating system has to save the registers, too: bits 1 and 2 for AVX, 5 to 7 for
    // AVX-512.
    unsigned low, high;
    __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    features.avx2 = (low & 0x06) == 0x06 && fma && bits && (ebx & bit_AVX2);
    constexpr unsigned needed = bit_AVX512F | bit_AVX512VL | bit_AVX512DQ | bit_AVX512BW;
    features.avx512 = features.avx2 && (low & 0xE0) == 0xE0 && (ebx & needed) == needed;
#endif
    return features;
}

CpuFeatures cpu_features() noexcept {
    // The features are cached, since CPUID takes microseconds in a virtual machine.
    static Atomic<unsigned> known{0};
    unsigned bits = known.load(std::memory_order_relaxed);
    if (bits == 0) {
        const CpuFeatures features = ask();
        bits = 1u | (features.avx2 ? 2u : 0u) | (features.avx512 ? 4u : 0u);
        known.store(bits, std::memory_order_relaxed);
    }
    CpuFeatures features;
    features.avx2 = (bits & 2) != 0;
    features.avx512 = (bits & 4) != 0;
    return features;
}

}  // namespace mgdt
