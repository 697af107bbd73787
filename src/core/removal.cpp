// SPDX-License-Identifier: MIT
// Points are taken out. A vertex at which other points remain gets one of these for its index. With
// its last point the vertex goes, and the hole is filled (kernel/vertex_removal.hpp).
#include <algorithm>

#include "core/batch.hpp"
#include "core/equal_points.hpp"
#include "core/stopwatch.hpp"
#include "core/triangulation.hpp"
#include "platform/error.hpp"

namespace mgdt {

class Triangulation::Removal {
  public:
    Removal(Triangulation& triangulation, const Buffer<std::uint32_t>& points)
        : t(triangulation),
          vertex(triangulation.vertex_removal_),
          equal_points(triangulation.allocator_, triangulation.mesh_.vertices.size()),
          gaps(triangulation.allocator_) {
        gaps.reserve(points.size());
        if (t.are_equals_among(points)) equal_points.find(t.point_map_, points);
    }
    ~Removal() { t.close_gaps(gaps); }
    Removal(const Removal&) = delete;
    Removal& operator=(const Removal&) = delete;

    // Fetches what taking the point out will begin with.
    void announce(std::uint32_t point) const noexcept {
        if (t.mesh_.vertex_hint.empty()) return;
        const TetId near = t.mesh_.vertex_hint[t.point_map_[point]];
        if (near != no_tetrahedron) t.mesh_.tetrahedra.prefetch(near);
    }
    // Returns false, with the point still in, where the budget says that all `left` points that are
    // to go are better left out of a new triangulation.
    bool try_to_take_out(std::uint32_t point, RemovalBudget* budget, std::size_t left);

