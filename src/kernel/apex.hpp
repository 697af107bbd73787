// SPDX-License-Identifier: MIT
// find_apex(): the apex of a facet in the hole of a removed vertex, if floating-point arithmetic
// decides (hole/vertex_removal.hpp). Each island has an implementation, which tests the whole
// link with vectors.
#pragma once

#include "kernel/circumsphere.hpp"
#include "kernel/kernel.hpp"

#include MGDT_IN_ISLAND(apex.hpp)
