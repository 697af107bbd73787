// SPDX-License-Identifier: MIT
#include "cleaning/patch_edges.hpp"

#include <algorithm>

#include "platform/take_out_repeats.hpp"
#include "solid/pair_table.hpp"

namespace mgdt {

PatchEdges::PatchEdges(SurfacePieces& pieces, const Buffer<Projection>& patches,
                       const Nearness& near, Buffer<std::uint8_t>& is_changed, Allocator& allocator)
    : pieces_(pieces),
      patches_(patches),
      near_(near),
      is_changed_(is_changed),
      allocator_(allocator),
      links_(links_in_patches(pieces, allocator)),
      first_at_(allocator),
      next_at_(allocator),
      last_at_(allocator),
      count_at_(allocator),
      first_patch_(allocator),
      patches_at_(allocator),
      crossed_(allocator) {
    const std::size_t corners = pieces.boundary.triangles.size();
    first_at_.resize(pieces.boundary.points.size() / 3, no_index);
    count_at_.resize(first_at_.size(), 0u);
    next_at_.resize(corners, no_index);
    last_at_.resize(corners, no_index);
    for (Corner c = 0; c < corners; ++c) enlist(c);
}

int PatchEdges::turn(std::uint32_t patch, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return patches_[patch].turn(pieces_.point(a), pieces_.point(b), pieces_.point(c));
}

void PatchEdges::enlist(Corner c) {
    Corner& first = first_at_[vertex(c)];
    next_at_[c] = first;
    last_at_[c] = no_index;
    if (first != no_index) last_at_[first] = c;
    first = c;
    ++count_at_[vertex(c)];
}

void PatchEdges::delist(Corner c) {
    if (next_at_[c] != no_index) last_at_[next_at_[c]] = last_at_[c];
    (last_at_[c] != no_index ? next_at_[last_at_[c]] : first_at_[vertex(c)]) = next_at_[c];
    --count_at_[vertex(c)];
}

void PatchEdges::relink(Corner side, Corner other) {
    links_[side] = other;
    if (other != no_index) links_[other] = side;
}

// A side of a triangle of a patch that is the edge ab, or no_index.
PatchEdges::Corner PatchEdges::side_between(std::uint32_t patch, std::uint32_t a,
                                            std::uint32_t b) const {
    if (count_at_[a] > count_at_[b]) std::swap(a, b);
    for (Corner c = first_at_[a]; c != no_index; c = next_at_[c]) {
        if (patch_at(c) != patch) continue;
        if (next(c) == b) return c / 3 * 3 + (c + 2) % 3;
        if (last(c) == b) return c / 3 * 3 + (c + 1) % 3;
    }
    return no_index;
}

// Lists the patches at each vertex. An exchange does not change them.
void PatchEdges::list_patches() {
    first_patch_.resize(first_at_.size() + 1, 0u);
    patches_at_.resize(0);
    Buffer<std::uint32_t> patches(allocator_);
    for (std::uint32_t v = 0; v < first_at_.size(); ++v) {
        patches.clear();
        for (Corner c = first_at_[v]; c != no_index; c = next_at_[c])
            patches.push_back(patch_at(c));
        take_out_repeats(patches);
        for (const std::uint32_t patch : patches) patches_at_.push_back(patch);
        first_patch_[v + 1] = static_cast<std::uint32_t>(patches_at_.size());
    }
}

// The patches that two vertices have in common.
void PatchEdges::list_common_patches(std::uint32_t u, std::uint32_t v,
                                     Buffer<std::uint32_t>& common) const {
    if (first_patch_[u + 1] - first_patch_[u] > first_patch_[v + 1] - first_patch_[v])
        std::swap(u, v);
    common.clear();
    const auto at = [&](std::size_t i) { return patches_at_.begin() + i; };
    for (std::uint32_t i = first_patch_[u]; i < first_patch_[u + 1]; ++i)
        if (std::binary_search(at(first_patch_[v]), at(first_patch_[v + 1]), patches_at_[i]))
            common.push_back(patches_at_[i]);
}

std::size_t PatchEdges::take_in_edges(const StopRequest& stop) {
    // Edges on borders of patches come before those that may be exchanged themselves.
    PairTable edges(allocator_);
    const Buffer<std::uint32_t>& ends = pieces_.boundary.segments;
    for (std::size_t s = 0; s < ends.size(); s += 2) edges.add(ends[s], ends[s + 1]);
    for (const bool is_border : {true, false})
        for (Corner side = 0; side < links_.size(); ++side)
            if ((links_[side] == no_index) == is_border) edges.add(next(side), last(side));
    list_patches();
    Buffer<std::uint32_t> common(allocator_);
    std::size_t taken = 0;
    const std::size_t segments = ends.size() / 2;
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
        stop.poll_in_step(e);
        const auto [u, v] = edges.pair(e);
        list_common_patches(u, v, common);
        // An edge that has been exchanged since is one of no patch any more.
        bool exists = e < segments;
        for (const std::uint32_t patch : common)
            exists = exists || side_between(patch, u, v) != no_index;
        if (!exists) continue;
        for (const std::uint32_t patch : common) {
            if (side_between(patch, u, v) != no_index || !take_in(patch, u, v, stop)) continue;
            ++taken;
            // It stays, in all patches.
            for (const std::uint32_t of : common)
                if (const Corner side = side_between(of, u, v);
                    side != no_index && links_[side] != no_index) {
                    links_[links_[side]] = no_index;
                    links_[side] = no_index;
                }
        }
    }
    return taken;
}

