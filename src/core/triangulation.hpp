// SPDX-License-Identifier: MIT
// The triangulation object. The way of a point: checked and scaled (point_scan), scheduled
// (order/), copied into the mesh in that order, then walked to, its cavity dug, its star built
// (kernel/), and numbered for export (query/).
#pragma once

#include <functional>

#include "core/affine_basis.hpp"
#include "core/degenerate_points.hpp"
#include "core/point_scan.hpp"
#include "core/removal_budget.hpp"
#include "core/settings.hpp"
#include "core/statistics.hpp"
#include "kernel/circumsphere.hpp"
#include "kernel/kernel.hpp"
#include "kernel/location_tree.hpp"
#include "kernel/vertex_removal.hpp"
#include "mesh/scale.hpp"
#include "order/schedule.hpp"
#include "parallel/team.hpp"
#include "platform/cached.hpp"
#include "platform/error.hpp"
#include "query/check.hpp"
#include "query/numbering.hpp"

namespace mgdt {

class Triangulation {
  public:
    Triangulation(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user);

    // Inserts n points, coordinate k of point i at axis[k][i * stride]. Throws Error and
    // std::bad_alloc as mgdt_insert_points() documents.
    void insert(std::size_t n, const double* const axis[3], std::ptrdiff_t stride);
    // Takes points out, given by their indices counted from 0. Throws Error for an index of no
    // point that is in, or that is there twice, and std::bad_alloc, with nothing changed; Error if
    // cancelled or out of memory when the points before are out.
    void remove(const Buffer<std::uint32_t>& points);
    // Moves points to the n places in `xyz`. Throws as remove(), and Error for a coordinate that is
    // not finite.
    void move(const Buffer<std::uint32_t>& points, const double* xyz);
    // Numbers the points that are in anew, in their order from 0 on, and forgets the others.
    void forget_absent_points() noexcept;
    void clear() noexcept;
    void reserve(std::size_t points);
    // Gives back what is kept for speed alone.
    void shrink() noexcept;
    // Whether spheres are kept or computed whenever they are wanted. Throws std::bad_alloc with
    // nothing changed where there is no memory to keep them.
    void set_compact(bool compact);
    void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }

    // How many threads a call may use that has so much work in units of `min_items_per_thread`.
    unsigned threads_for(std::size_t work, std::size_t min_items_per_thread) const noexcept;

    Settings& settings() noexcept { return settings_; }
    TestHooks& hooks() noexcept { return hooks_; }
    const Settings& settings() const noexcept { return settings_; }
    Allocator& allocator() const noexcept { return allocator_; }
    const Mesh& mesh() const noexcept { return mesh_; }
    const Kernel& kernel() const noexcept { return *kernel_; }
    const KernelCalls& calls() const noexcept { return kernel_->on(mesh_); }
    void set_kernel(const Kernel& kernel) noexcept { kernel_ = &kernel; }
    const Counters& counters() const noexcept { return workspace_.counters; }
    const Statistics& statistics() const noexcept { return statistics_; }
    int dimension() const noexcept { return basis_.dimension(); }
    // The vertex of each point given; infinite_vertex where it is not in.
    const Buffer<VertexId>& point_map() const noexcept { return point_map_; }
    std::size_t vertex_count() const noexcept { return mesh_.vertices.size() - 1; }
    // Numbers of tetrahedra as the exports count them; made when first asked for.
    const Numbering& numbering(Team& team) const {
        return numbering_.get(mesh_, settings_.canonical_output, std::ref(team));
    }
    void forget_numbering() noexcept { numbering_.forget(); }
    // Where walks start; nullptr for a small mesh. Made when first asked for.
    const LocationTree* location_tree() const { return location_tree(mesh_.vertices.size()); }
    // What is checked.
    CheckInput check_input() const;

  private:
    struct Batch;
    class ConcurrentInsertion;
    class Removal;
    class Motion;
    struct MovedPoints;
    // A request to stop concerns the call that it meets alone, however that ends.
    struct ForgetRequest {
        Atomic<bool>& flag;
        ~ForgetRequest() { flag.store(false, std::memory_order_relaxed); }
    };
    // Points between two looks at the request.
    static constexpr std::size_t poll_interval = 1024;

