// SPDX-License-Identifier: MIT
// Stops the compilation if the compiler's arithmetic is not that of IEEE 754, since exactness would
// be lost silently. Compilers announce such arithmetic by macros; meson.build refuses the flags.
#pragma once

#include <cfloat>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "mgdt is exact and cannot be compiled with -ffast-math, -Ofast or a part of them"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
// On 32-bit x86, compilers use the x87 unit by default.
#error \
    "mgdt is exact and needs doubles that are computed as doubles: on 32-bit x86 compile with -msse2 -mfpmath=sse, which are meson setup build -Dc_args='-msse2 -mfpmath=sse' -Dcpp_args='-msse2 -mfpmath=sse'"
#endif
static_assert(FLT_RADIX == 2 && DBL_MANT_DIG == 53 && DBL_MAX_EXP == 1024,
              "mgdt is exact for IEEE 754 doubles");
static_assert(sizeof(0.1) == sizeof(double) && 0.1 != static_cast<double>(0.1f),
              "mgdt is exact and cannot be compiled with -fsingle-precision-constant");
