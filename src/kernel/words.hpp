// SPDX-License-Identifier: MIT
// Words of 32 bits that a cavity and a star move four at a time. Each island has
//
//   append(to, words, bits)                   writes those of four words whose bits are set, and
//                                             anything in what is left of 16 bytes; returns how
//                                             many they are
//   write_vertices(outside, code, q, out)     writes the vertices of the tetrahedron of q and the
//                                             facet that a tetrahedron outside is reached through;
//                                             returns where those of the facet are
#pragma once

#include "kernel/island.hpp"
#include MGDT_IN_ISLAND(words.hpp)
