// SPDX-License-Identifier: MIT
#include "improvement/face_removal.hpp"

#include <algorithm>

#include "improvement/quality.hpp"

namespace mgdt {

// Adds the best tetrahedra beyond an edge of a removed face, whose ends appear counter-clockwise
// from a. Returns their worst quality, or 0 if it would not exceed the least one.
double FaceRemoval::look_beyond(const Edge& edge) {
    constexpr unsigned most_depth = 4;
    const double direct = mesh_.quality_of(b_, a_, edge.p, edge.q);
    const unsigned removed = removed_count_, added = added_count_;
    double through = 0;
    // The next face has the edge and vertex s, which is a corner on both sides.
    const auto& tetrahedra = mesh_.tetrahedra;
    const auto &above = tetrahedra[edge.above], &below = tetrahedra[edge.below];
    const auto opposite = [&](const FlexibleMesh::Tetrahedron& t, std::uint32_t apex) {
        unsigned i = 0;
        while (t.v[i] == edge.p || t.v[i] == edge.q || t.v[i] == apex) ++i;
        return i;
    };
    const unsigned i = opposite(above, a_), j = opposite(below, b_);
    const std::uint32_t up = above.n[i], down = below.n[j];
    if (edge.depth < most_depth && removed + 2 <= 2 * most_faces && up != no_index &&
        down != no_index && above.facets[i] == no_index && below.facets[j] == no_index) {
        const auto &next_above = tetrahedra[up / 4], &next_below = tetrahedra[down / 4];
        const std::uint32_t s = next_above.v[up % 4];
        const unsigned at_a = next_above.position(a_);
        const bool is_new = std::find(removed_, removed_ + removed, up / 4) == removed_ + removed;
        if (is_new && next_below.v[down % 4] == s && next_above.n[at_a] != no_index &&
            next_above.n[at_a] / 4 == down / 4 && next_above.facets[at_a] == no_index &&
            !mesh_.edges.has(edge.p, edge.q)) {
            removed_[removed_count_++] = up / 4;
            removed_[removed_count_++] = down / 4;
            through = look_beyond({edge.p, s, up / 4, down / 4, edge.depth + 1});
            if (through > std::max(direct, least_))
                through =
                    std::min(through, look_beyond({s, edge.q, up / 4, down / 4, edge.depth + 1}));
        }
    }
    if (through > std::max(direct, least_)) return through;
    removed_count_ = removed;
    added_count_ = added;
    if (!(direct > least_)) return 0;
    added_[added_count_++] = {{b_, a_, edge.p, edge.q}, 0, direct};
    return direct;
}

bool FaceRemoval::find(std::uint32_t t, unsigned i, Change& change) {
    change.clear();
    const auto& tetrahedra = mesh_.tetrahedra;
    const std::uint32_t behind = tetrahedra[t].n[i];
    if (behind == no_index || tetrahedra[t].facets[i] != no_index) return false;
    const std::uint32_t below = behind / 4;
    a_ = tetrahedra[t].v[i];
    b_ = tetrahedra[below].v[behind % 4];
    least_ = mesh_.qualities[t];
    // If the other tetrahedron is worse, the face is tried for that one.
    if (mesh_.qualities[below] < least_) return false;
    removed_[0] = t;
    removed_[1] = below;
    removed_count_ = 2;
    added_count_ = 0;
    double after = above_all;
    const unsigned char* const f = outer_face[i];
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t p = tetrahedra[t].v[f[k]], q = tetrahedra[t].v[f[(k + 1) % 3]];
        after = std::min(after, look_beyond({p, q, t, below, 0}));
        if (!(after > least_)) return false;
    }
    change.before = least_;
    change.after = after;
    for (unsigned k = 0; k < removed_count_; ++k) {
        change.removed.push_back(removed_[k]);
        change.before = std::min(change.before, mesh_.qualities[removed_[k]]);
    }
    for (unsigned k = 0; k < added_count_; ++k) {
        change.added.push_back(added_[k]);
        change.added.back().region = mesh_.regions[t];
    }
    return true;
}

}  // namespace mgdt
