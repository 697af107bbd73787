// SPDX-License-Identifier: MIT
#include "recovery/segment_chain.hpp"

#include <algorithm>

namespace mgdt {

bool SegmentChain::recover(std::uint32_t a, std::uint32_t b) {
    const std::size_t state = mesh_.state();
    for (const bool centers : {true, false}) {
        withdrawal_.set_centers(centers);
        if (replace_edges(a, b) && recover_straight(a, b)) return true;
        mesh_.undo(state);
    }
    return false;
}

// Replaces the edges that the segment crosses, so that it crosses faces alone.
bool SegmentChain::replace_edges(std::uint32_t a, std::uint32_t b) {
    constexpr int most_edges = 100;
    for (int i = 0; i < most_edges; ++i) {
        const CrossingWalk::Result result = walk_.run(a, b);
        if (result != CrossingWalk::Result::crosses) return result == CrossingWalk::Result::is_edge;
        const Crossing* const first =
            std::find_if(walk_.crossings().begin(), walk_.crossings().end(),
                         [](const Crossing& c) { return c.is_edge(); });
        if (first == walk_.crossings().end()) return true;
        double on[3];
        find_crossing(mesh_, a, b, *first, on);
        if (!replace_edge(first->v[0], first->v[1], on)) return false;
    }
    return false;
}

// Joins a new point, which is beside a point of an edge, to all that is around the edge.
bool SegmentChain::replace_edge(std::uint32_t p, std::uint32_t q, const double (&on)[3]) {
    if (!ring_.collect(mesh_, p, q)) return false;
    const std::size_t n = ring_.v.size(), state = mesh_.state();
    for (const double share : {0.2931, 0.1127, 0.0213, 0.00317, 1.7e-4, 7.3e-6})
        for (std::size_t i = 0; i < n; ++i) {
            double x[3];
            for (int k = 0; k < 3; ++k)
                x[k] = on[k] + share * (0.8117 * (mesh_.point(ring_.v[i])[k] - on[k]) +
                                        0.1513 * (mesh_.point(ring_.v[(i + 1) % n])[k] - on[k]) +
                                        0.0371 * (mesh_.point(p)[k] - on[k]));
            if (ring_.join(mesh_, mesh_.add_point(x))) return true;
            mesh_.undo(state);
        }
    return false;
}

bool SegmentChain::recover_straight(std::uint32_t a, std::uint32_t b) {
    const CrossingWalk::Result result = walk_.run(a, b);
    if (result != CrossingWalk::Result::crosses) return result == CrossingWalk::Result::is_edge;
    if (!build(a, b, walk_.crossings())) return false;
    for (std::size_t i = 0; i < chain_.size(); ++i)
        if (!withdrawal_.run(a, chain_[i], i + 1 < chain_.size() ? chain_[i + 1] : b)) return false;
    return true;
}

// Inserts the inner vertices of the chain, and joins them.
bool SegmentChain::build(std::uint32_t a, std::uint32_t b, const Buffer<Crossing>& crossings) {
    chain_.clear();
    for (const Crossing& c : crossings)
        if (c.is_edge()) return false;
    // The tetrahedron that the segment enters through crossing i - 1 is that of crossing i.
    for (std::size_t i = 1; i < crossings.size(); ++i) {
        double x[3], one[3], other[3];
        find_crossing(mesh_, a, b, crossings[i - 1], one);
        find_crossing(mesh_, a, b, crossings[i], other);
        for (int k = 0; k < 3; ++k) x[k] = 0.5 * (one[k] + other[k]);
        const std::uint32_t s = mesh_.split(crossings[i].tetrahedron, x);
        if (s == no_index) return false;
        chain_.push_back(s);
    }
    for (std::size_t i = 0; i < crossings.size(); ++i)
        if (!join(i == 0 ? a : chain_[i - 1], i < chain_.size() ? chain_[i] : b, crossings[i].v))
            return false;
    return true;
}

// Replaces a face between two vertices by an edge that joins them.
bool SegmentChain::join(std::uint32_t from, std::uint32_t to, const std::uint32_t (&face)[3]) {
    removed_.clear();
    added_.clear();
    if (!ring_.collect(mesh_, face[0], face[1])) return false;
    for (const std::uint32_t t : ring_.tetrahedra) {
        const FlipMesh::Tetrahedron& tet = mesh_.tetrahedra[t];
        if (tet.has(face[2]) && (tet.has(from) || tet.has(to))) removed_.push_back(t);
    }
    if (removed_.size() != 2) return false;
    for (int k = 0; k < 3; ++k) {
        // The corners of the face are counter-clockwise as seen from `to`.
        const FlipMesh::Corners t = {{from, to, face[k], face[(k + 1) % 3]}};
        if (!mesh_.is_positive(t)) return false;
        added_.push_back(t);
    }
    return mesh_.replace(removed_, added_);
}

}  // namespace mgdt
