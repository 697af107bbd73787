// SPDX-License-Identifier: MIT
// find_apex() finds the apex of a facet of a hole, if floating-point arithmetic decides
// (hole/filling.hpp). The implementation in each island with vectors tests several vertices at a
// time.
#pragma once

#include "kernel/circumsphere.hpp"
#include "kernel/kernel.hpp"

#include MGDT_IN_ISLAND(apex.hpp)
