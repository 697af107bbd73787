// SPDX-License-Identifier: MIT
#include "refinement/wall_refiner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mgdt {
namespace {

// Walls are divided if their circumradius is above this many sizes, and segments if they are longer
// than sqrt(2) sizes.
constexpr double most_radius = 0.6, most_length2 = 2;

double squared_distance(const double* a, const double* b) noexcept {
    const Vector<double> d = difference<double>(a, b);
    return dot(d, d);
}

// The offset of the circumcentre of a triangle from the corner between the edges u and v.
Vector<double> center_offset(const Vector<double>& u, const Vector<double>& v) noexcept {
    const Vector<double> n = cross(u, v);
    const double nn = dot(n, n);
    const double factor = nn > 0 ? 0.5 / nn : 0;
    return factor * (dot(u, u) * cross(v, n) + dot(v, v) * cross(n, u));
}

}  // namespace

// Each facet has the frame of its largest triangle.
void WallRefiner::find_frames() {
    const WalledMesh& walled = mesh_.walled;
    edges_.for_each_side([&](FacetCode wall) {
        const std::size_t label = LinkedMesh::label_of(edges_.side(wall));
        if (label >= frames_.size()) frames_.resize(label + 1, Frame());
        VertexId v[3];
        edges_.corners(wall, v);
        const double* const a = walled.point(v[0]);
        const Vector<double> u = difference<double>(walled.point(v[1]), a),
                             w = difference<double>(walled.point(v[2]), a), n = cross(u, w);
        Frame& frame = frames_[label];
        if (dot(n, n) > frame.area2) frame = {{a[0], a[1], a[2]}, u, w, dot(n, n)};
    });
}

void WallRefiner::find_pinched_edges() {
    const WalledMesh& walled = mesh_.walled;
    Allocator& allocator = frames_.allocator();
    PairTable of_hull(allocator);
    Buffer<std::uint32_t> counts(allocator);
    for (TetId t = 0; t < walled.mesh.tetrahedra.size(); ++t) {
        const Tetrahedron& tet = walled.mesh.tetrahedra[t];
        if (tet.is_dead() || tet.is_ghost()) continue;
        for (unsigned k = 0; k < 4; ++k) {
            if (!walled.mesh.tetrahedra[tetrahedron_of(tet.n[k])].is_ghost()) continue;
            VertexId v[3];
            edges_.corners(facet_code(t, k), v);
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t e = of_hull.add(v[i], v[(i + 1) % 3]);
                if (e == counts.size()) counts.push_back(0);
                ++counts[e];
            }
        }
    }
    for (std::uint32_t e = 0; e < counts.size(); ++e)
        if (counts[e] > 2) pinched_.add(of_hull.pair(e).first, of_hull.pair(e).second);
}

// By how much a wall, or a segment at it, is too large for the sizes, squared. `longest` becomes
// the segment that is too long.
double WallRefiner::excess_of(FacetCode wall, WallInsertion::Segment& longest) const noexcept {
    const WalledMesh& walled = mesh_.walled;
    VertexId v[3];
    edges_.corners(wall, v);
    double most = 1;
    for (int k = 0; k < 3; ++k) {
        const VertexId x = v[k], y = v[(k + 1) % 3];
        const double size = 0.5 * (mesh_.sizes[x] + mesh_.sizes[y]);
        const double excess =
            squared_distance(walled.point(x), walled.point(y)) / (most_length2 * size * size);
        if (!(excess > most) || edges_.across(wall, x, y) != no_index ||
            pinched_.find(x, y) != no_index)
            continue;
        most = excess;
        longest = {x, y, wall};
    }
    const double* const a = walled.point(v[0]);
    const Vector<double> offset = center_offset(difference<double>(walled.point(v[1]), a),
                                                difference<double>(walled.point(v[2]), a));
    const double size = (mesh_.sizes[v[0]] + mesh_.sizes[v[1]] + mesh_.sizes[v[2]]) / 3,
                 bound = most_radius * size;
    return std::max(most, dot(offset, offset) / (bound * bound));
}

