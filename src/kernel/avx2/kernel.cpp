// SPDX-License-Identifier: MIT
// The kernel for AVX2 and FMA.
#define MGDT_ISLAND avx2
#include "kernel/insert.hpp"

namespace mgdt {

extern const Kernel avx2_kernel;
constexpr Kernel avx2_kernel = kernel_named("avx2");

}  // namespace mgdt
