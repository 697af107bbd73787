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

namespace mgdt {

void free_voronoi(mgdt_voronoi* v) noexcept;
// A handle without cells, whose memory comes from where that of `source` comes, and with the same
// limit. Throws std::bad_alloc.
mgdt_voronoi* new_voronoi(const Allocator& source, std::int32_t index_base);

// Makes the handle of the diagram that build(diagram) sets, inside of a call on another handle.
// Throws with nothing left.
template <class Build>
mgdt_voronoi* make_voronoi(const Allocator& source, std::int32_t index_base, const Build& build) {
    mgdt_voronoi* const v = new_voronoi(source, index_base);
    try {
        build(v->diagram);
    } catch (...) {
        free_voronoi(v);
        throw;
    }
    return v;
}

}  // namespace mgdt
