// SPDX-License-Identifier: MIT
// How points come home: each part gets its own, equal ones become one vertex, and the vertices of
// all parts are numbered.
#pragma once

#include "parts/homes.hpp"
#include "parts/part.hpp"
#include "platform/objects.hpp"

namespace mgdt {

// Collective. What the local parts are given, with ids or without, goes to `parts`. The vertices of
// part p get the numbers from first_vertex[p] to before first_vertex[p + 1], and `of_given` has the
// number of the vertex of each point that a local part was given.
void settle_points(Collective& all, const Homes& homes, const GivenPoints* given,
                   const std::int64_t* const* ids, Objects<Part>& parts,
                   Buffer<std::int64_t>& first_vertex, Objects<Buffer<std::int64_t>>& of_given,
                   Allocator& allocator);

}  // namespace mgdt
