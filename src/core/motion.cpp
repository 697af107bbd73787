// SPDX-License-Identifier: MIT
// Points move: one by one, each by a removal and an insertion, or all at once by a rebuild.
#include <algorithm>

#include "core/batch.hpp"
#include "core/equal_points.hpp"
#include "core/stopwatch.hpp"
#include "core/triangulation.hpp"
#include "platform/error.hpp"
#include "query/locate.hpp"

namespace mgdt {

// Those whose coordinates change, with the new ones as the caller gave them.
struct Triangulation::MovedPoints {
    MovedPoints(Allocator& allocator, std::size_t listed)
        : points(allocator), xyz(allocator), places_in_list(allocator), list_size(listed) {
        points.reserve(listed);
        xyz.reserve(3 * listed);
        places_in_list.reserve(listed);
    }

    std::size_t size() const noexcept { return points.size(); }
    // Scaled, -0 made 0.
    void place(std::size_t k, int scale, double (&p)[3]) const noexcept {
        for (std::size_t i = 0; i < 3; ++i) p[i] = scaled(xyz[3 * k + i], scale) + 0.0;
    }

    Buffer<std::uint32_t> points;
    Buffer<double> xyz;
    // Where each is in the caller's list, which has those that stay as well.
    Buffer<std::uint32_t> places_in_list;
    std::size_t list_size;
};

class Triangulation::Motion {
  public:
    Motion(Triangulation& triangulation, const MovedPoints& moved)
        : t_(triangulation),
          moved_(moved),
          equal_points_(triangulation.allocator_, triangulation.mesh_.vertices.size()),
          gaps_(triangulation.allocator_),
          budget_(triangulation.removal_budget()) {}
    ~Motion() { t_.close_gaps(gaps_); }
    Motion(const Motion&) = delete;
    Motion& operator=(const Motion&) = delete;

    void one_by_one();

  private:
    // False, with the point where it was, where those from k on are to be moved by a new
    // triangulation: they have to be, or it is faster.
    bool try_to_move(std::size_t k);
    bool try_to_move_vertex(VertexId v, std::uint32_t point, const double (&p)[3],
                            std::size_t left);
    void split_off(VertexId v, std::uint32_t point, const double (&p)[3], std::uint32_t other);
    Insertion insert(VertexId q, TetId start);

