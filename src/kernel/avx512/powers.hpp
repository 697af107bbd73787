// SPDX-License-Identifier: MIT
// Powers with respect to four tetrahedra: see kernel/powers.hpp. Four are all that a step looks at.
#pragma once

#include "kernel/four/powers.hpp"
