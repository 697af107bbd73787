// SPDX-License-Identifier: MIT
// Conflicts near ties: see kernel/ties.hpp. A tetrahedron has four vertices.
#pragma once

#include "kernel/four/ties.hpp"
