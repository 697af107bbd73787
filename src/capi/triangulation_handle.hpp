// SPDX-License-Identifier: MIT
// The handle of a triangulation behind the C interface, and what its entry points share.
#pragma once

#include <limits>

#include "capi/handle.hpp"
#include "core/triangulation.hpp"
#include "query/mesh_view.hpp"

struct mgdt_triangulation : mgdt::Handle<mgdt::Triangulation> {
    using Handle::Handle;
};

namespace mgdt {

// The view that exports and queries of a handle use. Tetrahedra are numbered when numbers are
// needed for the first time.
inline MeshView view_of(Team& team, const mgdt_triangulation* t, bool numbers) {
    const Triangulation& core = t->object;
    return {team,
            core.mesh(),
            numbers ? &core.numbering(team) : nullptr,
            core.allocator(),
            core.settings().index_base,
            core.settings().canonical_output};
}

// Refuses an export if values up to `end`, counted from 0, do not fit Int.
template <class Int>
void require_range(std::uint64_t end, const mgdt_triangulation* t) {
    if (end == 0) return;
    const std::uint64_t largest =
        end - 1 + static_cast<std::uint64_t>(t->object.settings().index_base);
    if (largest > static_cast<std::uint64_t>(std::numeric_limits<Int>::max()))
        fail(MGDT_ERR_INDEX_RANGE, "indices up to %llu do not fit a 32-bit integer",
             static_cast<unsigned long long>(largest));
}

// Refuses points that do not span space, but not an empty triangulation.
inline void require_space(const mgdt_triangulation* t, const char* what) {
    static constexpr const char* where[] = {"at one place", "on one line", "in one plane"};
    if (t->object.vertex_count() > 0 && t->object.dimension() < 3)
        fail(MGDT_ERR_INVALID_ARGUMENT, "there are no %s: all points are %s", what,
             where[t->object.dimension()]);
}

}  // namespace mgdt
