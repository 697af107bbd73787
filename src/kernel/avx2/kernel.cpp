// SPDX-License-Identifier: MIT
// The kernel for AVX2 and FMA.
#define MGDT_ISA avx2
#include "kernel/kernel_table.hpp"

namespace mgdt {

extern const Kernel avx2_kernel;
constexpr Kernel avx2_kernel MGDT_KERNEL_TABLE;

}  // namespace mgdt
