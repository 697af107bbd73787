// SPDX-License-Identifier: MIT
#include "domain/kept_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boundary/boundary_edges.hpp"
#include "domain/regions.hpp"
#include "mesh/bounding_box.hpp"
#include "parallel/thread_count.hpp"
#include "platform/objects.hpp"
#include "recovery/boundary_recovery.hpp"
#include "recovery/triangle_table.hpp"
#include "solid/sorted_corners.hpp"

namespace mgdt {
namespace {

constexpr std::uint32_t box_corners = 8;

// Numbers vertices by their coordinates, so that what follows does not depend on their order.
class CanonicalOrder {
  public:
    CanonicalOrder(const Buffer<double>& points, Allocator& allocator)
        : of_rank_(allocator), rank_(allocator) {
        const auto n = static_cast<std::uint32_t>(points.size() / 3);
        for (std::uint32_t v = 0; v < n; ++v) of_rank_.push_back(v);
        std::sort(of_rank_.begin(), of_rank_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return compare_lexicographic(points.begin() + 3 * std::size_t{a},
                                         points.begin() + 3 * std::size_t{b}) < 0;
        });
        rank_.resize(n);
        for (std::uint32_t i = 0; i < n; ++i) rank_[of_rank_[i]] = i;
    }
    std::uint32_t vertex(std::size_t rank) const noexcept { return of_rank_[rank]; }
    std::uint32_t rank(std::uint32_t vertex) const noexcept { return rank_[vertex]; }
    std::size_t size() const noexcept { return rank_.size(); }

  private:
    Buffer<std::uint32_t> of_rank_, rank_;
};

// Writes the points in their order, and after them the corners of a box around all of them.
void write_points(const Buffer<double>& from, const CanonicalOrder& order, Buffer<double>& points) {
    constexpr double margin = 4;  // times the largest side of the bounding box
    BoundingBox box(from.begin());
    points.reserve(from.size() + 3 * box_corners);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const double* const x = from.begin() + 3 * std::size_t{order.vertex(i)};
        box.include(x);
        for (int k = 0; k < 3; ++k) points.push_back(x[k]);
    }
    double size = 0;
    for (int k = 0; k < 3; ++k) size = std::max(size, box.high[k] - box.low[k]);
    for (std::uint32_t corner = 0; corner < box_corners; ++corner)
        for (unsigned k = 0; k < 3; ++k) {
            constexpr double infinity = std::numeric_limits<double>::infinity();
            // Adding the margin to a much larger coordinate may change nothing. The box ends at the
            // next double then, so that all points are inside of it.
            const double x =
                (corner >> k & 1) != 0
                    ? std::max(box.high[k] + margin * size, std::nextafter(box.high[k], infinity))
                    : std::min(box.low[k] - margin * size, std::nextafter(box.low[k], -infinity));
            if (!std::isfinite(x))
                fail(MGDT_ERR_RESOLUTION,
                     "the coordinates are so large that no box around the boundary is possible");
            points.push_back(x);
        }
}

// Copies the tetrahedra of a triangulation, sorted by their corners.
void copy_tetrahedra(const ConstrainedMesh& from, Team& team, Allocator& allocator, FlipMesh& to) {
    const std::size_t n = from.tetrahedra.size();
    Buffer<SortedCorners<4>> records(allocator, n);
    for (std::uint32_t t = 0; t < n; ++t) {
        SortedCorners<4>& record = records[t];
        std::copy_n(from.tetrahedra[t].v, 4, record.v);
        record.from = t;
        record.sort();
        if (record.is_odd) std::swap(record.v[2], record.v[3]);
    }
    sort_by_corners(team, allocator, records);
    Buffer<std::uint32_t> number(allocator, n);
    for (std::uint32_t i = 0; i < n; ++i) number[records[i].from] = i;
    to.tetrahedra.resize(n);
    to.hints.resize(from.hints.size(), no_tetrahedron);
    for (std::uint32_t i = 0; i < n; ++i) {
        LinkedTetrahedra::Tetrahedron& t = to.tetrahedra[i];
        const LinkedTetrahedra::Tetrahedron& old = from.tetrahedra[records[i].from];
        for (unsigned k = 0; k < 4; ++k) {
            t.v[k] = records[i].v[k];
            t.facets[k] = no_index;
            to.hints[t.v[k]] = i;
            const std::uint32_t behind = old.n[old.position(t.v[k])];
            t.n[k] = no_index;
            if (behind == no_index) continue;
            const std::uint32_t next = number[behind / 4], apex = from.apex(behind);
            t.n[k] = 4 * next;
            while (records[next].v[t.n[k] % 4] != apex) ++t.n[k];
        }
    }
}

