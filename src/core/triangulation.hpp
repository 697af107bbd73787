// SPDX-License-Identifier: MIT
// The triangulation object: its state, and the operations on it. An insertion checks and scales the
// points (insertion.cpp), makes a schedule and copies the points into the mesh in that order
// (batch_insertion.cpp). For each point, the kernel then walks to the point, finds the cavity and
// builds the star (kernel/). An export numbers the tetrahedra (query/).
#pragma once

#include <functional>

#include "core/state.hpp"
#include "parallel/team.hpp"
#include "query/check.hpp"

namespace mgdt {

class Triangulation {
  public:
    Triangulation(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user)
        : state_(alloc, release, user) {}

    // Inserts n points, coordinate k of point i at axis[k][i * stride]. Throws Error and
    // std::bad_alloc as mgdt_insert_points() documents.
    void insert(std::size_t n, const double* const axis[3], std::ptrdiff_t stride);
    // Removes the points with these indices, counted from 0. Throws Error with nothing changed if a
    // point is not in the triangulation or is listed twice, and std::bad_alloc with nothing
    // changed. Throws Error with some points removed if cancelled or out of memory in between.
    void remove(const Buffer<std::uint32_t>& points);
    // Moves points to the n places in `xyz`. Throws as remove(), and Error for a coordinate that is
    // not finite.
    void move(const Buffer<std::uint32_t>& points, const double* xyz);
    // Renumbers the points that have a vertex from 0 on, in their order, and forgets the others.
    void forget_absent_points() noexcept;
    // Gives vertices other indices: those of points that were inserted once, in their order. For a
    // copy whose points are asked for by these indices only.
    void set_indices(const Buffer<std::uint32_t>& indices) noexcept;
    void clear() noexcept { state_.clear(); }
    void reserve(std::size_t points);
    // Frees the memory that is kept only for speed.
    void shrink() noexcept { state_.shrink(); }
    // Chooses whether spheres are computed when they are needed (`compact`) or stored. Throws
    // std::bad_alloc with nothing changed if there is no memory to store the spheres.
    void set_compact(bool compact);
    // Stops the running calls, those that only read included.
    StopFlag& stop() const noexcept { return state_.progress.stop(); }

    // The number of threads for a call with this much work.
    unsigned threads_for(std::size_t work, std::size_t min_per_thread) const noexcept {
        return state_.threads_for(work, min_per_thread);
    }

    Settings& settings() noexcept { return state_.settings; }
    const Settings& settings() const noexcept { return state_.settings; }
    TestHooks& hooks() noexcept { return state_.hooks; }
    Allocator& allocator() const noexcept { return state_.allocator; }
    const Mesh& mesh() const noexcept { return state_.mesh; }
    const Kernel& kernel() const noexcept { return *state_.kernel; }
    const KernelCalls& calls() const noexcept { return state_.calls(); }
    void set_kernel(const Kernel& kernel) noexcept { state_.kernel = &kernel; }
    const Counters& counters() const noexcept { return state_.workspace.counters; }
    const Statistics& statistics() const noexcept { return state_.statistics; }
    int dimension() const noexcept { return state_.points.dimension(); }
    // The vertex of each point; infinite_vertex if the point is not in the triangulation.
    const Buffer<VertexId>& point_map() const noexcept { return state_.points.map; }
    std::size_t vertex_count() const noexcept { return state_.vertex_count(); }
    // The numbers of tetrahedra in exports. The first call computes the numbers.
    const Numbering& numbering(Team& team) const {
        return state_.numbering.get(state_.mesh, state_.settings.canonical_output, std::ref(team));
    }
    void forget_numbering() noexcept { state_.numbering.forget(); }
    // The tree that finds where walks start; nullptr for a small mesh. The first call makes the
    // tree.
    const LocationTree* location_tree() const {
        return state_.walk_starts.tree(state_.mesh, state_.mesh.vertices.size());
    }
    // The data that a check of the triangulation examines.
    CheckInput check_input() const;

  private:
    State state_;
};

}  // namespace mgdt
