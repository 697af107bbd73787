// SPDX-License-Identifier: MIT
#include "core/motion.hpp"

#include <algorithm>

#include "core/hole_filling.hpp"
#include "core/insertion.hpp"
#include "core/other_points.hpp"
#include "core/rebuild.hpp"
#include "core/removal.hpp"
#include "core/stopwatch.hpp"
#include "core/vertex_compaction.hpp"
#include "kernel/circumsphere.hpp"
#include "query/locate.hpp"

namespace mgdt {
namespace {

// The points whose coordinates change, with their new coordinates as the caller gave them.
struct MovedPoints {
    MovedPoints(Allocator& allocator, std::size_t listed)
        : points(allocator), xyz(allocator), positions_in_list(allocator), list_size(listed) {
        points.reserve(listed);
        xyz.reserve(3 * listed);
        positions_in_list.reserve(listed);
    }

    std::size_t size() const noexcept { return points.size(); }
    // The new coordinates of moved point k, scaled, with -0 replaced by 0.
    void coordinates(std::size_t k, int scale, double (&p)[3]) const noexcept {
        for (std::size_t i = 0; i < 3; ++i) p[i] = scaled(xyz[3 * k + i], scale) + 0.0;
    }

    Buffer<std::uint32_t> points;
    Buffer<double> xyz;
    // The position of each moved point in the caller's list, which also has points that stay.
    Buffer<std::uint32_t> positions_in_list;
    std::size_t list_size;
};

// Triangulates all points anew: the moved points from `first` on at their new coordinates, all
// other points where they are now.
void rebuild_moved(State& state, const MovedPoints& moved, std::size_t first) {
    state.points.equals.forget();
    const std::size_t n = moved.size();
    Batch all(state.allocator);
    {
        Buffer<std::uint32_t> order(state.allocator);
        order.resize(state.points.map.size(), no_index);
        for (std::size_t k = first; k < n; ++k)
            order[moved.points[k]] = static_cast<std::uint32_t>(k);
        all.begin_gathering(state.points.map.size());
        for (std::uint32_t i = 0; i < state.points.map.size(); ++i) {
            if (state.points.map[i] == infinite_vertex) continue;
            double p[3];
            std::copy_n(state.mesh.point(state.points.map[i]), 3, p);
            if (order[i] != no_index) moved.coordinates(order[i], state.mesh.scale, p);
            all.gather(p, i);
        }
    }
    all.end_gathering();
    rebuild(state, all, moved.positions_in_list[first], moved.list_size);
    state.statistics.moved += n - first;
}

class Motion {
  public:
    Motion(State& state, const MovedPoints& moved)
        : state_(state),
          moved_(moved),
          others_(state, moved.points),
          gaps_(state.allocator),
          budget_(removal_budget(state)) {}
    ~Motion() { close_gaps(state_, gaps_); }
    Motion(const Motion&) = delete;
    Motion& operator=(const Motion&) = delete;

    void one_by_one();

  private:
    // Moves point k. Returns false, with the point unmoved, if a rebuild that moves the points from
    // k on is necessary or faster.
    bool try_to_move(std::size_t k);
    bool try_to_move_vertex(VertexId v, std::uint32_t point, const double (&p)[3],
                            std::size_t left);
    void split_off(VertexId v, std::uint32_t point, const double (&p)[3], std::uint32_t other);
    Insertion insert(VertexId q, TetId start);

