// SPDX-License-Identifier: MIT
#include "recovery/boundary_recovery.hpp"

#include <algorithm>

#include "recovery/point_removal.hpp"
#include "recovery/triangle_table.hpp"

namespace mgdt {

BoundaryRecovery::BoundaryRecovery(FlipMesh& mesh, const RecoveryInput& input,
                                   const RecoveryEffort& effort, const StopRequest& stop,
                                   Allocator& allocator)
    : mesh_(mesh),
      input_(input),
      effort_(effort),
      stop_(stop),
      first_added_(static_cast<std::uint32_t>(mesh.point_count())),
      kept_(allocator),
      flips_(mesh, kept_, allocator),
      walk_(mesh, allocator),
      over_(mesh, allocator),
      patch_(mesh, kept_, input.triangles, first_added_, stop, allocator),
      chain_(mesh, allocator),
      sheet_(mesh, allocator),
      missing_(allocator),
      tried_(allocator) {
    for (std::size_t i = 0; i < input.segments.size(); i += 2)
        kept_.add(input.segments[i], input.segments[i + 1]);
}

bool BoundaryRecovery::run() {
    return recover_segments() && recover_triangles() &&
           (PointRemoval(mesh_, flips_, missing_.allocator()).run(first_added_, stop_), true);
}

// Lists the segments of the boundary that are not edges of the mesh.
void BoundaryRecovery::find_missing_segments() {
    Buffer<std::uint8_t> is_edge(missing_.allocator());
    is_edge.resize(input_.segments.size() / 2, std::uint8_t{0});
    for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
        stop_.poll_in_step(t);
        const FlipMesh::Tetrahedron& tet = mesh_.tetrahedra[t];
        if (tet.is_dead()) continue;
        for (unsigned k = 0; k < 4; ++k)
            for (unsigned l = k + 1; l < 4; ++l)
                if (const std::uint32_t s = kept_.find(tet.v[k], tet.v[l]); s != no_index)
                    is_edge[s] = 1;
    }
    missing_.clear();
    for (std::uint32_t i = 0; i < is_edge.size(); ++i)
        if (is_edge[i] == 0) missing_.push_back(i);
}

// Lists the triangles of the boundary that are not faces of the mesh.
void BoundaryRecovery::find_missing_triangles() {
    const TriangleTable table(input_.triangles, first_added_, missing_.allocator());
    Buffer<std::uint8_t> is_face(missing_.allocator());
    is_face.resize(input_.triangles.size() / 3, std::uint8_t{0});
    for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
        stop_.poll_in_step(t);
        const FlipMesh::Tetrahedron& tet = mesh_.tetrahedra[t];
        if (tet.is_dead()) continue;
        for (unsigned k = 0; k < 4; ++k) {
            const std::uint32_t f =
                table.find(tet.v[(k + 1) % 4], tet.v[(k + 2) % 4], tet.v[(k + 3) % 4]);
            if (f != no_index) is_face[f] = 1;
        }
    }
    missing_.clear();
    for (std::uint32_t i = 0; i < is_face.size(); ++i)
        if (is_face[i] == 0) missing_.push_back(i);
}

bool BoundaryRecovery::recover_segments() {
    find_missing_segments();
    if (effort_.reverses) std::reverse(missing_.begin(), missing_.end());
    constexpr std::size_t least_segments = 200;
    rings_left_ = effort_.most_rings * (least_segments + missing_.size());
    constexpr struct Stage {
        unsigned depth;
        bool adds_points;
    } stages[] = {{0, false}, {1, false}, {2, false}, {2, true}, {2, true}, {2, true}};
    for (const Stage& stage : stages) {
        adds_points_ = stage.adds_points;
        patch_.forget_failures();
        keep_missing([&](std::uint32_t i) {
            const std::uint32_t* const ends = input_.segments.begin() + 2 * std::size_t{i};
            return recover_segment(ends[0], ends[1], stage.depth);
        });
    }
    if (missing_.empty()) return true;
    std::copy_n(input_.segments.begin() + 2 * std::size_t{missing_[0]}, 2, lost_edge_);
    return false;
}

bool BoundaryRecovery::recover_triangles() {
    find_missing_triangles();
    for (unsigned depth = 0; depth <= Flips::most_depth; ++depth)
        keep_missing([&](std::uint32_t i) {
            const std::uint32_t* const of = input_.triangles.begin() + 3 * std::size_t{i};
            return recover_triangle({of[0], of[1], of[2]}, depth);
        });
    if (missing_.empty()) return true;
    std::copy_n(input_.triangles.begin() + 3 * std::size_t{missing_[0]}, 2, lost_edge_);
    return false;
}

// Keeps those of the missing items that are not recovered.
template <class Recover>
void BoundaryRecovery::keep_missing(const Recover& recover) {
    std::size_t kept = 0;
    for (const std::uint32_t i : missing_) {
        stop_.poll();
        if (!recover(i)) missing_[kept++] = i;
    }
    missing_.resize(kept);
}

// Gives the flips a budget, as long as rings are left.
void BoundaryRecovery::set_budget(std::size_t rings) {
    budget_ = std::min(rings, rings_left_);
    flips_.set_budget(budget_);
}

// Counts the rings that the flips have looked at.
void BoundaryRecovery::spend_budget() {
    rings_left_ -= budget_ - flips_.budget();
    budget_ = flips_.budget();
}

