// SPDX-License-Identifier: MIT
#include "recovery/segment_chain.hpp"

#include <algorithm>

#include "predicates/predicates.hpp"

namespace mgdt {

bool SegmentChain::is_positive(const FlipMesh::Corners& t) const noexcept {
    return orientation(mesh_.point(t.v[0]), mesh_.point(t.v[1]), mesh_.point(t.v[2]),
                       mesh_.point(t.v[3])) > 0;
}

bool SegmentChain::recover(std::uint32_t a, std::uint32_t b) {
    const std::size_t state = mesh_.state();
    if (recover_straight(a, b)) return true;
    mesh_.undo(state);
    for (const double share : {1e-2, 1e-4, 1e-6, 1e-8})
        for (unsigned direction = 0; direction < 6; ++direction) {
            if (recover_bent(a, b, share, direction)) return true;
            mesh_.undo(state);
        }
    return false;
}

// Makes two edges that meet near the segment, at a point that is beside the plane of an edge that
// the segment crosses, and takes the point out.
bool SegmentChain::recover_bent(std::uint32_t a, std::uint32_t b, double share,
                                unsigned direction) {
    if (walk_.run(a, b) != CrossingWalk::Result::crosses) return false;
    const Crossing first = walk_.crossings()[0];
    double on[3], x[3];
    find_crossing(mesh_, a, b, first, on);
    double length = 0;
    for (int k = 0; k < 3; ++k) length += std::fabs(mesh_.point(b)[k] - mesh_.point(a)[k]);
    // A direction along no axis.
    constexpr double directions[3][3] = {
        {0.7431, 0.1127, -0.3319}, {-0.2211, 0.8123, 0.1873}, {0.1319, -0.2741, 0.7919}};
    for (int k = 0; k < 3; ++k)
        x[k] = on[k] + (direction < 3 ? share : -share) * length * directions[direction % 3][k];
    const std::uint32_t m = insert_near(first, x);
    if (m == no_index) return false;
    for (const std::uint32_t end : {a, b})
        if (walk_.run(end, m) != CrossingWalk::Result::is_edge && !recover_straight(end, m))
            return false;
    return withdrawal_.run(a, m, b);
}

// Adds a point in a tetrahedron at a face or an edge. Returns no_index if it is in none.
std::uint32_t SegmentChain::insert_near(const Crossing& c, const double (&x)[3]) {
    for (int side = 0; side < (c.is_edge() ? 1 : 3); ++side) {
        if (!ring_.collect(mesh_, c.v[side], c.v[(side + 1) % (c.is_edge() ? 2 : 3)])) continue;
        for (const std::uint32_t t : ring_.tetrahedra) {
            const std::uint32_t made = mesh_.split(t, x);
            if (made != no_index) return made;
        }
    }
    return no_index;
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
        if (!is_positive(t)) return false;
        added_.push_back(t);
    }
    return mesh_.replace(removed_, added_);
}

}  // namespace mgdt
