// SPDX-License-Identifier: MIT
// Powers with respect to four tetrahedra, because a step visits four: see kernel/powers.hpp.
#pragma once

#include "kernel/four/powers.hpp"
