// SPDX-License-Identifier: MIT
#include "core/triangulation.hpp"

#include <algorithm>
#include <cstdint>
#include <thread>

#include "core/batch.hpp"
#include "platform/callback.hpp"
#include "platform/error.hpp"

namespace mgdt {

Triangulation::Triangulation(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user)
    : allocator_(alloc, release, user),
      kernel_(&default_kernel()),
      mesh_(allocator_),
      workspace_(allocator_),
      vertex_removal_(allocator_),
      short_schedule_(allocator_, allocator_),
      point_map_(allocator_),
      degenerate_(allocator_),
      numbering_(allocator_),
      location_tree_(allocator_) {
    mesh_.clear();
}

void Triangulation::clear() noexcept {
    cancelled_.store(false, std::memory_order_relaxed);
    forget_numbering();
    location_tree_.forget();
    mesh_.clear();
    mesh_.scale = 0;
    point_map_.clear();
    degenerate_.clear();
    basis_.clear();
    exponents_ = ExponentRange();
    exponents_are_wide_ = false;
    last_ = no_tetrahedron;
    workspace_.slot_count = 0;
    statistics_ = Statistics();
    workspace_.counters = Counters();
}

void Triangulation::reserve(std::size_t points) {
    if (points > max_points)
        fail(MGDT_ERR_TOO_LARGE, "%zu points; at most %zu can be numbered", points, max_points);
    point_map_.reserve(points);
    mesh_.vertices.reserve(points + 1);
    mesh_.vertex_hint.reserve(points + 1);
    mesh_.reserve_tetrahedra(expected_tetrahedra(points, mesh_.slot_limit));
}

void Triangulation::shrink() noexcept {
    forget_numbering();
    location_tree_.forget();
    // What takes no block comes first: the others may need room to move.
    workspace_.reset();
    vertex_removal_.reset();
    for (Buffer<std::uint32_t>* part :
         {&short_schedule_.order, &short_schedule_.rounds, &short_schedule_.hints})
        part->reset();
    degenerate_.clear();
    point_map_.shrink();
    mesh_.shrink();
}

void Triangulation::set_compact(bool compact) {
    if (compact != mesh_.tetrahedra.has_spheres()) return;
    if (compact) {
        mesh_.tetrahedra.drop_spheres();
    } else {
        mesh_.tetrahedra.make_room_for_spheres();
        set_spheres();
    }
}

void Triangulation::insert(std::size_t n, const double* const axis[3], std::ptrdiff_t stride) {
    const std::size_t first = point_map_.size();
    if (n > max_points - first)
        fail(MGDT_ERR_TOO_LARGE, "%zu points after %zu; at most %zu can be numbered", n, first,
             max_points);
    // The last point must have an address.
    const std::size_t step = stride < 0 ? std::size_t{0} - static_cast<std::size_t>(stride)
                                        : static_cast<std::size_t>(stride);
    if (n > 1 && step > PTRDIFF_MAX / sizeof(double) / (n - 1))
        fail(MGDT_ERR_INVALID_ARGUMENT, "a stride of %lld takes %zu points beyond all memory",
             static_cast<long long>(stride), n);
    Team team(threads_for(n, hooks_.min_points_per_thread));
    const PointScan scan(team, n, axis, stride,
                         static_cast<long long>(first) + settings_.index_base);
    if (n == 0) return;

    const ForgetRequest forget{cancelled_};

    point_map_.grow(first + n);
    forget_numbering();
    exponents_.add(scan.exponents);
    set_scale(scale_for(n, axis, stride));
    point_map_.resize(first + n, infinite_vertex);

    report(0, n);
    stop_if_cancelled(0, n);

    Batch batch(allocator_, scan, n, axis, stride, mesh_.scale, first);
    if (dimension() == 3) {
        insert_batch(team, batch, false, true);
    } else {
        AffineBasis basis = basis_;
        const std::size_t spanning = points_to_span_space(batch, basis);
        if (basis.dimension() < 3) {
            hold(batch, basis);
        } else if (first == 0) {
            insert_batch(team, batch, true, true);
        } else {
            insert_degenerate(team, batch, spanning);
            batch.drop_front(spanning);
            if (batch.points.size > 0) insert_batch(team, batch, false, true);
        }
    }
    report(n, n);
}

// The scale for all points so far, which `exponents_` knows, and the n that come in.
int Triangulation::scale_for(std::size_t n, const double* const axis[3],
                             std::ptrdiff_t stride) const {
    const int scale = choose_scale(exponents_, mesh_.scale);
    if (is_normal(exponents_, scale) || exponents_.empty()) return scale;
    // Some will be outside the filters' range. A change is a pass over the mesh: only for batches
    // that are as large.
    if (n < vertex_count() && is_exact(exponents_, mesh_.scale)) return mesh_.scale;
    return choose_scale_of_most(exponents_, PointScan::typical_exponent(n, axis, stride));
}

void Triangulation::set_scale(int scale) {
    if (scale == mesh_.scale) return;
    const int change = scale - mesh_.scale;
    mesh_.scale = scale;
    location_tree_.forget();
    if (mesh_.vertices.size() == 1) return;
    mesh_.has_extremes = false;
    for (std::size_t v = 1; v < mesh_.vertices.size(); ++v) {
        for (double& x : mesh_.vertices[v].x) x = scaled(x, change);
        if (!in_normal_range(mesh_.vertices[v].x)) mesh_.has_extremes = true;
    }
    if (mesh_.tetrahedra.has_spheres()) set_spheres();
    // What is held is found by its bits, and a basis compares with points to come.
    degenerate_.clear();
    basis_.scale(change);
}

// Of all tetrahedra, whose storage is there.
void Triangulation::set_spheres() noexcept {
    for (TetId t = 0; t < mesh_.tetrahedra.size(); ++t)
        if (!mesh_.tetrahedra[t].is_dead())
            mesh_.tetrahedra.sphere(t) =
                rounded(circumsphere(mesh_.tetrahedra[t], mesh_.vertices.data()));
}

// How many of the batch's first points it takes, with those held, to span space; all of them if
// they do not.
std::size_t Triangulation::points_to_span_space(const Batch& batch, AffineBasis& basis) const {
    std::size_t i = 0;
    for (; i < batch.points.size && basis.dimension() < 3; ++i) {
        double p[3];
        batch.get(i, p);
        basis.add(p);
    }
    return i;
}

// Inserts all that was held, with the new points that are needed to span space. These were
// accepted before, so this part of the call does not stop for a request to cancel.
void Triangulation::insert_degenerate(Team& team, const Batch& batch, std::size_t spanning) {
    Batch all(allocator_);
    all.gather(mesh_, point_map_, batch, spanning);
    insert_batch(team, all, true, false);
}

void Triangulation::hold(const Batch& batch, const AffineBasis& basis) {
    degenerate_.reserve(mesh_, batch.points.size);
    for (std::size_t i = 0; i < batch.points.size; ++i) {
        double p[3];
        batch.get(i, p);
        const std::size_t before = vertex_count();
        point_map_[batch.index(i)] = degenerate_.add(mesh_, p, batch.index(i));
        if (vertex_count() > before) {
            ++statistics_.points_inserted;
        } else {
            ++statistics_.duplicates;
            mesh_.vertices[point_map_[batch.index(i)]].moved_to = has_equals;
        }
        if (!in_normal_range(p)) mesh_.has_extremes = true;
    }
    basis_ = basis;
}

unsigned Triangulation::threads_for(std::size_t work,
                                    std::size_t min_items_per_thread) const noexcept {
    std::size_t threads = static_cast<std::size_t>(settings_.threads);
    if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
    threads = std::min<std::size_t>(threads, Team::most);
    return static_cast<unsigned>(
        std::max<std::size_t>(1, std::min(threads, work / min_items_per_thread)));
}

void Triangulation::report(std::size_t done, std::size_t total) {
    if (!settings_.progress) return;
    const double fraction = static_cast<double>(done) / static_cast<double>(total);
    const std::int32_t cancels = call_back<std::int32_t>(
        1, [&] { return settings_.progress(fraction, settings_.progress_user); });
    if (cancels != 0) cancel();
}

void Triangulation::stop_if_cancelled(std::size_t done, std::size_t total) {
    if (cancelled_.exchange(false, std::memory_order_relaxed))
        fail(MGDT_ERR_CANCELLED, "cancelled after %zu of %zu points", done, total);
}

CheckInput Triangulation::check_input() const {
    return {mesh_,
            point_map_,
            dimension(),
            statistics_.points_inserted,
            statistics_.duplicates,
            exponents_,
            exponents_are_wide_,
            last_,
            location_tree_.peek()};
}

// So many vertices leave or move.
void Triangulation::change_location_tree(std::size_t vertices) noexcept {
    LocationTree* const tree = location_tree_.peek();
    if (tree && !tree->takes_changes(vertices)) location_tree_.forget();
}

const LocationTree* Triangulation::location_tree(std::size_t end) const noexcept {
    if (end < LocationTree::smallest || mesh_.live_count() == 0) return nullptr;
    try {
        return &location_tree_.get(mesh_, end);
    } catch (const std::bad_alloc&) {
        return nullptr;  // walks are longer then
    }
}

}  // namespace mgdt
