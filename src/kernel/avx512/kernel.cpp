// SPDX-License-Identifier: MIT
// The kernel for AVX-512 F, VL, DQ, BW.
#define MGDT_ISA avx512
#include "kernel/kernel_table.hpp"

namespace mgdt {

extern const Kernel avx512_kernel;
constexpr Kernel avx512_kernel MGDT_KERNEL_TABLE;

}  // namespace mgdt
