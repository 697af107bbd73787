// SPDX-License-Identifier: MIT
#include "core/insertion.hpp"

#include <cstdint>

#include "core/batch_insertion.hpp"
#include "kernel/circumsphere.hpp"
#include "platform/compiler.hpp"
#include "platform/error.hpp"

namespace mgdt {
namespace {

// Inserts all held points and the new points that they need to span space. The held points belong
// to earlier calls, so this part of the call cannot be cancelled.
// The function is not inlined, so that its batch takes no stack in a call without held points.
MGDT_NOT_INLINE void insert_degenerate(State& state, Team& team, const Batch& batch,
                                       std::size_t spanning) {
    Batch all(state.allocator);
    all.gather(state.mesh, state.points.map, batch, spanning);
    insert_batch(state, team, all, true, false);
}

}  // namespace

void insert_points(State& state, std::size_t n, const double* const axis[3],
                   std::ptrdiff_t stride) {
    const std::size_t first = state.points.map.size();
    if (n > max_points - first)
        fail(MGDT_ERR_TOO_LARGE, "%zu points after %zu; at most %zu can be numbered", n, first,
             max_points);
    // The address of the last point must not overflow.
    const std::size_t step = stride < 0 ? std::size_t{0} - static_cast<std::size_t>(stride)
                                        : static_cast<std::size_t>(stride);
    if (n > 1 && step > PTRDIFF_MAX / sizeof(double) / (n - 1))
        fail(MGDT_ERR_INVALID_ARGUMENT, "a stride of %lld takes %zu points beyond all memory",
             static_cast<long long>(stride), n);
    Team team(state.threads_for(n, state.hooks.min_points_per_thread));
    const PointScan scan(team, n, axis, stride,
                         static_cast<long long>(first) + state.settings.index_base);
    if (n == 0) return;

    const StopFlag::Call call(state.progress.stop());

    state.points.map.grow(first + n);
    state.numbering.forget();
    state.points.exponents.add(scan.exponents);
    state.set_scale(scale_for(state, n, axis, stride));
    state.points.map.resize(first + n, infinite_vertex);

    state.progress.report(0, n);
    state.progress.stop_if_cancelled(0, n);

    Batch batch(state.allocator, scan, n, axis, stride, state.mesh.scale, first);
    if (state.points.dimension() == 3) {
        insert_batch(state, team, batch, false, true);
    } else {
        AffineBasis basis = state.points.basis;
        const std::size_t spanning = points_to_span_space(batch, basis);
        if (basis.dimension() < 3) {
            hold(state, batch, basis);
        } else if (first == 0) {
            insert_batch(state, team, batch, true, true);
        } else {
            insert_degenerate(state, team, batch, spanning);
            batch.drop_front(spanning);
            if (batch.points.size > 0) insert_batch(state, team, batch, false, true);
        }
    }
    state.progress.report(n, n);
}

int scale_for(const State& state, std::size_t n, const double* const axis[3],
              std::ptrdiff_t stride) {
    const int scale = choose_scale(state.points.exponents, state.mesh.scale);
    if (is_normal(state.points.exponents, scale) || state.points.exponents.empty()) return scale;
    // Some coordinates remain outside the range of the filters. Changing the scale takes a pass
    // over the mesh, so a small batch keeps the current scale if that scale is exact.
    if (n < state.vertex_count() && is_exact(state.points.exponents, state.mesh.scale))
        return state.mesh.scale;
    return choose_scale_of_most(state.points.exponents,
                                PointScan::typical_exponent(n, axis, stride));
}

std::size_t points_to_span_space(const Batch& batch, AffineBasis& basis) {
    std::size_t i = 0;
    for (; i < batch.points.size && basis.dimension() < 3; ++i) {
        double p[3];
        batch.get(i, p);
        basis.add(p);
    }
    return i;
}

void hold(State& state, const Batch& batch, const AffineBasis& basis) {
    state.points.held.reserve(state.mesh, batch.points.size);
    for (std::size_t i = 0; i < batch.points.size; ++i) {
        double p[3];
        batch.get(i, p);
        const std::size_t before = state.vertex_count();
        state.points.map[batch.index(i)] = state.points.held.add(state.mesh, p, batch.index(i));
        if (state.vertex_count() > before) {
            ++state.statistics.points_inserted;
        } else {
            ++state.statistics.duplicates;
            state.mesh.vertices[state.points.map[batch.index(i)]].moved_to = has_equals;
        }
        if (!in_normal_range(p)) state.mesh.has_extremes = true;
    }
    state.points.basis = basis;
}

}  // namespace mgdt
