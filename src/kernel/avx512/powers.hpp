// SPDX-License-Identifier: MIT
// Powers with respect to four tetrahedra, as many as a step visits: see kernel/powers.hpp.
#pragma once

#include "kernel/four/powers.hpp"