RecoveryInput make_input(const Boundary& boundary, const CanonicalOrder& order,
                         Allocator& allocator) {
    RecoveryInput input(allocator);
    Boundary ranked(allocator);
    for (const std::uint32_t v : boundary.triangles) ranked.triangles.push_back(order.rank(v));
    for (const std::uint32_t v : boundary.segments) ranked.segments.push_back(order.rank(v));
    // The shortest segments come first, because they cross least.
    struct Segment {
        double length;
        std::uint32_t a, b;
        bool operator<(const Segment& s) const {
            return length != s.length ? length < s.length : a != s.a ? a < s.a : b < s.b;
        }
    };
    Buffer<Segment> segments(allocator);
    const Buffer<BoundaryEdge> edges = sorted_edges(ranked, allocator);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (i > 0 && edges[i].has_ends_of(edges[i - 1])) continue;
        const double* const x = boundary.points.begin() + 3 * std::size_t{order.vertex(edges[i].a)};
        const double* const y = boundary.points.begin() + 3 * std::size_t{order.vertex(edges[i].b)};
        segments.push_back(
            {std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]), edges[i].a, edges[i].b});
    }
    std::sort(segments.begin(), segments.end());
    for (const Segment& s : segments) {
        input.segments.push_back(s.a);
        input.segments.push_back(s.b);
    }
    Buffer<SortedCorners<3>> triangles(allocator);
    for (std::uint32_t i = 0; i < ranked.triangles.size() / 3; ++i) {
        SortedCorners<3> record = {{}, i, false};
        std::copy_n(ranked.triangles.begin() + 3 * std::size_t{i}, 3, record.v);
        record.sort();
        triangles.push_back(record);
    }
    std::sort(triangles.begin(), triangles.end());
    for (const SortedCorners<3>& t : triangles)
        for (const std::uint32_t v : t.v) input.triangles.push_back(v);
    return input;
}

// Marks the faces that are triangles of the boundary.
void mark_faces(const Boundary& boundary, const CanonicalOrder& order, Allocator& allocator,
                FlipMesh& mesh) {
    Buffer<std::uint32_t> corners(allocator);
    for (const std::uint32_t v : boundary.triangles) corners.push_back(order.rank(v));
    const TriangleTable table(corners, order.size(), allocator);
    std::size_t missing = corners.size() / 3;
    for (std::uint32_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        const FlipMesh::Tetrahedron& tet = mesh.tetrahedra[t];
        for (unsigned k = 0; k < 4 && !tet.is_dead(); ++k) {
            // Each face inside is seen from the lesser one of its two tetrahedra.
            if (tet.n[k] == no_index || tet.n[k] / 4 < t) continue;
            const std::uint32_t f =
                table.find(tet.v[(k + 1) % 4], tet.v[(k + 2) % 4], tet.v[(k + 3) % 4]);
            if (f == no_index) continue;
            mesh.mark(4 * t + k, f);
            --missing;
        }
    }
    if (missing != 0) fail(MGDT_ERR_INTERNAL, "a facet that was recovered is missing");
}

// Moves the mesh to the result. Vertices get the numbers that the result has.
void write(const CanonicalOrder& order, const Buffer<double>& points, FlipMesh& mesh,
           Allocator& allocator, KeptBoundary& result) {
    const std::size_t given = order.size(), all = points.size() / 3;
    Buffer<std::uint32_t> number(allocator, all);
    for (std::uint32_t i = 0; i < all; ++i)
        number[i] = i < given ? order.vertex(i)
                    : i < given + box_corners
                        ? i + static_cast<std::uint32_t>(all - given) - box_corners
                        : i - box_corners;
    result.points.resize(points.size());
    for (std::size_t i = 0; i < all; ++i)
        std::copy_n(points.begin() + 3 * i, 3, result.points.begin() + 3 * std::size_t{number[i]});
    result.mesh.tetrahedra = std::move(mesh.tetrahedra);
    result.mesh.free_slots = std::move(mesh.free_slots);
    for (LinkedTetrahedra::Tetrahedron& t : result.mesh.tetrahedra)
        for (unsigned k = 0; k < 4 && !t.is_dead(); ++k) t.v[k] = number[t.v[k]];
}

