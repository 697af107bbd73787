// SPDX-License-Identifier: MIT
// Conflicts near ties, for the four vertices of a tetrahedron: see kernel/ties.hpp.
#pragma once

#include "kernel/four/ties.hpp"
