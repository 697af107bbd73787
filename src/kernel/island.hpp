// SPDX-License-Identifier: MIT
// The namespace and the includes of an island, the part of the kernel that is compiled for one
// instruction set. The kernel is compiled once for each set. Its headers define everything in a
// namespace named after the set, so that the linker never takes one set's function for another's.
//
// The island of an instruction set is the folder of its name, which has all code that is written
// for this set alone. The island of AVX-512 also includes vectors of the island of AVX2, which
// every processor with AVX-512 has. A kernel header with an implementation in each island documents
// the functions, and includes the implementation by MGDT_IN_ISLAND. Each island's kernel.cpp
// defines MGDT_ISLAND; every other file gets the scalar island.
#pragma once

#if !defined(MGDT_ISLAND)
#define MGDT_ISLAND scalar
#endif

#define MGDT_TEXT_OF(name) #name
#define MGDT_TEXT(name) MGDT_TEXT_OF(name)
// clang-format off
#define MGDT_IN_ISLAND(file) MGDT_TEXT(kernel/MGDT_ISLAND/file)
// clang-format on
