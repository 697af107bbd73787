// SPDX-License-Identifier: MIT
#include "core/state.hpp"

#include <algorithm>

#include "kernel/circumsphere.hpp"
#include "parallel/thread_count.hpp"

namespace mgdt {

State::State(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user)
    : allocator(alloc, release, user),
      kernel(&default_kernel()),
      mesh(allocator),
      points(allocator),
      walk_starts(allocator),
      numbering(allocator),
      progress(settings),
      workspace(allocator),
      vertex_removal(allocator),
      short_schedule(allocator, allocator) {
    mesh.clear();
}

unsigned State::threads_for(std::size_t work, std::size_t min_per_thread) const noexcept {
    return Team::threads_for(work, min_per_thread, thread_count(settings));
}

void State::clear() noexcept {
    progress.stop().forget();
    numbering.forget();
    walk_starts.clear();
    mesh.clear();
    mesh.scale = 0;
    points.clear();
    workspace.slot_count = 0;
    workspace.counters = Counters();
    statistics = Statistics();
}

void State::shrink() noexcept {
    numbering.forget();
    walk_starts.forget_tree();
    // Memory that is only freed comes first, since shrinking a block may have to move it.
    workspace.reset();
    vertex_removal.reset();
    for (Buffer<std::uint32_t>* part :
         {&short_schedule.order, &short_schedule.rounds, &short_schedule.hints})
        part->reset();
    points.held.clear();
    points.map.shrink();
    points.equals.forget();
    mesh.shrink();
}

void State::set_scale(int scale) {
    if (scale == mesh.scale) return;
    const int change = scale - mesh.scale;
    mesh.scale = scale;
    walk_starts.forget_tree();
    if (mesh.vertices.size() == 1) return;
    mesh.has_extremes = false;
    for (std::size_t v = 1; v < mesh.vertices.size(); ++v) {
        for (double& x : mesh.vertices[v].x) x = scaled(x, change);
        if (!in_normal_range(mesh.vertices[v].x)) mesh.has_extremes = true;
    }
    if (mesh.tetrahedra.has_spheres()) set_spheres();
    // The hash table of held points and the basis have scaled coordinates.
    points.held.clear();
    points.basis.scale(change);
}

void State::set_spheres() noexcept {
    for (TetId t = 0; t < mesh.tetrahedra.size(); ++t)
        if (!mesh.tetrahedra[t].is_dead())
            mesh.tetrahedra.sphere(t) =
                rounded(circumsphere(mesh.tetrahedra[t], mesh.vertices.data()));
}

void State::note(VertexId q, const Insertion& result) {
    if (result.duplicate == infinite_vertex)
        ++statistics.points_inserted;
    else
        note_repeat(q, result.duplicate);
}

void State::note_repeat(VertexId q, VertexId vertex) {
    const std::uint32_t index = mesh.vertices[q].index;
    points.map[index] = vertex;
    std::uint32_t& least = mesh.vertices[vertex].index;
    least = std::min(least, index);
    mesh.vertices[vertex].moved_to = has_equals;
    ++statistics.duplicates;
}

}  // namespace mgdt
