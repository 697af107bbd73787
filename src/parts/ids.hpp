// SPDX-License-Identifier: MIT
// The ids that callers give to points.
#pragma once

#include "parts/collective.hpp"
#include "parts/homes.hpp"

namespace mgdt {

// Collective. Throws if two different points have the same id. `given`, `ids` and `vertices` have
// the points of each local part, their ids, and the numbers of their vertices.
void require_distinct_ids(Collective& all, const GivenPoints* given, const std::int64_t* const* ids,
                          const Objects<Buffer<std::int64_t>>& vertices, Allocator& allocator);

}  // namespace mgdt
