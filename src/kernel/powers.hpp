// SPDX-License-Identifier: MIT
// The powers of a point with respect to four tetrahedra at once, such as the neighbours of one:
//
//   power = |u|^2 - w . u   with u = q - p, p the base vertex, w of its sphere
//   error = |e| (|u.x| + |u.y| + |u.z|) + quadratic |u|^2
//
// as power() of circumsphere.hpp computes them; a ghost's power has no |u|^2. Each island has
//
//   QueryRows(query)                          q, in the form that FourPowers needs
//   FourPowers(spheres, four, query or rows)  the four powers:
//     [k]                                     the power of tetrahedron k, with its error
//     .least_finite(bound)                    the finite tetrahedron of least power, if that is
//                                             below the bound; otherwise 4
//   and as bits, the first tetrahedron in the lowest:
//     .negative()                             which powers are negative
//     .decided()                              which powers have a certain sign
//     .ghosts()                               which tetrahedra are ghosts
//     .above(power)                           which powers of finite tetrahedra are certainly above
//                                             this one, and which of ghosts certainly above 0
#pragma once

#include "kernel/island.hpp"
#include MGDT_IN_ISLAND(powers.hpp)
