// SPDX-License-Identifier: MIT
// What the cells of a triangulation are computed from.
#pragma once

#include "capi/counts.hpp"
#include "capi/planes.hpp"
#include "capi/triangulation_handle.hpp"
#include "core/spanned_copy.hpp"
#include "dual/region.hpp"
#include "platform/objects.hpp"

namespace mgdt {

// Calls f(view, region, far) for a triangulation that has vertices. If its points do not span
// space, the view is that of a copy that does (core/spanned_copy.hpp), and `far` is the number of
// vertices that the copy has besides; otherwise it is 0. Memory comes from `allocator`.
template <class F>
void with_cell_view(const mgdt_triangulation* t, Allocator& allocator, std::size_t n_planes,
                    const double* planes, const F& f) {
    const Triangulation& core = t->object;
    const std::int32_t base = core.settings().index_base;
    const auto points = static_cast<std::size_t>(point_count(core));
    constexpr std::size_t vertices_per_thread = 4096;
    Team team(core.threads_for(points, vertices_per_thread));
    const bool canonical = core.settings().canonical_output;
    const auto call = [&](const Mesh& mesh, const Region& region, std::size_t far) {
        f(MeshView{team, mesh, nullptr, allocator, base, canonical}, region, far);
    };
    if (n_planes == 0) require_space(t, "cells");
    const Region own(allocator, n_planes, planes, core.mesh(), base);
    if (core.dimension() == 3) return call(core.mesh(), own, 0);
    // A triangulation is too large for the stack.
    Objects<Triangulation> place(allocator, 1, &Allocator::allocate_from, &Allocator::release_to,
                                 static_cast<void*>(&allocator));
    Triangulation& copy = place[0];
    copy.settings().threads = core.settings().threads;
    copy_spanned(core, scaled(own.extent(), -core.mesh().scale), points, copy);
    // The scale of the copy may differ, so it has a region of its own.
    call(copy.mesh(), Region(allocator, n_planes, planes, copy.mesh(), base, points), far_points);
}

}  // namespace mgdt
