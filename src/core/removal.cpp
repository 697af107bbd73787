// SPDX-License-Identifier: MIT
#include "core/removal.hpp"

#include <algorithm>

#include "core/hole_filling.hpp"
#include "core/other_points.hpp"
#include "core/rebuild.hpp"
#include "core/stopwatch.hpp"
#include "core/vertex_compaction.hpp"

namespace mgdt {
namespace {

class Removal {
  public:
    Removal(State& state, const Buffer<std::uint32_t>& points)
        : state_(state), others_(state, points), gaps_(state.allocator) {
        gaps_.reserve(points.size());
        others_.find();
    }
    ~Removal() { close_gaps(state_, gaps_); }
    Removal(const Removal&) = delete;
    Removal& operator=(const Removal&) = delete;

    // Prefetches the first tetrahedron that the removal of the point will read.
    void announce(std::uint32_t point) const noexcept {
        if (state_.mesh.vertex_hint.empty()) return;
        const TetId near = state_.mesh.vertex_hint[state_.points.map[point]];
        if (near != no_tetrahedron) state_.mesh.tetrahedra.prefetch(near);
    }
    // Removes a point. Returns false, with the point still in, if a rebuild without the `left`
    // points that are still to be removed is better. `budget` makes this decision; with nullptr the
    // point is always removed.
    bool try_to_take_out(std::uint32_t point, RemovalBudget* budget, std::size_t left);

  private:
    State& state_;
    OtherPoints others_;
    Buffer<VertexId> gaps_;  // numbers of vertices that were removed
};

bool Removal::try_to_take_out(std::uint32_t point, RemovalBudget* budget, std::size_t left) {
    Mesh& mesh = state_.mesh;
    VertexRemoval& vertex = state_.vertex_removal;
    const VertexId v = state_.points.map[point];
    const std::uint32_t other = others_.least(v, point);
    if (other != no_index) {
        std::uint32_t& stand_in = mesh.vertices[v].index;
        if (stand_in == point) stand_in = other;
        state_.points.map[point] = infinite_vertex;
        --state_.statistics.duplicates;
        ++state_.statistics.removed;
        return true;
    }
    if (mesh.live_count() != 0) {
        find_link(state_, v);
        if (budget && is_rebuild_better(state_, *budget, left)) return false;
        const std::size_t tetrahedra = fill_hole(state_);
        if (budget) budget->add(vertex.link_size(), tetrahedra);
        if (vertex.leaves_space()) {
            state_.walk_starts.last = vertex.replace(mesh);
            mesh.guards_agree = false;
            state_.statistics.link_vertices += vertex.link_size();
        } else {
            mesh.drop_tetrahedra();
            state_.walk_starts.forget_tree();
            mesh.vertex_hint.clear();
            state_.walk_starts.last = no_tetrahedron;
        }
        state_.workspace.slot_count = 0;
    }
    if (!mesh.vertex_hint.empty()) mesh.vertex_hint[v] = no_tetrahedron;
    gaps_.push_back(v);
    state_.points.map[point] = infinite_vertex;
    --state_.statistics.points_inserted;
    ++state_.statistics.removed;
    return true;
}

void rebuild_without(State& state, const std::uint32_t* points, std::size_t count,
                     std::size_t total) {
    Batch rest(state.allocator);
    {
        Buffer<bool> leaves(state.allocator);
        leaves.resize(state.points.map.size(), false);
        for (std::size_t k = 0; k < count; ++k) leaves[points[k]] = true;
        rest.begin_gathering(state.points.map.size() - count);
        for (std::uint32_t i = 0; i < state.points.map.size(); ++i)
            if (state.points.map[i] != infinite_vertex && !leaves[i])
                rest.gather(state.mesh.point(state.points.map[i]), i);
    }
    rest.end_gathering();
    rebuild(state, rest, total - count, total);
    state.statistics.removed += count;
}

std::size_t remove_one_by_one(State& state, const Buffer<std::uint32_t>& points, std::size_t total,
                              bool may_stop) {
    Removal removal(state, points);
    RemovalBudget budget = removal_budget(state);
    const std::size_t first = total - points.size();
    std::size_t done = 0;
    constexpr std::size_t ahead = 4;
    state.progress.change_one_by_one(
        first, total, total, [](std::size_t i) { return i; },
        [&](std::size_t i) {
            if (i + ahead < total) removal.announce(points[i + ahead - first]);
            if (!removal.try_to_take_out(points[i - first], may_stop ? &budget : nullptr,
                                         total - i))
                return false;
            ++done;
            return true;
        });
    return done;
}

}  // namespace

bool is_rebuild_better(const State& state, const RemovalBudget& budget, std::size_t left) noexcept {
    return state.hooks.vertices_per_rebuild != 0 &&
           budget.is_exceeded_by(state.vertex_removal.link_size(), has_large_link(state), left);
}

void remove_points(State& state, const Buffer<std::uint32_t>& points) {
    state.points.require_in(points, "removed", state.settings.index_base);
    const std::size_t n = points.size();
    if (n == 0) return;
    const StopFlag::Call call(state.progress.stop());
    const Stopwatch watch(state.statistics.remove_seconds);
    state.numbering.forget();
    state.walk_starts.expect_changes(n);
    state.points.exponents_are_wide = true;
    state.progress.report(0, n);
    state.progress.stop_if_cancelled(0, n);
    // The points are removed in the order of their vertex numbers, which mostly follow a curve, so
    // that consecutive removals access nearby memory.
    Buffer<std::uint32_t> left(state.allocator);
    left.reserve(n);
    for (const std::uint32_t i : points) left.push_back(i);
    std::sort(left.begin(), left.end(), [&](std::uint32_t i, std::uint32_t j) {
        return state.points.map[i] != state.points.map[j]
                   ? state.points.map[i] < state.points.map[j]
                   : i < j;
    });
    const auto rebuild_without_those_left = [&] {
        rebuild_without(state, left.data(), left.size(), n);
    };
    // Removing held points needs no geometry.
    const bool is_held = state.mesh.live_count() == 0;
    if (!is_held && is_rebuild_faster(state, n) &&
        try_to_rebuild(state, rebuild_without_those_left))
        return state.progress.report(n, n);
    const std::size_t done = remove_one_by_one(state, left, n, !is_held);
    std::copy(left.begin() + done, left.end(), left.begin());
    left.resize_within_capacity(n - done);
    if (!left.empty() && !try_to_rebuild(state, rebuild_without_those_left))
        remove_one_by_one(state, left, n, false);
    state.progress.report(n, n);
}

}  // namespace mgdt
