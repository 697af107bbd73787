// SPDX-License-Identifier: MIT
// The numbers that callers give to points.
#pragma once

#include "parts/collective.hpp"
#include "parts/homes.hpp"

namespace mgdt {

// Collective. Throws where two different points have one id. By local part: the points, their ids,
// and the numbers of their vertices.
void require_distinct_ids(Collective& all, const GivenPoints* given, const std::int64_t* const* ids,
                          const Objects<Buffer<std::int64_t>>& vertices, Allocator& allocator);

}  // namespace mgdt
