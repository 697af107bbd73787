// SPDX-License-Identifier: MIT
// The kernel for every processor of the architecture.
#define MGDT_ISA baseline
#include "kernel/kernel_table.hpp"

namespace mgdt {

extern const Kernel baseline_kernel;
constexpr Kernel baseline_kernel MGDT_KERNEL_TABLE;

}  // namespace mgdt