    int scale_for(std::size_t n, const double* const axis[3], std::ptrdiff_t stride) const;
    void set_scale(int scale);
    void set_spheres() noexcept;
    std::size_t points_to_span_space(const Batch& batch, AffineBasis& basis) const;
    void hold(const Batch& batch, const AffineBasis& basis);
    void insert_degenerate(Team& team, const Batch& batch, std::size_t spanning);
    void insert_batch(Team& team, const Batch& batch, bool fresh, bool may_stop);
    void schedule_batch(Team& team, const Batch& batch, Schedule& schedule);
    void begin_with(Team& team, const Batch& batch, Schedule& schedule);
    void copy_vertices(Team& team, const Batch& batch, const Schedule& schedule, std::size_t base);
    void make_first_tetrahedra();
    const LocationTree* location_tree(std::size_t end) const noexcept;
    const LocationTree* tree_for_insertion(std::size_t end) noexcept;
    void extend_location_tree(std::size_t begin) noexcept;
    void change_location_tree(std::size_t vertices) noexcept;
    void insert_scheduled(const Batch& batch, const Schedule& schedule, std::size_t base,
                          std::size_t done, bool may_stop);
    void compact_vertices(Team& team, std::size_t begin, std::size_t first_point) noexcept;
    void renumber_moved(Team& team, std::size_t end, std::size_t moved) noexcept;
    void renumber_points(Team& team, std::size_t end, std::size_t first_point) noexcept;
    void require_in(const Buffer<std::uint32_t>& points, const char* what) const;
    bool are_equals_among(const Buffer<std::uint32_t>& points) const noexcept;
    bool is_rebuild_faster(std::size_t points) const noexcept;
    // Has body() rebuild, if there is memory for it, which there must be where points are held.
    template <class Body>
    bool try_to_rebuild(Body body);
    void rebuild(const Batch& all);
    void rebuild(const Batch& all, std::size_t done, std::size_t total);
    // Finds what the removal of v takes: first its link, then what fills the hole. Returns how many
    // tetrahedra a triangulation of the link had, 0 without one.
    void find_link(VertexId v);
    bool has_large_link() const noexcept {
        return vertex_removal_.link_size() >= hooks_.large_link;
    }
    std::size_t fill_hole();
    std::size_t fill_from_link();
    RemovalBudget removal_budget() const noexcept;
    // Whether the hole of the vertex whose link was found is better left, as the others, of which
    // `left` are to go, are better triangulated anew.
    bool is_rebuild_better(const RemovalBudget& budget, std::size_t left) const noexcept {
        return hooks_.vertices_per_rebuild != 0 &&
               budget.is_exceeded_by(vertex_removal_.link_size(), has_large_link(), left);
    }
    // Without `count` points, of which `total` were to be removed at first.
    void rebuild_without(const std::uint32_t* points, std::size_t count, std::size_t total);
    // These points are the last of `total`. Returns how many it has removed: fewer than all where
    // the others are better triangulated anew, if it `may_stop`.
    std::size_t remove_one_by_one(const Buffer<std::uint32_t>& points, std::size_t total,
                                  bool may_stop);
    void rebuild_moved(const MovedPoints& moved, std::size_t first);
    void make_guards_agree() noexcept;
    void close_gaps(Buffer<VertexId>& gaps) noexcept;
    // Enter the outcome of an insertion in the point map and the statistics: q is a vertex, as the
    // map has it already, or a repeat of one.
    void note(VertexId q, const Insertion& result);
    void note_repeat(VertexId q, VertexId vertex);
    void report(std::size_t done, std::size_t total);
    void stop_if_cancelled(std::size_t done, std::size_t total);
    // Makes changes, step(k) for each k from `first` to before n until one returns false, with
    // progress. What stops them says that done(k) of the `total` points that the caller has listed
    // are done.
    template <class Done, class Step>
    void change_one_by_one(std::size_t first, std::size_t n, std::size_t total, Done done,
                           Step step);

    mutable Allocator allocator_;
    Settings settings_;
    TestHooks hooks_;
    const Kernel* kernel_;
    Mesh mesh_;
    Workspace workspace_;
    VertexRemoval vertex_removal_;
    Schedule short_schedule_;  // of batches that need none: its memory is kept
    Buffer<VertexId> point_map_;
    DegeneratePoints degenerate_;
    AffineBasis basis_;
    ExponentRange exponents_;  // of all points that came, and of more once some have left
    bool exponents_are_wide_ = false;
    TetId last_ = no_tetrahedron;   // of the last insertion: where the next walk starts
    std::uint64_t lone_steps_ = 0;  // of batches' first walks since there was no tree
    Statistics statistics_;
    Atomic<bool> cancelled_{false};
    mutable Cached<Numbering> numbering_;
    mutable Cached<LocationTree> location_tree_;
};

template <class Body>
bool Triangulation::try_to_rebuild(Body body) {
    const bool is_held = mesh_.live_count() == 0;
    try {
        body();
        return true;
    } catch (const std::bad_alloc&) {
        if (is_held) throw;
    } catch (const Error& error) {
        // There may be more tetrahedra on the way than at the end.
        if (is_held || error.status != MGDT_ERR_TOO_LARGE) throw;
    }
    return false;
}

template <class Done, class Step>
void Triangulation::change_one_by_one(std::size_t first, std::size_t n, std::size_t total,
                                      Done done, Step step) {
    const std::size_t report_interval = std::max<std::size_t>(n / 100, 1);
    std::size_t next_report = first + report_interval;
    for (std::size_t k = first; k < n; ++k) {
        const bool is_due = k >= next_report;
        if (is_due) {
            next_report += report_interval;
            report(k, n);
        }
        if (is_due || k % poll_interval == 0) stop_if_cancelled(done(k), total);
        try {
            if (!step(k)) return;
        } catch (const std::bad_alloc&) {
            fail(MGDT_ERR_OUT_OF_MEMORY, "out of memory after %zu of %zu points", done(k), total);
        } catch (const Error& error) {
            if (error.status == MGDT_ERR_CANCELLED)
                fail(MGDT_ERR_CANCELLED, "cancelled after %zu of %zu points", done(k), total);
            if (error.status != MGDT_ERR_TOO_LARGE) throw;
            fail(MGDT_ERR_TOO_LARGE, "%s after %zu of %zu points", error.message, done(k), total);
        }
    }
}

}  // namespace mgdt
