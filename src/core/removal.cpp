// SPDX-License-Identifier: MIT
// Points are taken out. A vertex at which other points remain gets one of these for its index. With
// its last point the vertex goes, and the hole is filled (kernel/vertex_removal.hpp).
#include <algorithm>

#include "core/triangulation.hpp"
#include "platform/error.hpp"
#include "query/locate.hpp"

namespace mgdt {
namespace {

// A point that is in, by its vertex.
struct PointOfVertex {
    VertexId vertex;
    std::uint32_t point;
    bool operator<(const PointOfVertex& other) const {
        return vertex != other.vertex ? vertex < other.vertex : point < other.point;
    }
};

}  // namespace

struct Triangulation::Removal {
    Removal(Triangulation& triangulation, std::size_t n)
        : t(triangulation),
          vertex(triangulation.vertex_removal_),
          gaps(triangulation.allocator_),
          points(triangulation.allocator_) {
        gaps.reserve(n);
    }
    ~Removal() { t.close_gaps(gaps); }

    // The points at the vertices of those that are taken out, if some share a vertex.
    void find_equal_points(const Buffer<std::uint32_t>& removed);
    // The least other point at a vertex of several; no_index if there is none.
    std::uint32_t other_point(VertexId v, std::uint32_t than) const;
    void take_out(std::uint32_t point);

    Triangulation& t;
    VertexRemoval& vertex;
    Buffer<VertexId> gaps;         // vertices that are gone
    Buffer<PointOfVertex> points;  // sorted
};

void Triangulation::Removal::find_equal_points(const Buffer<std::uint32_t>& removed) {
    if (t.statistics_.duplicates == 0) return;
    Buffer<bool> is_affected(t.allocator_);
    is_affected.resize(t.mesh_.vertices.size(), false);
    for (const std::uint32_t i : removed) is_affected[t.point_map_[i]] = true;
    for (std::size_t i = 0; i < t.point_map_.size(); ++i) {
        const VertexId v = t.point_map_[i];
        if (v != infinite_vertex && is_affected[v])
            points.push_back({v, static_cast<std::uint32_t>(i)});
    }
    std::sort(points.begin(), points.end());
}

std::uint32_t Triangulation::Removal::other_point(VertexId v, std::uint32_t than) const {
    const PointOfVertex first = {v, 0};
    for (const PointOfVertex* p = std::lower_bound(points.begin(), points.end(), first);
         p != points.end() && p->vertex == v; ++p)
        if (p->point != than && t.point_map_[p->point] == v) return p->point;
    return no_index;
}

void Triangulation::Removal::take_out(std::uint32_t point) {
    Mesh& mesh = t.mesh_;
    const VertexId v = t.point_map_[point];
    const std::uint32_t other = other_point(v, point);
    if (other != no_index) {
        std::uint32_t& stand_in = mesh.vertices[v].index;
        if (stand_in == point) stand_in = other;
        t.point_map_[point] = infinite_vertex;
        --t.statistics_.duplicates;
        return;
    }
    if (mesh.live_count() != 0) {
        vertex.prepare(mesh, v, Locator{mesh, t.calls(), nullptr}.tetrahedron_of(v));
        if (vertex.leaves_space()) {
            t.last_ = vertex.replace(mesh);
            mesh.guards_agree = false;
        } else {
            mesh.drop_tetrahedra();
            mesh.vertex_hint.clear();
            t.last_ = no_tetrahedron;
        }
        t.workspace_.slot_count = 0;
    }
    if (!mesh.vertex_hint.empty()) mesh.vertex_hint[v] = no_tetrahedron;
    gaps.push_back(v);
    t.point_map_[point] = infinite_vertex;
    --t.statistics_.points_inserted;
}

void Triangulation::require_removable(const Buffer<std::uint32_t>& points) const {
    const auto named = [&](std::uint32_t i) {
        return static_cast<long long>(i) + settings_.index_base;
    };
    Buffer<std::uint32_t> sorted(allocator_);
    sorted.reserve(points.size());
    for (const std::uint32_t i : points) {
        if (i >= point_map_.size())
            fail(MGDT_ERR_INVALID_ARGUMENT, "there is no point %lld: %zu were given", named(i),
                 point_map_.size());
        if (point_map_[i] == infinite_vertex)
            fail(MGDT_ERR_INVALID_ARGUMENT, "point %lld is not in the triangulation", named(i));
        sorted.push_back(i);
    }
    std::sort(sorted.begin(), sorted.end());
    const std::uint32_t* const twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
        fail(MGDT_ERR_INVALID_ARGUMENT, "point %lld is to be removed twice", named(*twice));
}

void Triangulation::remove(const Buffer<std::uint32_t>& points) {
    require_removable(points);
    const std::size_t n = points.size();
    if (n == 0) return;
    const ForgetRequest forget{cancelled_};
    Removal removal(*this, n);
    removal.find_equal_points(points);
    forget_numbering();
    location_tree_.forget();
    const std::size_t report_interval = std::max<std::size_t>(n / 100, 1);
    std::size_t next_report = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const bool is_due = i >= next_report;
        if (is_due) {
            next_report += report_interval;
            report(i, n);
        }
        if (is_due || i % poll_interval == 0) stop_if_cancelled(i, n);
        removal.take_out(points[i]);
    }
    report(n, n);
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