// Makes the Delaunay triangulation of the points.
void triangulate(const Buffer<double>& points, int threads, Allocator& allocator,
                 StageProgress& progress, FlipMesh& mesh) {
    // A triangulation is too large for the stack.
    Objects<Triangulation> storage(allocator, 1, &Allocator::allocate_from, &Allocator::release_to,
                                   static_cast<void*>(&allocator));
    Triangulation& triangulation = storage[0];
    triangulation.settings().threads = threads;
    progress.watch(triangulation.settings(), 0, 1, [&] {
        const double* const axis[3] = {points.begin(), points.begin() + 1, points.begin() + 2};
        triangulation.insert(points.size() / 3, axis, 3);
    });
    Team team(thread_count(triangulation.settings()));
    copy_tetrahedra(ConstrainedMesh(triangulation, points, allocator), team, allocator, mesh);
}

}  // namespace

void keep_boundary(const Complex& complex, int threads, Allocator& allocator,
                   StageProgress& progress, KeptBoundary& result) {
    // A segment may be lost because of those before it, so others are tried first.
    constexpr RecoveryEffort efforts[] = {{{200, 1000, 1500}, 150, 100, false},
                                          {{200, 1500, 2000}, 200, 300, true},
                                          {{200, 2000, 4000}, 400, 600, false},
                                          {{300, 2500, 5000}, 500, 1200, true}};
    const Boundary& boundary = complex.boundary;
    const CanonicalOrder order(boundary.points, allocator);
    const RecoveryInput input = make_input(boundary, order, allocator);
    for (const RecoveryEffort& effort : efforts) {
        Buffer<double> points(allocator);
        write_points(boundary.points, order, points);
        FlipMesh mesh(points, allocator);
        progress.enter(0, 0.3);
        triangulate(points, threads, allocator, progress, mesh);
        progress.enter(0.3, 0.9);
        BoundaryRecovery recovery(mesh, input, effort, progress.stop_request(), allocator);
        if (!recovery.run()) {
            for (int k = 0; k < 2; ++k) result.lost_edge[k] = order.vertex(recovery.lost_edge()[k]);
            progress.leave_behind(0.9);
            continue;
        }
        progress.enter(0.9, 1);
        mark_faces(boundary, order, allocator, mesh);
        write(order, points, mesh, allocator, result);
        result.lost_edge[0] = result.lost_edge[1] = no_index;
        return;
    }
}

std::size_t sort_added_points(KeptBoundary& boundary, const Buffer<std::uint32_t>& regions,
                              std::size_t given, Allocator& allocator) {
    Buffer<double>& points = boundary.points;
    const std::size_t all = points.size() / 3;
    Buffer<std::uint8_t> is_used(allocator);
    is_used.resize(all, 0);
    for (std::size_t t = 0; t < boundary.mesh.tetrahedra.size(); ++t) {
        const LinkedTetrahedra::Tetrahedron& tet = boundary.mesh.tetrahedra[t];
        for (unsigned k = 0; k < 4 && !tet.is_dead() && regions[t] != Regions::outside; ++k)
            is_used[tet.v[k]] = 1;
    }
    Buffer<std::uint32_t> order(allocator), number(allocator);
    for (auto v = static_cast<std::uint32_t>(given); v < all; ++v) order.push_back(v);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        if (is_used[a] != is_used[b]) return is_used[a] > is_used[b];
        return compare_lexicographic(boundary.mesh.point(a), boundary.mesh.point(b)) < 0;
    });
    Buffer<double> sorted(allocator);
    number.resize(all);
    for (std::uint32_t v = 0; v < given; ++v) number[v] = v;
    std::size_t used = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        number[order[i]] = static_cast<std::uint32_t>(given + i);
        used += is_used[order[i]];
        for (int k = 0; k < 3; ++k) sorted.push_back(boundary.mesh.point(order[i])[k]);
    }
    std::copy_n(sorted.begin(), sorted.size(), points.begin() + 3 * given);
    for (LinkedTetrahedra::Tetrahedron& t : boundary.mesh.tetrahedra)
        for (unsigned k = 0; k < 4 && !t.is_dead(); ++k) t.v[k] = number[t.v[k]];
    return used;
}

}  // namespace mgdt
