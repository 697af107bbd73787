// SPDX-License-Identifier: MIT
// A walk over the tetrahedra whose balls meet an unbounded set, from the hull inward.
#pragma once

#include <cstdint>

#include "mesh/mesh.hpp"
#include "platform/memory.hpp"
#include "platform/stop_request.hpp"

namespace mgdt {

// Calls visit(t) for every ghost, and for every tetrahedron that a ghost is connected with through
// neighbours for which meets() is true. If meets(t) tells whether the closed ball of t meets a
// closed set whose components are unbounded, these are all tetrahedra whose balls meet the set;
// meets() may err towards true. docs/theory.md, "Periodic boxes", has the proof. The mesh has
// tetrahedra.
template <class Meets, class Visit>
void walk_from_hull(const Mesh& mesh, Allocator& allocator, const StopRequest& stop,
                    const Meets& meets, const Visit& visit) {
    Buffer<std::uint64_t> seen(allocator);
    Buffer<TetId> stack(allocator);
    seen.resize(mesh.tetrahedra.size() / 64 + 1, 0u);
    const auto push = [&](TetId t) {
        const std::uint64_t bit = std::uint64_t{1} << t % 64;
        if ((seen[t / 64] & bit) != 0) return;
        seen[t / 64] |= bit;
        stack.push_back(t);
    };
    push(mesh.a_ghost);
    for (std::size_t i = 0; !stack.empty(); ++i) {
        stop.poll_in_step(i);
        const TetId t = stack.back();
        stack.pop_back();
        const Tetrahedron& tetrahedron = mesh.tetrahedra[t];
        if (!tetrahedron.is_ghost() && !meets(t)) continue;
        visit(t);
        for (const FacetCode facet : tetrahedron.n) push(tetrahedron_of(facet));
    }
}

}  // namespace mgdt
