// SPDX-License-Identifier: MIT
// Marks on four tetrahedra at a time, because a step visits four: see kernel/cavity_marks.hpp.
#pragma once

#include "kernel/four/cavity_marks.hpp"
