// SPDX-License-Identifier: MIT
// Marks of the members of a cavity, put on four different tetrahedra at a time without an
// unpredictable branch. The marks are in the tetrahedra, or, if other threads read them, in a table
// of the thread's own. Each island has
//
//   put_four(marks, codes, which)   adds to the table the tetrahedra whose bits are set;
//                                   returns which of them were not in the table before
//   mark_four(four, which)          marks the tetrahedra whose bits are set;
//                                   returns which of them had no mark before
#pragma once

#include "kernel/island.hpp"
#include MGDT_IN_ISLAND(cavity_marks.hpp)