// The side opposite u of the triangle of a patch through which the way from u to v leaves u, or
// no_index.
PatchEdges::Corner PatchEdges::first_crossed(std::uint32_t patch, std::uint32_t u,
                                             std::uint32_t v) const {
    for (Corner c = first_at_[u]; c != no_index; c = next_at_[c]) {
        if (patch_at(c) != patch) continue;
        const int sign = turn(patch, u, next(c), last(c));
        if (sign != 0 && turn(patch, u, next(c), v) == sign && turn(patch, u, v, last(c)) == sign)
            return c;
    }
    return no_index;
}

// Lists the edges that the way from u to v crosses. Returns false if it leaves the patch or comes
// to another vertex.
bool PatchEdges::collect_crossed(std::uint32_t patch, std::uint32_t u, std::uint32_t v) {
    crossed_.clear();
    Corner side = first_crossed(patch, u, v);
    if (side == no_index) return false;
    const int sign = turn(patch, u, v, next(side));
    std::uint32_t x = next(side), y = last(side);  // on the sides `sign` and -`sign` of the way
    for (std::size_t steps = 0; steps < links_.size(); ++steps) {
        if (links_[side] == no_index) return false;
        crossed_.push_back({x, y});
        const Corner apex = links_[side];
        const std::uint32_t z = vertex(apex);
        if (z == v) return true;
        const int of_z = turn(patch, u, v, z);
        if (of_z == 0) return false;
        // The way leaves through the side that is opposite x or y.
        const std::uint32_t left_behind = of_z == sign ? x : y;
        side = next(apex) == left_behind ? apex / 3 * 3 + (apex + 1) % 3
                                         : apex / 3 * 3 + (apex + 2) % 3;
        (of_z == sign ? x : y) = z;
    }
    return false;
}

// Exchanges edges that the way from u to v crosses until it is an edge. A quadrilateral that is not
// convex is tried again after others.
bool PatchEdges::take_in(std::uint32_t patch, std::uint32_t u, std::uint32_t v,
                         const StopRequest& stop) {
    if (!collect_crossed(patch, u, v)) return false;
    std::size_t vain = 0;  // tries in a row that have changed nothing
    for (std::size_t i = 0; i < crossed_.size() && vain <= crossed_.size() - i; ++i) {
        stop.poll_in_step(i);
        const Edge edge = crossed_[i];
        const Corner side = side_between(patch, edge.a, edge.b);
        if (side == no_index || links_[side] == no_index) return false;
        if (!is_convex(side)) {
            crossed_.push_back(edge);
            ++vain;
            continue;
        }
        vain = 0;
        const std::uint32_t c = vertex(side), d = vertex(links_[side]);
        exchange(side);
        const bool touches = c == u || c == v || d == u || d == v;
        if (!touches && turn(patch, u, v, c) * turn(patch, u, v, d) < 0) crossed_.push_back({c, d});
    }
    return side_between(patch, u, v) != no_index;
}

