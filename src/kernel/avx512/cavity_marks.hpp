// SPDX-License-Identifier: MIT
// Marks on four tetrahedra at a time: see kernel/cavity_marks.hpp. A step looks at four.
#pragma once

#include "kernel/four/cavity_marks.hpp"
