// SPDX-License-Identifier: MIT
// Conflicts near ties, with the four vertices of a tetrahedron in one vector: see kernel/ties.hpp.
#pragma once

#include "kernel/four/ties.hpp"
