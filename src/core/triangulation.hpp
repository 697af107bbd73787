// SPDX-License-Identifier: MIT
// The triangulation object: its state, and the operations on it. The way of a point: checked and
// scaled (insertion.cpp), scheduled and copied into the mesh in that order (batch_insertion.cpp),
// then walked to, its cavity dug, its star built (kernel/), and numbered for export (query/).
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
    // Takes points out, given by their indices counted from 0. Throws Error for an index of no
    // point that is in, or that is listed twice, and std::bad_alloc, with nothing changed; Error if
    // cancelled or out of memory when the points before are out.
    void remove(const Buffer<std::uint32_t>& points);
    // Moves points to the n places in `xyz`. Throws as remove(), and Error for a coordinate that is
    // not finite.
    void move(const Buffer<std::uint32_t>& points, const double* xyz);
    // Numbers the points that are in anew, in their order from 0 on, and forgets the others.
    void forget_absent_points() noexcept;
    void clear() noexcept { state_.clear(); }
    void reserve(std::size_t points);
    // Gives back what is kept for speed alone.
    void shrink() noexcept { state_.shrink(); }
    // Whether spheres are kept or computed whenever they are wanted. Throws std::bad_alloc with
    // nothing changed where there is no memory to keep them.
    void set_compact(bool compact);
    void cancel() noexcept { state_.progress.cancel(); }

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
    // The vertex of each point given; infinite_vertex where it is not in.
    const Buffer<VertexId>& point_map() const noexcept { return state_.points.map; }
    std::size_t vertex_count() const noexcept { return state_.vertex_count(); }
    // Numbers of tetrahedra as the exports count them; made when first asked for.
    const Numbering& numbering(Team& team) const {
        return state_.numbering.get(state_.mesh, state_.settings.canonical_output, std::ref(team));
    }
    void forget_numbering() noexcept { state_.numbering.forget(); }
    // Where walks start; nullptr for a small mesh. Made when first asked for.
    const LocationTree* location_tree() const {
        return state_.walk_starts.tree(state_.mesh, state_.mesh.vertices.size());
    }
    // What is checked.
    CheckInput check_input() const;

  private:
    State state_;
};

}  // namespace mgdt
