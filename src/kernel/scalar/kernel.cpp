// SPDX-License-Identifier: MIT
// The kernel for the instruction set that the library is compiled for.
#define MGDT_ISLAND scalar
#include "kernel/insert.hpp"

namespace mgdt {

extern const Kernel baseline_kernel;
constexpr Kernel baseline_kernel = kernel_named("baseline");

}  // namespace mgdt