  private:
    Triangulation& t;
    VertexRemoval& vertex;
    EqualPoints equal_points;
    Buffer<VertexId> gaps;  // vertices that are gone
};

bool Triangulation::Removal::try_to_take_out(std::uint32_t point, RemovalBudget* budget,
                                             std::size_t left) {
    Mesh& mesh = t.mesh_;
    const VertexId v = t.point_map_[point];
    const std::uint32_t other = equal_points.least_other(t.point_map_, v, point);
    if (other != no_index) {
        std::uint32_t& stand_in = mesh.vertices[v].index;
        if (stand_in == point) stand_in = other;
        t.point_map_[point] = infinite_vertex;
        --t.statistics_.duplicates;
        ++t.statistics_.removed;
        return true;
    }
    if (mesh.live_count() != 0) {
        t.find_link(v);
        if (budget && t.is_rebuild_better(*budget, left)) return false;
        const std::size_t tetrahedra = t.fill_hole();
        if (budget) budget->add(vertex.link_size(), tetrahedra);
        if (vertex.leaves_space()) {
            t.last_ = vertex.replace(mesh);
            mesh.guards_agree = false;
            t.statistics_.link_vertices += vertex.link_size();
        } else {
            mesh.drop_tetrahedra();
            t.location_tree_.forget();
            mesh.vertex_hint.clear();
            t.last_ = no_tetrahedron;
        }
        t.workspace_.slot_count = 0;
    }
    if (!mesh.vertex_hint.empty()) mesh.vertex_hint[v] = no_tetrahedron;
    gaps.push_back(v);
    t.point_map_[point] = infinite_vertex;
    --t.statistics_.points_inserted;
    ++t.statistics_.removed;
    return true;
}

// Whether some of these points share a vertex with others, or have done so.
bool Triangulation::are_equals_among(const Buffer<std::uint32_t>& points) const noexcept {
    return statistics_.duplicates != 0 &&
           std::any_of(points.begin(), points.end(), [this](std::uint32_t i) {
               return mesh_.vertices[point_map_[i]].moved_to == has_equals;
           });
}

// All are in, and each is there once.
void Triangulation::require_in(const Buffer<std::uint32_t>& points, const char* what) const {
    const auto named = [&](std::uint32_t i) {
        return static_cast<long long>(i) + settings_.index_base;
    };
    Buffer<std::uint32_t> sorted(allocator_);
    sorted.reserve(points.size());
    for (const std::uint32_t i : points) {
        if (i >= point_map_.size())
            fail(MGDT_ERR_INVALID_ARGUMENT,
                 "there is no point %lld: %zu were given, counted from %d", named(i),
                 point_map_.size(), static_cast<int>(settings_.index_base));
        if (point_map_[i] == infinite_vertex)
            fail(MGDT_ERR_INVALID_ARGUMENT, "point %lld is not in the triangulation", named(i));
        sorted.push_back(i);
    }
    std::sort(sorted.begin(), sorted.end());
    const std::uint32_t* const twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
        fail(MGDT_ERR_INVALID_ARGUMENT, "point %lld is to be %s twice", named(*twice), what);
}

void Triangulation::rebuild_without(const std::uint32_t* points, std::size_t count,
                                    std::size_t total) {
    Batch rest(allocator_);
    {
        Buffer<bool> leaves(allocator_);
        leaves.resize(point_map_.size(), false);
        for (std::size_t k = 0; k < count; ++k) leaves[points[k]] = true;
        rest.begin_gathering(point_map_.size() - count);
        for (std::uint32_t i = 0; i < point_map_.size(); ++i)
            if (point_map_[i] != infinite_vertex && !leaves[i])
                rest.gather(mesh_.point(point_map_[i]), i);
    }
    rest.end_gathering();
    rebuild(rest, total - count, total);
    statistics_.removed += count;
}

std::size_t Triangulation::remove_one_by_one(const Buffer<std::uint32_t>& points, std::size_t total,
                                             bool may_stop) {
    Removal removal(*this, points);
    RemovalBudget budget = removal_budget();
    const std::size_t first = total - points.size();
    std::size_t done = 0;
    constexpr std::size_t ahead = 4;
    change_one_by_one(
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

void Triangulation::remove(const Buffer<std::uint32_t>& points) {
    require_in(points, "removed");
    const std::size_t n = points.size();
    if (n == 0) return;
    const ForgetRequest forget{cancelled_};
    const Stopwatch watch(statistics_.remove_seconds);
    forget_numbering();
    change_location_tree(n);
    exponents_are_wide_ = true;
    report(0, n);
    stop_if_cancelled(0, n);
    // In the order of vertices, which mostly follow a curve: what one needs is near what the one
    // before has used.
    Buffer<std::uint32_t> left(allocator_);
    left.reserve(n);
    for (const std::uint32_t i : points) left.push_back(i);
    std::sort(left.begin(), left.end(), [this](std::uint32_t i, std::uint32_t j) {
        return point_map_[i] != point_map_[j] ? point_map_[i] < point_map_[j] : i < j;
    });
    const auto rebuild_without_those_left = [&] { rebuild_without(left.data(), left.size(), n); };
    // Points that are held cost nothing to take out.
    const bool is_held = mesh_.live_count() == 0;
    if (!is_held && is_rebuild_faster(n) && try_to_rebuild(rebuild_without_those_left))
        return report(n, n);
    const std::size_t done = remove_one_by_one(left, n, !is_held);
    std::copy(left.begin() + done, left.end(), left.begin());
    left.resize_within_capacity(n - done);
    if (!left.empty() && !try_to_rebuild(rebuild_without_those_left))
        remove_one_by_one(left, n, false);
    report(n, n);
}

void Triangulation::forget_absent_points() noexcept {
    forget_numbering();
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < point_map_.size(); ++i) {
        const VertexId v = point_map_[i];
        if (v == infinite_vertex) continue;
        point_map_[next] = v;
        // The first of its points is the least.
        if (mesh_.vertices[v].index == i) mesh_.vertices[v].index = next;
        ++next;
    }
    // Coordinates of points that were left out of an insertion count among those given.
    if (next < point_map_.size()) exponents_are_wide_ = true;
    point_map_.resize_within_capacity(next);
}

// Several threads need guards that agree. A hole is filled by vertices of any age, and a vertex
// that moved to a gap has the number of another age. So all tetrahedra are put in the order of
// numbers; vertices to come have larger ones.
void Triangulation::make_guards_agree() noexcept {
    if (mesh_.guards_agree) return;
    mesh_.guards_agree = true;
    for (TetId t = 0; t < mesh_.tetrahedra.size(); ++t) {
        Tetrahedron& record = mesh_.tetrahedra[t];
        if (record.is_dead()) continue;
        const Tetrahedron before = record;
        unsigned place[4];
        if (!places_by_number(before.v, place)) continue;
        for (unsigned i = 0; i < 4; ++i) {
            record.v[place[i]] = before.v[i];
            record.n[place[i]] = before.n[i];
            mesh_.tetrahedra[tetrahedron_of(before.n[i])].n[face_of(before.n[i])] =
                facet_code(t, place[i]);
        }
        if (mesh_.tetrahedra.has_spheres())
            mesh_.tetrahedra.sphere(t) = rounded(circumsphere(record, mesh_.vertices.data()));
    }
}

// The last vertices move to the places of those that are gone.
void Triangulation::close_gaps(Buffer<VertexId>& gaps) noexcept {
    if (gaps.empty()) return;
    std::sort(gaps.begin(), gaps.end());
    Buffer<TetId>& hints = mesh_.vertex_hint;
    std::size_t end = mesh_.vertices.size(), moved = 0;
    for (std::size_t i = 0, left = gaps.size(); i < left; ++i) {
        // Gaps at the end are closed by leaving them out.
        while (left > i && gaps[left - 1] == end - 1) --left, --end;
        if (left == i) break;
        const VertexId gap = gaps[i];
        --end;
        mesh_.vertices[gap] = mesh_.vertices[end];
        if (!hints.empty()) hints[gap] = hints[end];
        mesh_.vertices[end].moved_to = gap;
        ++moved;
    }
    Team team;
    if (moved > 0) {
        renumber_moved(team, end, moved);
        if (statistics_.duplicates == 0) {
            for (const VertexId gap : gaps)
                if (gap < end) point_map_[mesh_.vertices[gap].index] = gap;
        } else {
            renumber_points(team, end, 0);
        }
    }
    mesh_.vertices.resize_within_capacity(end);
    if (!hints.empty()) hints.resize_within_capacity(end);
    if (mesh_.live_count() == 0) {
        // The points that remain are held until others span space with them.
        AffineBasis basis;
        for (VertexId v = 1; v < mesh_.vertices.size() && basis.dimension() < 3; ++v)
            basis.add(mesh_.point(v));
        basis_ = basis;
        degenerate_.clear();
    }
}

}  // namespace mgdt
