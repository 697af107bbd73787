// SPDX-License-Identifier: MIT
// Sends points to their homes. Equal points become one vertex, and the vertices of all parts are
// numbered.
#pragma once

#include "parts/homes.hpp"
#include "parts/part.hpp"
#include "platform/objects.hpp"

namespace mgdt {

// Collective. Distributes the points that were inserted into the local parts, with ids or without,
// to `parts`. The vertices of part p get the numbers first_vertex[p] to first_vertex[p + 1] - 1.
// `of_given` has the vertex number of each point that was inserted into a local part.
void settle_points(Collective& all, const Homes& homes, const GivenPoints* given,
                   const std::int64_t* const* ids, Objects<Part>& parts,
                   Buffer<std::int64_t>& first_vertex, Objects<Buffer<std::int64_t>>& of_given,
                   Allocator& allocator);

}  // namespace mgdt
