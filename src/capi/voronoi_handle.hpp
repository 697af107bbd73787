// SPDX-License-Identifier: MIT
// The handle of a Voronoi diagram behind the C interface.
#pragma once

#include "capi/guard.hpp"
#include "mgdt/mgdt_voronoi.h"
#include "voronoi/voronoi.hpp"

struct mgdt_voronoi : mgdt::HandleBase {
    mgdt_voronoi(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user)
        : allocator(alloc, release, user), diagram(allocator) {}

    mgdt::Allocator allocator;
    mgdt::VoronoiDiagram diagram;
    std::int32_t index_base = 0;
};
