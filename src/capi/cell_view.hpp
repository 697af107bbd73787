// SPDX-License-Identifier: MIT
// What the cells of a triangulation are computed from.
#pragma once

#include "capi/counts.hpp"
#include "capi/handle.hpp"
#include "capi/planes.hpp"
#include "core/spanned_copy.hpp"
#include "dual/region.hpp"
#include "platform/objects.hpp"

namespace mgdt {

// Calls f(view, region, far) for a triangulation that has vertices. Points that do not span space
// have cells within a region: then the view is that of a spanned_copy.hpp, and far_points vertices
// have larger indices than all points; otherwise `far` is 0. Memory comes from `allocator`.
template <class F>
void with_cell_view(const mgdt_triangulation* t, Allocator& allocator, std::size_t n_planes,
                    const double* planes, const F& f) {
    const Triangulation& core = t->core;
    const std::int32_t base = core.settings().index_base;
    const auto points = static_cast<std::size_t>(point_count(core));
    constexpr std::size_t vertices_per_thread = 4096;
    Team team(core.threads_for(points, vertices_per_thread));
    const bool canonical = core.settings().canonical_output;
    if (core.dimension() == 3 || n_planes == 0) {
        require_space(t, "cells");
        const ExportView view = {team, core.mesh(), nullptr, allocator, base, canonical};
        f(view, Region(allocator, n_planes, planes, core.mesh(), base, points), std::size_t{0});
        return;
    }
    const Region flat(allocator, n_planes, planes, core.mesh(), base, points);
    // A triangulation is too large for the stack.
    Objects<Triangulation> place(allocator, 1, &Allocator::allocate_from, &Allocator::release_to,
                                 static_cast<void*>(&allocator));
    Triangulation& copy = place[0];
    copy.settings().threads = core.settings().threads;
    copy_spanned(core, scaled(flat.extent(), -core.mesh().scale), points, copy);
    const ExportView view = {team, copy.mesh(), nullptr, allocator, base, canonical};
    f(view, Region(allocator, n_planes, planes, copy.mesh(), base, points), far_points);
}

}  // namespace mgdt