// Whether the quadrilateral at a side is strictly convex, as it is projected.
bool PatchEdges::is_convex(Corner side) const {
    const std::uint32_t patch = patch_at(side), a = next(side), b = last(side), c = vertex(side),
                        d = vertex(links_[side]);
    return turn(patch, c, d, a) * turn(patch, c, d, b) < 0 &&
           turn(patch, a, b, c) * turn(patch, a, b, d) < 0;
}

// Exchanges the edge ab of the triangles abc and bad for cd. Each of the two new triangles keeps
// the facet of one of them.
void PatchEdges::exchange(Corner side) {
    const Corner other = links_[side];
    const std::uint32_t a = next(side), b = last(side), c = vertex(side), d = vertex(other);
    const auto of = [](Corner corner, std::uint32_t k) {
        return corner / 3 * 3 + (corner + k) % 3;
    };
    // The triangle of `other` is (d, b, a), or (d, a, b) if it is turned the other way.
    const bool is_turned = next(other) == a;
    const Corner at_a = links_[of(other, is_turned ? 2 : 1)],  // beyond da
        at_b = links_[of(other, is_turned ? 1 : 2)];           // beyond db
    const Corner ca = links_[of(side, 2)], cb = links_[of(side, 1)];
    std::uint32_t* const v = pieces_.boundary.triangles.begin();
    for (std::uint32_t k = 0; k < 3; ++k) {
        delist(of(side, k));
        delist(of(other, k));
    }
    // (c, a, b) becomes (c, a, d), and the other one (d, b, c): both turn like (c, a, b).
    v[of(side, 0)] = c;
    v[of(side, 1)] = a;
    v[of(side, 2)] = d;
    v[of(other, 0)] = d;
    v[of(other, 1)] = b;
    v[of(other, 2)] = c;
    for (std::uint32_t k = 0; k < 3; ++k) {
        enlist(of(side, k));
        enlist(of(other, k));
    }
    relink(of(side, 0), at_a);
    relink(of(side, 2), ca);
    relink(of(side, 1), of(other, 1));
    relink(of(other, 0), cb);
    relink(of(other, 2), at_b);
    for (const Corner corner : {side, other}) {
        is_changed_[pieces_.facet_of_triangle[corner / 3]] = 1;
        pieces_.is_new[corner / 3] = 1;
    }
}

// Whether the angles opposite an edge have a sum of at most a straight angle, or more only by what
// rounding explains.
bool PatchEdges::is_delaunay(Corner side) const {
    const auto place = [&](std::uint32_t of) { return near_.scaled(pieces_.point(of)); };
    const Vector<double> a = place(next(side)), b = place(last(side));
    double sine[2], cosine[2];
    for (int k = 0; k < 2; ++k) {
        const Vector<double> apex = place(vertex(k == 0 ? side : links_[side]));
        sine[k] = length(cross(a - apex, b - apex));
        cosine[k] = dot(a - apex, b - apex);
    }
    const double first = sine[0] * cosine[1], second = cosine[0] * sine[1];
    return first + second >= -0x1p-30 * (std::fabs(first) + std::fabs(second));
}

std::size_t PatchEdges::make_delaunay(bool all, const StopRequest& stop) {
    Buffer<std::uint8_t> is_touched(allocator_);
    is_touched.resize(patches_.size(), std::uint8_t{all ? std::uint8_t{1} : std::uint8_t{0}});
    for (std::uint32_t t = 0; t < pieces_.triangle_count(); ++t)
        if (pieces_.is_new[t] != 0) is_touched[pieces_.patch_of_triangle[t]] = 1;
    Buffer<Corner> sides(allocator_);
    for (Corner side = 0; side < links_.size(); ++side)
        if (links_[side] != no_index && side < links_[side] && is_touched[patch_at(side)] != 0)
            sides.push_back(side);
    std::size_t exchanged = 0;
    // Rounding could make edges take turns, so there is a limit.
    const std::size_t most = 100 * sides.size();
    for (std::size_t i = 0; i < most && !sides.empty(); ++i) {
        stop.poll_in_step(i);
        const Corner side = sides.back();
        sides.pop_back();
        const Corner other = links_[side];
        if (other == no_index || is_delaunay(side) || !is_convex(side)) continue;
        exchange(side);
        ++exchanged;
        for (std::uint32_t k = 0; k < 3; ++k)
            for (const Corner corner : {side, other}) sides.push_back(corner / 3 * 3 + k);
    }
    return exchanged;
}

}  // namespace mgdt
