// SPDX-License-Identifier: MIT
// The points are triangulated anew: faster than to remove or move many of them one by one. What
// there was is kept until that is done.
#include "core/batch.hpp"
#include "core/triangulation.hpp"
#include "platform/error.hpp"

namespace mgdt {

bool Triangulation::is_rebuild_faster(std::size_t points) const noexcept {
    constexpr std::size_t few = 16;
    const std::size_t share = hooks_.vertices_per_rebuild;
    return share != 0 && points > few && points > vertex_count() / share;
}

RemovalBudget Triangulation::removal_budget() const noexcept {
    return RemovalBudget(mesh_.live_count(), static_cast<std::size_t>(vertex_count()));
}

void Triangulation::rebuild(const Batch& all) {
    Team team(threads_for(all.points.size, hooks_.min_points_per_thread));
    AffineBasis basis, basis_before = basis_;
    points_to_span_space(all, basis);
    Mesh mesh(allocator_);
    if (!mesh_.tetrahedra.has_spheres()) mesh.tetrahedra.drop_spheres();
    mesh.slot_limit = mesh_.slot_limit;
    mesh.vertex_limit = mesh_.vertex_limit;
    mesh.scale = mesh_.scale;
    mesh.clear();
    Buffer<VertexId> point_map(allocator_);
    point_map.resize(point_map_.size(), infinite_vertex);
    DegeneratePoints degenerate(allocator_);
    std::uint64_t points_inserted = 0, duplicates = 0;
    TetId last = no_tetrahedron;
    const auto exchange = [&] {
        std::swap(mesh_, mesh);
        std::swap(point_map_, point_map);
        std::swap(degenerate_, degenerate);
        std::swap(basis_, basis_before);
        std::swap(statistics_.points_inserted, points_inserted);
        std::swap(statistics_.duplicates, duplicates);
        std::swap(last_, last);
        // Its vectors read past the end of a star, where it has vertices of the other mesh.
        workspace_.reset();
        location_tree_.forget();
    };
    forget_numbering();
    exchange();
    try {
        if (basis.dimension() == 3)
            insert_batch(team, all, true, true);
        else
            hold(all, basis);
    } catch (...) {
        exchange();
        throw;
    }
    ++statistics_.rebuilds;
}

// A request to stop undoes a rebuild, after `done` of `total` points.
void Triangulation::rebuild(const Batch& all, std::size_t done, std::size_t total) {
    try {
        rebuild(all);
    } catch (const Error& error) {
        if (error.status == MGDT_ERR_CANCELLED)
            fail(MGDT_ERR_CANCELLED, "cancelled after %zu of %zu points", done, total);
        throw;
    }
}

}  // namespace mgdt
