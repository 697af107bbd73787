// SPDX-License-Identifier: MIT
// Location and nearest vertices of many query points, by several threads. Int is std::int64_t or
// std::int32_t. The caller has checked that coordinates are finite and that indices fit.
#pragma once

#include <algorithm>

#include "order/curve_split.hpp"
#include "platform/stage_progress.hpp"
#include "query/locate.hpp"
#include "query/mesh_view.hpp"

namespace mgdt {

// The least number of query points per thread. With fewer, a thread costs more than it gains.
inline constexpr std::size_t places_per_thread = 4096;

// Calls found(i, tetrahedron, near) for each query point i, see Locator::locate_sequence(). Each
// thread has its own `found`, which make_found(member) returns.
template <class MakeFound>
void locate_each(const MeshView& view, const Locator& where, const PointSet& places,
                 bool may_end_outside, const StageProgress& progress, MakeFound make_found) {
    const double* const xyz = places.axis[0];
    if (places.size == 1) {
        TetId near = no_tetrahedron;
        const TetId found_in = where.locate(xyz, near, may_end_outside);
        make_found(0u)(0, found_in, near);
        return;
    }
    // Each query point is near the previous one.
    split_along_curve(
        view.team, places, view.allocator, places_per_thread, progress,
        [&](std::size_t count, const auto& index, StageProgress& of_block, unsigned m) {
            auto&& found = make_found(m);
            std::size_t done = 0;
            where.locate_sequence(
                count, may_end_outside, [&](std::size_t k) { return xyz + 3 * index(k); },
                [&](std::size_t k, TetId t, TetId near) {
                    of_block.step(done++, 0, count, m);
                    found(index(k), t, near);
                });
        });
}

// `places` are contiguous, in the caller's scale. `weights` may be null.
template <class Int>
void locate_points(const MeshView& view, const Locator& where, const PointSet& places,
                   const StageProgress& progress, Int* tetrahedra, double* weights);
template <class Int>
void nearest_vertices(const MeshView& view, const Locator& where, const PointSet& places,
                      const StageProgress& progress, Int* vertices);

}  // namespace mgdt
