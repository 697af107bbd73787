// SPDX-License-Identifier: MIT
// Marks of the members of a cavity, put on four different tetrahedra at a time without an
// unpredictable branch: in the tetrahedra themselves, or, among other threads, in a table of the
// thread's own. Each island has
//
//   put_four(marks, codes, which)   puts those in the table whose bits are set;
//                                   returns which of them were not in before
//   mark_four(four, which)          marks those tetrahedra;
//                                   returns which of them had no mark before
#pragma once

#include "kernel/island.hpp"
#include MGDT_IN_ISLAND(cavity_marks.hpp)
