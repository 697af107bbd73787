// SPDX-License-Identifier: MIT
// The powers of a point with respect to four tetrahedra at once, such as the neighbours of one:
//
//   power = |u|^2 - w . u   with u = q - p, p the base vertex, w of its sphere
//   error = |e| (|u.x| + |u.y| + |u.z|) + quadratic |u|^2
//
// as power() of circumsphere.hpp computes them; a ghost's have no |u|^2. Each island has
//
//   QueryRows(query)                          q, ready to be asked about
//   FourPowers(spheres, four, query or rows)  the four powers:
//     [k]                                     the k-th
//     .least_finite(bound)                    which finite one is least, if below the bound; else 4
//   and as bits, the first tetrahedron in the lowest:
//     .negative()                             where the power is negative
//     .decided()                              where it is certain whether it is
//     .ghosts()                               which are ghosts
//     .above(power)                           where it, or that of a ghost, is certainly above that
//                                             of a tetrahedron, or of none
#pragma once

#include "kernel/island.hpp"
#include MGDT_IN_ISLAND(powers.hpp)