bool BoundaryRecovery::recover_segment(std::uint32_t a, std::uint32_t b, unsigned depth) {
    const Crossings crossings = Crossings::of_segment(mesh_, a, b);
    mesh_.forget();
    // Flips without depth are always tried.
    if (depth == 0)
        flips_.set_budget(effort_.rings[0]);
    else
        set_budget(effort_.rings[depth]);
    if (adds_points_ && walk_.run(a, b) == CrossingWalk::Result::crosses && patch_.recover(a, b))
        return true;
    const bool is_done = flip_segment(a, b, crossings, depth);
    if (depth > 0) spend_budget();
    if (is_done || !adds_points_) return is_done;
    constexpr unsigned most_points = 12;
    for (unsigned points = 0; points < most_points; ++points) {
        const CrossingWalk::Result result = walk_.run(a, b);
        if (result == CrossingWalk::Result::is_edge) return true;
        if (result == CrossingWalk::Result::meets) return false;
        if (!insert_point(a, b, crossings)) break;
    }
    return chain_.recover(a, b);
}

// Flips until the segment is an edge, or until no flip makes its crossings fewer. Leaves the last
// walk.
bool BoundaryRecovery::flip_segment(std::uint32_t a, std::uint32_t b, const Crossings& crossings,
                                    unsigned depth) {
    for (;;) {
        const CrossingWalk::Result result = walk_.run(a, b);
        if (result == CrossingWalk::Result::is_edge) return true;
        if (result == CrossingWalk::Result::meets) return false;
        bool is_reduced = false;
        for (unsigned d = 0; d <= depth && !is_reduced; ++d)
            is_reduced = reduce_segment(crossings, d);
        if (!is_reduced && adds_points_)
            for (const Crossing& c : walk_.crossings()) {
                is_reduced = c.is_edge() && flips_.turn_edge(c.v[0], c.v[1], crossings, -1);
                if (is_reduced) break;
            }
        if (!is_reduced) return false;
    }
}

// Puts a point into a tetrahedron that the segment crosses, and flips. Returns false if there is
// no place for which there are fewer crossings then.
bool BoundaryRecovery::insert_point(std::uint32_t a, std::uint32_t b, const Crossings& crossings) {
    const std::size_t state = mesh_.state();
    tried_.clear();
    // Some crossings from everywhere, if there are many.
    constexpr std::size_t most_tries = 12;
    const std::size_t before = walk_.crossings().size(), step = 1 + (before - 1) / most_tries;
    for (std::size_t i = 0; i < before; i += step) tried_.push_back(walk_.crossings()[i]);
    for (const double share : {1.0, 0.3, 0.08, 0.02})
        for (const Crossing& c : tried_) {
            if (rings_left_ == 0) return false;
            set_budget(effort_.rings_of_point);
            const FlipMesh::Tetrahedron t = mesh_.tetrahedra[c.tetrahedron];
            double x[3], on[3];
            find_crossing(mesh_, a, b, c, on);
            // The weights are no simple fractions, so that points avoid planes of a lattice.
            constexpr double weights[4] = {0.2312, 0.2687, 0.2454, 0.2547};
            for (int k = 0; k < 3; ++k) {
                double sum = 0;
                for (unsigned i = 0; i < 4; ++i) sum += weights[i] * mesh_.point(t.v[i])[k];
                x[k] = on[k] + share * (sum - on[k]);
            }
            if (mesh_.split(c.tetrahedron, x) == no_index) continue;
            const bool is_done = flip_segment(a, b, crossings, 1);
            spend_budget();
            if (is_done) return true;
            if (!walk_.crossings().empty() && walk_.crossings().size() < before) return true;
            mesh_.undo(state);
        }
    return false;
}

// Makes the crossings of a segment fewer. Returns false if no flip does.
bool BoundaryRecovery::reduce_segment(const Crossings& crossings, unsigned depth) {
    int change = 0;
    for (const Crossing& c : walk_.crossings())
        if (c.is_edge() && flips_.remove_edge(c.v[0], c.v[1], crossings, -1, depth, change))
            return true;
    for (const Crossing& c : walk_.crossings()) {
        if (c.is_edge()) continue;
        if (depth == 0) {
            const FlipMesh::Tetrahedron& t = mesh_.tetrahedra[c.tetrahedron];
            unsigned at = 0;
            while (std::find(c.v, c.v + 3, t.v[at]) != c.v + 3) ++at;
            if (flips_.remove_face(4 * c.tetrahedron + at, crossings, -1, change)) return true;
        }
        for (int k = 0; k < 3; ++k)
            if (flips_.remove_edge(c.v[k], c.v[(k + 1) % 3], crossings, -1, depth, change))
                return true;
    }
    return false;
}

bool BoundaryRecovery::recover_triangle(const std::uint32_t (&v)[3], unsigned depth) {
    const Crossings crossings = Crossings::of_triangle(mesh_, v);
    flips_.set_budget(effort_.rings[depth]);
    for (;;) {
        mesh_.forget();
        const TriangleWalk::Result result = over_.run(v);
        if (result == TriangleWalk::Result::is_face) return true;
        if (result == TriangleWalk::Result::meets) return false;
        bool is_reduced = false;
        int change = 0;
        for (unsigned d = 0; d <= depth && !is_reduced; ++d)
            for (const TriangleWalk::Edge& e : over_.edges()) {
                is_reduced = flips_.remove_edge(e.p, e.q, crossings, -1, d, change);
                if (is_reduced) break;
            }
        if (!is_reduced)
            return depth == Flips::most_depth && over_.run(v) == TriangleWalk::Result::crosses &&
                   sheet_.recover(v, over_);
    }
}

}  // namespace mgdt