void WallRefiner::add(FacetCode wall) {
    WallInsertion::Segment longest;
    const double excess = excess_of(wall, longest);
    if (!(excess > 1)) return;
    bad_.push_back({excess, wall, mesh_.walled.mesh.tetrahedra[tetrahedron_of(wall)].v[0]});
    std::push_heap(bad_.begin(), bad_.end());
}

bool WallRefiner::is_there(FacetCode wall, VertexId newest) const noexcept {
    const Tetrahedron& tet = mesh_.walled.mesh.tetrahedra[tetrahedron_of(wall)];
    return !tet.is_dead() && tet.v[0] == newest && mesh_.walled.is_wall(wall);
}

void WallRefiner::divide_by_size(std::size_t most_points, StageProgress& progress) {
    edges_.for_each_side([&](FacetCode wall) {
        if (edges_.is_hull(wall) || wall < edges_.behind(wall)) add(wall);
    });
    for (std::size_t i = 0; !bad_.empty() && inserted < most_points; ++i) {
        if (i % 64 == 0) progress.stop_request().poll();
        std::pop_heap(bad_.begin(), bad_.end());
        const BadWall bad = bad_.back();
        bad_.pop_back();
        if (!is_there(bad.wall, bad.newest)) continue;
        WallInsertion::Segment longest;
        excess_of(bad.wall, longest);
        if ((longest.wall == no_index || !divide_segment(longest)) && !divide(bad.wall)) continue;
        for (const TetId t : insertion_.star())
            for (unsigned k = 0; k < 4; ++k)
                if (edges_.is_of_facet(facet_code(t, k))) add(facet_code(t, k));
    }
}

void WallRefiner::divide_by_shape(const KernelCalls& kernel, std::size_t most_points,
                                  StageProgress& progress) {
    const WalledMesh& walled = mesh_.walled;
    const std::size_t before = inserted;
    const std::size_t slots = walled.mesh.tetrahedra.size();
    for (TetId t = 0; t < slots && inserted - before < most_points; ++t) {
        if (t % 256 == 0) progress.stop_request().poll();
        const Tetrahedron& tet = walled.mesh.tetrahedra[t];
        if (tet.is_dead() || tet.is_ghost()) continue;
        const Refusal refusal = mesh_.verdicts[t].refusal();
        if (refusal != Refusal::hidden && refusal != Refusal::near_wall) continue;
        const VertexId newest = tet.v[0];
        const ElementShape e = mesh_.element(tet.v);
        NewPoint point;
        point.start = t;
        for (int k = 0; k < 3; ++k) point.x[k] = walled.point(tet.v[0])[k] + e.offset.x[k];
        if (!(e.radius2 < 16)) continue;
        const FacetCode wall = search_.find_wall(mesh_, kernel, point);
        if (wall == no_index || !edges_.is_of_facet(wall) || !divide(wall)) continue;
        // It may be there still, and may have a point now.
        const Tetrahedron& now = walled.mesh.tetrahedra[t];
        if (!now.is_dead() && now.v[0] == newest) mesh_.verdicts[t] = Verdict(mesh_.excess(now.v));
    }
}

bool WallRefiner::divide_segment(const WallInsertion::Segment& segment) {
    if (pinched_.find(segment.a, segment.b) != no_index) return false;
    double x[3];
    for (int k = 0; k < 3; ++k)
        x[k] = 0.5 * (mesh_.walled.point(segment.a)[k] + mesh_.walled.point(segment.b)[k]);
    return insert(x, segment.wall, &segment);
}

bool WallRefiner::divide(FacetCode wall) {
    double x[3];
    WallInsertion::Segment hit;
    if (!find_center(wall, x, hit)) return hit.wall != no_index && divide_segment(hit);
    return insert(x, wall, nullptr);
}

