// SPDX-License-Identifier: MIT
// find_apex() finds the apex of a facet in the hole of a removed vertex, if floating-point
// arithmetic decides (hole/vertex_removal.hpp). The implementation in each island with vectors
// tests several vertices of the link at a time.
#pragma once

#include "kernel/circumsphere.hpp"
#include "kernel/kernel.hpp"

#include MGDT_IN_ISLAND(apex.hpp)
