// SPDX-License-Identifier: MIT
// The state of a triangulation. The operations of insertion.hpp, removal.hpp and motion.hpp change
// this state.
#pragma once

#include "core/point_table.hpp"
#include "core/progress.hpp"
#include "core/settings.hpp"
#include "core/statistics.hpp"
#include "core/walk_starts.hpp"
#include "hole/vertex_removal.hpp"
#include "kernel/kernel.hpp"
#include "platform/cached.hpp"
#include "query/numbering.hpp"

namespace mgdt {

struct State {
    State(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user);

    const KernelCalls& calls() const noexcept { return kernel->on(mesh); }
    std::size_t vertex_count() const noexcept { return mesh.vertices.size() - 1; }
    // The number of threads for a call with this much work, if a thread with less than
    // `min_per_thread` of it costs more than it gains.
    unsigned threads_for(std::size_t work, std::size_t min_per_thread) const noexcept;

    // Removes all points. The settings stay.
    void clear() noexcept;
    // Frees the memory that is kept only for speed.
    void shrink() noexcept;
    // Multiplies all coordinates so that the mesh has this scale.
    void set_scale(int scale);
    // Computes the spheres of all tetrahedra. The storage for spheres must exist.
    void set_spheres() noexcept;

    // These functions enter the result of an insertion in the point table and in the statistics.
    // Either vertex q, to which the table maps its point already, is inserted, or q repeats another
    // vertex.
    void note(VertexId q, const Insertion& result);
    void note_repeat(VertexId q, VertexId vertex);

    mutable Allocator allocator;
    Settings settings;
    TestHooks hooks;
    const Kernel* kernel;
    Mesh mesh;
    PointTable points;
    WalkStarts walk_starts;
    mutable Cached<Numbering> numbering;  // the numbers of tetrahedra in exports
    Statistics statistics;
    mutable Progress progress;
    // Working memory that is kept from one call to the next.
    Workspace workspace;
    VertexRemoval vertex_removal;
    Schedule short_schedule;  // for batches that are too small for an order scheme
};

}  // namespace mgdt