// Finds the point of the facet's lattice that is next to the circumcentre of a wall, and the wall
// that it is in. Returns false if a segment is in between, which `hit` becomes.
bool WallRefiner::find_center(FacetCode& wall, double (&x)[3],
                              WallInsertion::Segment& hit) const noexcept {
    const WalledMesh& walled = mesh_.walled;
    VertexId v[3];
    edges_.corners(wall, v);
    const double* const a = walled.point(v[0]);
    const Vector<double> offset = center_offset(difference<double>(walled.point(v[1]), a),
                                                difference<double>(walled.point(v[2]), a));
    const Frame& frame = frames_[LinkedMesh::label_of(walled.sides[wall])];
    double centre[3];
    for (int k = 0; k < 3; ++k) centre[k] = a[k] + offset.x[k];
    // In the frame.
    const Vector<double> n = cross(frame.u, frame.v), d = difference<double>(centre, frame.origin);
    const double s = dot(cross(d, frame.v), n) / frame.area2,
                 t = dot(cross(frame.u, d), n) / frame.area2;
    constexpr double steps = 65536;
    if (!(std::fabs(s) < 1e6 && std::fabs(t) < 1e6)) return false;
    const double i = std::floor(s * steps + 0.5) / steps, j = std::floor(t * steps + 0.5) / steps;
    for (int k = 0; k < 3; ++k) x[k] = frame.origin[k] + (i * frame.u.x[k] + j * frame.v.x[k]);
    // The walk from the wall to the point.
    const Vector<double> normal =
        cross(difference<double>(walled.point(v[1]), a), difference<double>(walled.point(v[2]), a));
    constexpr int most_steps = 1000;
    for (int step = 0; step < most_steps; ++step) {
        edges_.corners(wall, v);
        bool is_outside = false;
        for (int k = 0; k < 3 && !is_outside; ++k) {
            const double* const p = walled.point(v[k]);
            const double* const q = walled.point(v[(k + 1) % 3]);
            const double side =
                dot(cross(difference<double>(q, p), difference<double>(x, p)), normal);
            if (side >= 0) continue;
            is_outside = true;
            const FacetCode next = edges_.across(wall, v[k], v[(k + 1) % 3]);
            if (next == no_index) {
                hit = {v[k], v[(k + 1) % 3], wall};
                return false;
            }
            wall = next;
        }
        if (!is_outside) return true;
    }
    return false;
}

// Finds the size of a point with the cavity that was found. Returns false if it is too near to a
// vertex.
bool WallRefiner::find_size(const double* x, FacetCode wall, NewPoint& point) const noexcept {
    const WalledMesh& walled = mesh_.walled;
    std::copy_n(x, 3, point.x);
    point.size = mesh_.places.at(x, walled.regions[tetrahedron_of(wall)]);
    if (!edges_.is_hull(wall))
        point.size = std::min(
            point.size, mesh_.places.at(x, walled.regions[tetrahedron_of(edges_.behind(wall))]));
    const Numbers& vertices = insertion_.vertices();
    point.find_size(mesh_, vertices.size(), [&](std::uint32_t i) { return vertices.name(i); });
    constexpr double of_spacing = 0.25;
    const double least = std::min(of_spacing * point.spacing, mesh_.bounds.least_edge * point.size);
    return point.nearest2 >= least * least;
}

bool WallRefiner::insert(const double* x, FacetCode wall, const WallInsertion::Segment* segment) {
    WallInsertion::Segment near;
    const Refusal refusal =
        segment ? insertion_.find_on_segment(x, *segment) : insertion_.find_in_wall(x, wall, near);
    if (near.wall != no_index) return divide_segment(near);
    NewPoint point;
    if (refusal != Refusal::none || !find_size(x, wall, point)) return false;
    mesh_.reserve(insertion_.slots_needed(), 1);
    const VertexId vertex = mesh_.free_vertices.back();
    mesh_.free_vertices.pop_back();
    mesh_.walled.set_vertex(vertex, x);
    mesh_.set_sizes(vertex, point.size, point.interpolated, point.spacing);
    if (segment) mesh_.walled.divide_edge(segment->a, segment->b, vertex);
    WalledMesh& walled = mesh_.walled;
    insertion_.insert(
        vertex,
        [&] {
            const TetId t = walled.mesh.free_slots.back();
            walled.mesh.free_slots.pop_back();
            return t;
        },
        [&](TetId t) { walled.mesh.free_slots.push_back(t); });
    for (const TetId t : insertion_.star())
        mesh_.verdicts[t] = Verdict(mesh_.excess(walled.mesh.tetrahedra[t].v));
    ++inserted;
    return true;
}

}  // namespace mgdt
