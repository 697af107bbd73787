// SPDX-License-Identifier: MIT
// Marks on four tetrahedra at a time, as many as a step visits: see kernel/cavity_marks.hpp.
#pragma once

#include "kernel/four/cavity_marks.hpp"
