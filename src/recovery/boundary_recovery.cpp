// SPDX-License-Identifier: MIT
#include "recovery/boundary_recovery.hpp"

#include <algorithm>

#include "recovery/point_removal.hpp"

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
      chain_(mesh, allocator),
      sheet_(mesh, allocator),
      missing_(allocator),
      left_(allocator),
      tried_(allocator) {
    for (std::size_t i = 0; i < input.segments.size(); i += 2)
        kept_.add(input.segments[i], input.segments[i + 1]);
}

bool BoundaryRecovery::run() {
    missing_.clear();
    for (std::uint32_t i = 0; i < input_.segments.size() / 2; ++i) missing_.push_back(i);
    if (effort_.reverses) std::reverse(missing_.begin(), missing_.end());
    static const int seq[] = {-1, 0, 1, 2, 3, 3, 3};
    for (const int step : seq) {
        left_.clear();
        for (const std::uint32_t i : missing_) {
            stop_.poll();
            const std::uint32_t* const ends = input_.segments.begin() + 2 * std::size_t{i};
            with_points_ = step == 3;
            if (step < 0
                    ? walk_.run(ends[0], ends[1]) != CrossingWalk::Result::is_edge
                    : !recover_segment(ends[0], ends[1], static_cast<unsigned>(std::min(step, 2))))
                left_.push_back(i);
        }
        std::swap(missing_, left_);
        counts.missing_segments[std::min(step + 1, 3)] = missing_.size();
    }
    if (!missing_.empty()) {
        std::copy_n(input_.segments.begin() + 2 * std::size_t{missing_[0]}, 2, lost_edge_);
        return false;
    }
    for (std::uint32_t i = 0; i < input_.triangles.size() / 3; ++i) missing_.push_back(i);
    for (unsigned depth = 0; depth <= Flips::most_depth + 1; ++depth) {
        left_.clear();
        for (const std::uint32_t i : missing_) {
            stop_.poll();
            const std::uint32_t* const of = input_.triangles.begin() + 3 * std::size_t{i};
            const std::uint32_t v[3] = {of[0], of[1], of[2]};
            if (depth == 0 ? over_.run(v) != TriangleWalk::Result::is_face
                           : !recover_triangle(v, depth - 1))
                left_.push_back(i);
        }
        std::swap(missing_, left_);
        counts.missing_triangles[depth] = missing_.size();
    }
    if (!missing_.empty()) {
        std::copy_n(input_.triangles.begin() + 3 * std::size_t{missing_[0]}, 2, lost_edge_);
        return false;
    }
    PointRemoval(mesh_, flips_, missing_.allocator()).run(first_added_, stop_);
    return true;
}

bool BoundaryRecovery::recover_segment(std::uint32_t a, std::uint32_t b, unsigned depth) {
    const Crossings crossings = Crossings::of_segment(mesh_, a, b);
    flips_.set_budget(effort_.rings[depth]);
    mesh_.forget();
    if (flip_segment(a, b, crossings, depth)) return true;
    if (!with_points_) return false;
    constexpr unsigned most_points = 12;
    for (unsigned points = 0; points < most_points; ++points) {
        const CrossingWalk::Result result = walk_.run(a, b);
        if (result == CrossingWalk::Result::is_edge) return true;
        if (result == CrossingWalk::Result::meets) return false;
        if (!insert_point(a, b, crossings, depth)) break;
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
        if (!is_reduced && with_points_)
            for (const Crossing& c : walk_.crossings()) {
                is_reduced = c.is_edge() && flips_.turn_edge(c.v[0], c.v[1], crossings, -1);
                if (is_reduced) break;
            }
        if (!is_reduced) return false;
    }
}

// Puts a point into a tetrahedron that the segment crosses, and flips. Returns false if there is
// no place for which there are fewer crossings then.
bool BoundaryRecovery::insert_point(std::uint32_t a, std::uint32_t b, const Crossings& crossings,
                                    unsigned depth) {
    const std::size_t state = mesh_.state();
    tried_.clear();
    for (const Crossing& c : walk_.crossings()) tried_.push_back(c);
    const std::size_t before = tried_.size();
    for (const double share : {1.0, 0.3, 0.08, 0.02})
        for (const Crossing& c : tried_) {
            flips_.set_budget(effort_.rings_of_point);
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
            if (flip_segment(a, b, crossings, std::min(depth, 1u))) return true;
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
