// SPDX-License-Identifier: MIT
#include "core/rebuild.hpp"

#include "core/batch_insertion.hpp"
#include "core/insertion.hpp"

namespace mgdt {
namespace {

void rebuild(State& state, const Batch& all) {
    Team team(state.threads_for(all.points.size, state.hooks.min_points_per_thread));
    AffineBasis basis, basis_before = state.points.basis;
    points_to_span_space(all, basis);
    Mesh mesh(state.allocator);
    if (!state.mesh.tetrahedra.has_spheres()) mesh.tetrahedra.drop_spheres();
    mesh.slot_limit = state.mesh.slot_limit;
    mesh.vertex_limit = state.mesh.vertex_limit;
    mesh.scale = state.mesh.scale;
    mesh.clear();
    Buffer<VertexId> point_map(state.allocator);
    point_map.resize(state.points.map.size(), infinite_vertex);
    DegeneratePoints degenerate(state.allocator);
    std::uint64_t points_inserted = 0, duplicates = 0;
    TetId last = no_tetrahedron;
    const auto exchange = [&] {
        std::swap(state.mesh, mesh);
        std::swap(state.points.map, point_map);
        std::swap(state.points.held, degenerate);
        std::swap(state.points.basis, basis_before);
        std::swap(state.statistics.points_inserted, points_inserted);
        std::swap(state.statistics.duplicates, duplicates);
        std::swap(state.walk_starts.last, last);
        // The kernel's vector loads read beyond the end of arrays in the workspace, where vertex
        // numbers of the other mesh may be left. reset() removes these numbers.
        state.workspace.reset();
        state.walk_starts.forget_tree();
    };
    state.numbering.forget();
    exchange();
    try {
        if (basis.dimension() == 3)
            insert_batch(state, team, all, true, true);
        else
            hold(state, all, basis);
    } catch (...) {
        exchange();
        throw;
    }
    ++state.statistics.rebuilds;
}

}  // namespace

bool is_rebuild_faster(const State& state, std::size_t points) noexcept {
    constexpr std::size_t few = 16;
    const std::size_t share = state.hooks.vertices_per_rebuild;
    return share != 0 && points > few && points > state.vertex_count() / share;
}

void rebuild(State& state, const Batch& all, std::size_t done, std::size_t total) {
    try {
        rebuild(state, all);
    } catch (const Error& error) {
        if (error.status == MGDT_ERR_CANCELLED)
            fail(MGDT_ERR_CANCELLED, "cancelled after %zu of %zu points", done, total);
        throw;
    }
}

}  // namespace mgdt
