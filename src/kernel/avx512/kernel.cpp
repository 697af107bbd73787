// SPDX-License-Identifier: MIT
// The kernel for AVX-512.
#define MGDT_ISLAND avx512
#include "kernel/insert.hpp"

namespace mgdt {

extern const Kernel avx512_kernel;
constexpr Kernel avx512_kernel = kernel_named("avx512");

}  // namespace mgdt