    Triangulation& t_;
    const MovedPoints& moved_;
    EqualPoints equal_points_;
    Buffer<VertexId> gaps_;  // vertices that are gone
    RemovalBudget budget_;
    bool has_budget_ = true, is_too_slow_ = false;
};

void Triangulation::Motion::one_by_one() {
    const std::size_t n = moved_.size();
    gaps_.reserve(n);
    if (t_.are_equals_among(moved_.points)) equal_points_.find(t_.point_map_, moved_.points);
    t_.change_one_by_one(
        0, n, moved_.list_size,
        [this](std::size_t k) { return std::size_t{moved_.places_in_list[k]}; },
        [this](std::size_t k) {
            if (try_to_move(k)) return true;
            const auto rebuild = [&] { t_.rebuild_moved(moved_, k); };
            if (!is_too_slow_) {
                // The others do not span space without this vertex.
                rebuild();
            } else if (!t_.try_to_rebuild(rebuild)) {
                // There is no memory for the faster way.
                has_budget_ = is_too_slow_ = false;
                if (try_to_move(k)) return true;
                rebuild();
            }
            gaps_.clear();
            return false;
        });
}

bool Triangulation::Motion::try_to_move(std::size_t k) {
    const std::uint32_t point = moved_.points[k];
    double p[3];
    moved_.place(k, t_.mesh_.scale, p);
    if (!in_normal_range(p)) t_.mesh_.has_extremes = true;
    const VertexId v = t_.point_map_[point];
    const std::uint32_t other = equal_points_.least_other(t_.point_map_, v, point);
    if (other != no_index)
        split_off(v, point, p, other);
    else if (!try_to_move_vertex(v, point, p, moved_.size() - k))
        return false;
    ++t_.statistics_.moved;
    ++t_.statistics_.put_back;
    return true;
}

Insertion Triangulation::Motion::insert(VertexId q, TetId start) {
    t_.workspace_.may_jump = true;
    return t_.calls().insert(t_.mesh_, t_.workspace_, q, start);
}

// A vertex with one point keeps its number.
bool Triangulation::Motion::try_to_move_vertex(VertexId v, std::uint32_t point,
                                               const double (&p)[3], std::size_t left) {
    Mesh& mesh = t_.mesh_;
    VertexRemoval& removal = t_.vertex_removal_;
    t_.find_link(v);
    is_too_slow_ = has_budget_ && t_.is_rebuild_better(budget_, left);
    if (is_too_slow_) return false;
    budget_.add(removal.link_size(), t_.fill_hole());
    if (!removal.leaves_space()) return false;
    removal.keep_star(mesh);
    double before[3];
    std::copy_n(mesh.vertices[v].x, 3, before);
    t_.last_ = removal.replace(mesh);
    mesh.guards_agree = false;
    mesh.vertex_hint[v] = no_tetrahedron;
    t_.workspace_.slot_count = 0;
    std::copy_n(p, 3, mesh.vertices[v].x);
    try {
        const Insertion result = insert(v, t_.last_);
        if (result.duplicate != infinite_vertex) {
            equal_points_.join(result.duplicate, point);
            gaps_.push_back(v);
            t_.note_repeat(v, result.duplicate);
            --t_.statistics_.points_inserted;
        }
        t_.last_ = result.tetrahedron;
    } catch (...) {
        std::copy_n(before, 3, mesh.vertices[v].x);
        t_.last_ = removal.undo(mesh);
        t_.workspace_.slot_count = 0;
        throw;
    }
    t_.statistics_.link_vertices += removal.link_size();
    return true;
}

// One of several points at a vertex goes elsewhere; `other` is the least of those that stay.
void Triangulation::Motion::split_off(VertexId v, std::uint32_t point, const double (&p)[3],
                                      std::uint32_t other) {
    Mesh& mesh = t_.mesh_;
    const auto q = static_cast<VertexId>(mesh.vertices.size());
    if (q >= mesh.vertex_limit)
        fail(MGDT_ERR_TOO_LARGE, "more than %u vertices", mesh.vertex_limit);
    mesh.vertices.grow(q + 1);
    mesh.vertex_hint.grow(q + 1);
    mesh.vertices.push_back(Vertex{{p[0], p[1], p[2]}, point, 0});
    mesh.vertex_hint.push_back(no_tetrahedron);
    Insertion result;
    try {
        result = insert(q, Locator{mesh, t_.calls(), nullptr}.tetrahedron_of(v));
        if (result.duplicate != infinite_vertex) equal_points_.join(result.duplicate, point);
    } catch (...) {
        mesh.vertices.pop_back();
        mesh.vertex_hint.pop_back();
        throw;
    }
    t_.last_ = result.tetrahedron;
    t_.note(q, result);
    --t_.statistics_.duplicates;
    std::uint32_t& stand_in = mesh.vertices[v].index;
    if (stand_in == point) stand_in = other;
    if (result.duplicate == infinite_vertex) {
        t_.point_map_[point] = q;
    } else {
        mesh.vertices.pop_back();
        mesh.vertex_hint.pop_back();
    }
}

// All points, where they are now; those from `first` on among the moved ones where they go.
void Triangulation::rebuild_moved(const MovedPoints& moved, std::size_t first) {
    const std::size_t n = moved.size();
    Batch all(allocator_);
    {
        Buffer<std::uint32_t> order(allocator_);
        order.resize(point_map_.size(), no_index);
        for (std::size_t k = first; k < n; ++k)
            order[moved.points[k]] = static_cast<std::uint32_t>(k);
        all.begin_gathering(point_map_.size());
        for (std::uint32_t i = 0; i < point_map_.size(); ++i) {
            if (point_map_[i] == infinite_vertex) continue;
            double p[3];
            std::copy_n(mesh_.point(point_map_[i]), 3, p);
            if (order[i] != no_index) moved.place(order[i], mesh_.scale, p);
            all.gather(p, i);
        }
    }
    all.end_gathering();
    rebuild(all, moved.places_in_list[first], moved.list_size);
    statistics_.moved += n - first;
}

void Triangulation::move(const Buffer<std::uint32_t>& points, const double* xyz) {
    const std::size_t n = points.size();
    require_in(points, "moved");
    if (n == 0) return;
    for (std::size_t i = 0; i < 3 * n; ++i)
        require_finite(xyz[i], i % 3, static_cast<long long>(points[i / 3]) + settings_.index_base);

    const ForgetRequest forget{cancelled_};
    Stopwatch watch(statistics_.move_seconds);
    MovedPoints moved(allocator_, n);
    const Locator locator{mesh_, calls(), nullptr};
    for (std::size_t i = 0; i < n; ++i) {
        double now[3];
        locator.unscaled(point_map_[points[i]], now);
        if (std::equal(now, now + 3, xyz + 3 * i)) continue;
        moved.points.push_back(points[i]);
        for (std::size_t k = 0; k < 3; ++k) moved.xyz.push_back(xyz[3 * i + k]);
        moved.places_in_list.push_back(static_cast<std::uint32_t>(i));
    }
    const std::size_t size = moved.size();
    report(0, n);
    stop_if_cancelled(0, n);
    if (size == 0) {
        report(n, n);
        return;
    }
    const double* const axis[3] = {moved.xyz.data(), moved.xyz.data() + 1, moved.xyz.data() + 2};
    Team alone;
    exponents_.add(PointScan(alone, size, axis, 3, 0).exponents);
    exponents_are_wide_ = true;
    forget_numbering();
    change_location_tree(size);
    set_scale(scale_for(size, axis, 3));
    const bool is_one_by_one = mesh_.live_count() != 0 && !is_rebuild_faster(size);
    if (is_one_by_one || !try_to_rebuild([&] { rebuild_moved(moved, 0); }))
        Motion(*this, moved).one_by_one();
    report(size, size);
}

}  // namespace mgdt
