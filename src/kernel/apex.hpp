// SPDX-License-Identifier: MIT
// The apex of a facet in the hole of a vertex that is removed, where floating-point arithmetic
// decides: see kernel/vertex_removal.hpp. Each island has a part, whose find_apex() looks at the
// whole link with vectors.
#pragma once

#include "kernel/circumsphere.hpp"
#include "kernel/kernel.hpp"

#include MGDT_IN_ISLAND(apex.hpp)
