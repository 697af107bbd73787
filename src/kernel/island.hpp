// SPDX-License-Identifier: MIT
// The kernel is compiled once for each instruction set. What its headers define stands in a
// namespace of that set's name, so that the linker never takes one set's copy for another's.
//
// All that is written for one instruction set alone stands in its island, the folder of its name. A
// kernel header that has a part in each island says what it gives and includes the part by
// MGDT_IN_ISLAND. Each island's kernel.cpp defines MGDT_ISLAND; every other file gets the
// scalar island.
#pragma once

#if !defined(MGDT_ISLAND)
#define MGDT_ISLAND scalar
#endif

#define MGDT_TEXT_OF(name) #name
#define MGDT_TEXT(name) MGDT_TEXT_OF(name)
// clang-format off
#define MGDT_IN_ISLAND(file) MGDT_TEXT(kernel/MGDT_ISLAND/file)
// clang-format on
