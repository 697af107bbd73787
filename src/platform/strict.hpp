// SPDX-License-Identifier: MIT
// Refuses to be compiled with rules of arithmetic other than those of IEEE 754, with which
// exactness would be lost silently. Compilers announce such rules by macros; meson.build refuses
// the flags.
#pragma once

#include <cfloat>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "mgdt is exact and cannot be compiled with -ffast-math, -Ofast or a part of them"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
// 32-bit x86 computes in the x87 unit by default.
#error \
    "mgdt is exact and needs doubles that are computed as doubles: on 32-bit x86 compile with -msse2 -mfpmath=sse, which are meson setup build -Dc_args='-msse2 -mfpmath=sse' -Dcpp_args='-msse2 -mfpmath=sse'"
#endif
static_assert(FLT_RADIX == 2 && DBL_MANT_DIG == 53 && DBL_MAX_EXP == 1024,
              "mgdt is exact for IEEE 754 doubles");
static_assert(sizeof(0.1) == sizeof(double) && 0.1 != static_cast<double>(0.1f),
              "mgdt is exact and cannot be compiled with -fsingle-precision-constant");
