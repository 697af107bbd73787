// SPDX-License-Identifier: MIT
// Words of 32 bits that a cavity and a star move four at a time. Each island has
//
//   append(to, words, bits)                   writes those of four words whose bits are set, and
//                                             may write anything to the rest of the 16 bytes;
//                                             returns the number of set bits
//   write_vertices(outside, code, q, out)     writes the vertices of the tetrahedron of q and a
//                                             facet, `code`, of the tetrahedron `outside`; returns
//                                             a pointer to the vertices of the facet
#pragma once

#include "kernel/island.hpp"
#include MGDT_IN_ISLAND(words.hpp)
