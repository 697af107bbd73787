// SPDX-License-Identifier: MIT
// The kernel for 64-bit ARM, whose vectors have two doubles.
#define MGDT_ISLAND neon
#include "kernel/insert.hpp"

namespace mgdt {

extern const Kernel neon_kernel;
constexpr Kernel neon_kernel = kernel_named("neon");

}  // namespace mgdt