    State& state_;
    const MovedPoints& moved_;
    OtherPoints others_;
    Buffer<VertexId> gaps_;  // numbers of vertices that were removed
    RemovalBudget budget_;
    bool has_budget_ = true, is_too_slow_ = false;
};

void Motion::one_by_one() {
    const std::size_t n = moved_.size();
    gaps_.reserve(n);
    others_.find();
    state_.progress.change_one_by_one(
        0, n, moved_.list_size,
        [this](std::size_t k) { return std::size_t{moved_.positions_in_list[k]}; },
        [this](std::size_t k) {
            if (try_to_move(k)) return true;
            const auto rebuild = [&] { rebuild_moved(state_, moved_, k); };
            if (!is_too_slow_) {
                // Without this vertex, the remaining points do not span space.
                rebuild();
            } else if (!try_to_rebuild(state_, rebuild)) {
                // There is not enough memory for a rebuild: go on one by one.
                has_budget_ = is_too_slow_ = false;
                if (try_to_move(k)) return true;
                rebuild();
            }
            gaps_.clear();
            return false;
        });
}

bool Motion::try_to_move(std::size_t k) {
    const std::uint32_t point = moved_.points[k];
    double p[3];
    moved_.coordinates(k, state_.mesh.scale, p);
    if (!in_normal_range(p)) state_.mesh.has_extremes = true;
    const VertexId v = state_.points.map[point];
    const std::uint32_t other = others_.least(v, point);
    if (other != no_index)
        split_off(v, point, p, other);
    else if (!try_to_move_vertex(v, point, p, moved_.size() - k))
        return false;
    ++state_.statistics.moved;
    ++state_.statistics.put_back;
    return true;
}

Insertion Motion::insert(VertexId q, TetId start) {
    state_.workspace.may_jump = true;
    return state_.calls().insert(state_.mesh, state_.workspace, q, start);
}

// Moves a vertex that stands for one point. The vertex keeps its number.
bool Motion::try_to_move_vertex(VertexId v, std::uint32_t point, const double (&p)[3],
                                std::size_t left) {
    Mesh& mesh = state_.mesh;
    VertexRemoval& removal = state_.vertex_removal;
    find_link(state_, v);
    is_too_slow_ = has_budget_ && is_rebuild_better(state_, budget_, left);
    if (is_too_slow_) return false;
    budget_.add(removal.link_size(), fill_hole(state_));
    if (!removal.leaves_space()) return false;
    removal.keep_star(mesh);
    double before[3];
    std::copy_n(mesh.vertices[v].x, 3, before);
    state_.walk_starts.last = removal.replace(mesh);
    mesh.guards_agree = false;
    mesh.vertex_hint[v] = no_tetrahedron;
    state_.workspace.slot_count = 0;
    std::copy_n(p, 3, mesh.vertices[v].x);
    try {
        const Insertion result = insert(v, state_.walk_starts.last);
        if (result.duplicate != infinite_vertex) {
            others_.join(result.duplicate, point);
            gaps_.push_back(v);
            state_.note_repeat(v, result.duplicate);
            --state_.statistics.points_inserted;
        }
        state_.walk_starts.last = result.tetrahedron;
    } catch (...) {
        std::copy_n(before, 3, mesh.vertices[v].x);
        state_.walk_starts.last = removal.undo(mesh);
        state_.workspace.slot_count = 0;
        throw;
    }
    state_.statistics.link_vertices += removal.link_size();
    return true;
}

// Moves one of several points at vertex v, as a new vertex. `other` is the least of the points that
// stay at v.
void Motion::split_off(VertexId v, std::uint32_t point, const double (&p)[3], std::uint32_t other) {
    Mesh& mesh = state_.mesh;
    const auto q = static_cast<VertexId>(mesh.vertices.size());
    if (q >= mesh.vertex_limit)
        fail(MGDT_ERR_TOO_LARGE, "more than %u vertices", mesh.vertex_limit);
    mesh.vertices.grow(q + 1);
    mesh.vertex_hint.grow(q + 1);
    mesh.vertices.push_back(Vertex{{p[0], p[1], p[2]}, point, 0});
    mesh.vertex_hint.push_back(no_tetrahedron);
    Insertion result;
    try {
        result = insert(q, Locator{mesh, state_.calls(), nullptr}.tetrahedron_of(v));
        if (result.duplicate != infinite_vertex) others_.join(result.duplicate, point);
    } catch (...) {
        mesh.vertices.pop_back();
        mesh.vertex_hint.pop_back();
        throw;
    }
    state_.walk_starts.last = result.tetrahedron;
    state_.note(q, result);
    --state_.statistics.duplicates;
    std::uint32_t& stand_in = mesh.vertices[v].index;
    if (stand_in == point) stand_in = other;
    if (result.duplicate == infinite_vertex) {
        state_.points.map[point] = q;
    } else {
        mesh.vertices.pop_back();
        mesh.vertex_hint.pop_back();
    }
}

}  // namespace

void move_points(State& state, const Buffer<std::uint32_t>& points, const double* xyz) {
    const std::size_t n = points.size();
    state.points.require_in(points, "moved", state.settings.index_base);
    if (n == 0) return;
    for (std::size_t i = 0; i < 3 * n; ++i)
        require_finite(xyz[i], i % 3,
                       static_cast<long long>(points[i / 3]) + state.settings.index_base);

    const StopFlag::Call call(state.progress.stop());
    Stopwatch watch(state.statistics.move_seconds);
    MovedPoints moved(state.allocator, n);
    const Locator locator{state.mesh, state.calls(), nullptr};
    for (std::size_t i = 0; i < n; ++i) {
        double now[3];
        locator.unscaled(state.points.map[points[i]], now);
        if (std::equal(now, now + 3, xyz + 3 * i)) continue;
        moved.points.push_back(points[i]);
        for (std::size_t k = 0; k < 3; ++k) moved.xyz.push_back(xyz[3 * i + k]);
        moved.positions_in_list.push_back(static_cast<std::uint32_t>(i));
    }
    const std::size_t size = moved.size();
    state.progress.report(0, n);
    state.progress.stop_if_cancelled(0, n);
    if (size == 0) {
        state.progress.report(n, n);
        return;
    }
    const double* const axis[3] = {moved.xyz.data(), moved.xyz.data() + 1, moved.xyz.data() + 2};
    Team alone;
    state.points.exponents.add(PointScan(alone, size, axis, 3, 0).exponents);
    state.points.exponents_are_wide = true;
    state.numbering.forget();
    state.walk_starts.expect_changes(size);
    state.set_scale(scale_for(state, size, axis, 3));
    if (size > 1) state.points.equals.forget();
    const bool is_one_by_one = state.mesh.live_count() != 0 && !is_rebuild_faster(state, size);
    if (is_one_by_one || !try_to_rebuild(state, [&] { rebuild_moved(state, moved, 0); }))
        Motion(state, moved).one_by_one();
    state.progress.report(size, size);
}

}  // namespace mgdt
