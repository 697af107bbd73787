// SPDX-License-Identifier: MIT
// The kernel is compiled once for each instruction set. What its headers define stands in a
// namespace of that set's name, so that the linker never takes one set's copy for another's.
// MGDT_ISA is defined by the kernel_*.cpp files; everybody else gets the baseline.
#pragma once

#if !defined(MGDT_ISA)
#define MGDT_ISA baseline
#endif
