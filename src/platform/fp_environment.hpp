// SPDX-License-Identifier: MIT
// Sets the floating-point environment that exact arithmetic needs: rounding to nearest, subnormal
// numbers, no traps. Callers may have enabled flush-to-zero (gfortran -Ofast), traps (-ffpe-trap)
// or another rounding mode. The destructor restores their environment bit for bit.
#pragma once

#include <cstdint>

#if defined(__x86_64__) || defined(_M_X64)
#include <xmmintrin.h>
#define MGDT_FP_MXCSR 1
#elif !defined(__aarch64__)
#include <cfenv>
#endif

namespace mgdt {

class FpEnvironment {
  public:
#if MGDT_FP_MXCSR
    // On x86-64 the library does not use the x87 unit, as it has no long double.
    FpEnvironment() noexcept : saved_(_mm_getcsr()) {
        _mm_setcsr(0x1F80);
    }
    ~FpEnvironment() {
        _mm_setcsr(saved_);
    }
#elif defined(__aarch64__)
    FpEnvironment() noexcept {
        std::uint64_t clear = 0;
        __asm__ volatile("mrs %0, fpcr" : "=r"(saved_));
        __asm__ volatile("mrs %0, fpsr" : "=r"(status_));
        __asm__ volatile("msr fpcr, %0" : : "r"(clear));
    }
    ~FpEnvironment() {
        __asm__ volatile("msr fpsr, %0" : : "r"(status_));
        __asm__ volatile("msr fpcr, %0" : : "r"(saved_));
    }
#else
    FpEnvironment() noexcept {
        std::fegetenv(&saved_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~FpEnvironment() {
        std::fesetenv(&saved_);
    }
#endif
    FpEnvironment(const FpEnvironment&) = delete;
    FpEnvironment& operator=(const FpEnvironment&) = delete;

  private:
#if MGDT_FP_MXCSR
    unsigned saved_;
#elif defined(__aarch64__)
    std::uint64_t saved_ = 0;
    std::uint64_t status_ = 0;
#else
    std::fenv_t saved_;
#endif
};

}  // namespace mgdt
