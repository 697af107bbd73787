/* SPDX-License-Identifier: MIT
 * The control and status registers of floating point, whole, for test_environment.f90. */
#include <stdint.h>
#if defined(__x86_64__)
#include <xmmintrin.h>
#elif !defined(__aarch64__)
#include <fenv.h>
#endif

int64_t environment_now(void) {
#if defined(__x86_64__)
    uint16_t x87;
    __asm__ volatile("fnstcw %0" : "=m"(x87));
    return (int64_t)_mm_getcsr() << 16 | x87;
#elif defined(__aarch64__)
    uint64_t control, status;
    __asm__ volatile("mrs %0, fpcr" : "=r"(control));
    __asm__ volatile("mrs %0, fpsr" : "=r"(status));
    return (int64_t)(control << 32 | (status & 0xFFFFFFFFu));
#else
    return (int64_t)fegetround() << 32 | fetestexcept(FE_ALL_EXCEPT);
#endif
}
