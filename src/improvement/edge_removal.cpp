// SPDX-License-Identifier: MIT
#include "improvement/edge_removal.hpp"

#include <algorithm>

#include "improvement/quality.hpp"

namespace mgdt {
namespace {

// third[i][j] is the position k for which (i, j, k, l) is an even permutation of (0, 1, 2, 3),
// where l is the position that is left.
constexpr unsigned char third[4][4] = {{0, 2, 3, 1}, {3, 0, 0, 2}, {1, 3, 0, 0}, {2, 0, 1, 0}};

}  // namespace

// Collects the tetrahedra around the edge. Returns false if the edge has to stay.
bool EdgeRemoval::collect(std::uint32_t t, unsigned i, unsigned j) {
    const auto& tetrahedra = mesh_.tetrahedra;
    a_ = tetrahedra[t].v[i];
    b_ = tetrahedra[t].v[j];
    unsigned near = third[i][j], far = 6 - i - j - near;
    // Where the mesh ends at the edge, the first tetrahedron is the one at its end.
    for (unsigned steps = 0; slides_; ++steps) {
        const std::uint32_t behind = tetrahedra[t].n[far];
        if (behind == no_index) break;
        if (steps == most_around) return false;
        const std::uint32_t corner = tetrahedra[t].v[near];
        if (steps > 0 && corner == vertices_[0]) break;
        if (steps == 0) vertices_[0] = tetrahedra[t].v[far];
        t = behind / 4;
        near = behind % 4;
        far = tetrahedra[t].position(corner);
    }
    const std::uint32_t first = t;
    is_closed_ = false;
    worst_ = above_all;
    for (count_ = 0; count_ < most_around;) {
        const auto& tetrahedron = tetrahedra[t];
        tetrahedra_[count_] = t;
        vertices_[count_] = tetrahedron.v[near];
        sides_[count_] = tetrahedron.facets[far];
        worst_ = std::min(worst_, mesh_.qualities[t]);
        ++count_;
        const std::uint32_t corner = tetrahedron.v[far], behind = tetrahedron.n[near];
        vertices_[count_] = corner;
        sides_[count_] = tetrahedron.facets[near];
        if (!slides_ && sides_[count_] != no_index) return false;
        if (behind == no_index) return slides_;
        t = behind / 4;
        if (t == first) {
            is_closed_ = true;
            return true;
        }
        far = behind % 4;
        near = tetrahedra[t].position(corner);
    }
    return false;
}

// Finds the two faces at the edge that are parts of a facet. Returns their number, or 3 if the
// edge cannot be removed: if there are others, or the two are parts of different facets.
unsigned EdgeRemoval::find_facet(unsigned (&at)[2]) const {
    unsigned found = 0;
    for (unsigned k = 0; k < count_ + (is_closed_ ? 0 : 1); ++k) {
        if (sides_[k] == no_index) continue;
        if (found == 2) return 3;
        at[found++] = k;
    }
    if (found == 0) return is_closed_ ? 0 : 3;
    if (found == 1 ||
        FlexibleMesh::label_of(sides_[at[0]]) != FlexibleMesh::label_of(sides_[at[1]]))
        return 3;
    if (!is_closed_ && (at[0] != 0 || at[1] != count_)) return 3;
    return 2;
}

// Makes vertex `by` the first one.
void EdgeRemoval::turn(unsigned by) {
    std::rotate(tetrahedra_, tetrahedra_ + by, tetrahedra_ + count_);
    std::rotate(vertices_, vertices_ + by, vertices_ + count_);
    std::rotate(sides_, sides_ + by, sides_ + count_);
    vertices_[count_] = vertices_[0];
    sides_[count_] = sides_[0];
}

// Finds the best triangles of the polygon of vertices `begin` to `end`: dynamic programming
// (Klincsek, Annals of Discrete Mathematics 9, 1980). Returns the worst quality of their
// tetrahedra, or 0 if it is not better than the worst one now.
double EdgeRemoval::choose(unsigned begin, unsigned end) {
    for (unsigned i = begin; i < end; ++i) best_[i][i + 1] = above_all;
    for (unsigned size = 2; size <= end - begin; ++size)
        for (unsigned i = begin; i + size <= end; ++i) {
            const unsigned j = i + size;
            double best = 0;
            for (unsigned k = i + 1; k < j; ++k) {
                const double sides = std::min(best_[i][k], best_[k][j]),
                             least = std::max(best, worst_);
                if (!(sides > least)) continue;
                const std::uint32_t p = vertices_[i], q = vertices_[k], r = vertices_[j];
                const double above = mesh_.quality_of(p, q, r, b_);
                if (!(above > least)) continue;
                const double below = mesh_.quality_of(p, r, q, a_);
                if (!(below > least)) continue;
                best = std::min({sides, above, below});
                apex_[i][j] = static_cast<unsigned char>(k);
            }
            best_[i][j] = best;
        }
    return best_[begin][end];
}

void EdgeRemoval::write(unsigned begin, unsigned end, std::uint32_t region, Change& change) const {
    if (end == begin + 1) return;
    const unsigned k = apex_[begin][end];
    const std::uint32_t p = vertices_[begin], q = vertices_[k], r = vertices_[end];
    change.added.push_back({{p, q, r, b_}, region, mesh_.quality_of(p, q, r, b_)});
    change.added.push_back({{p, r, q, a_}, region, mesh_.quality_of(p, r, q, a_)});
    write(begin, k, region, change);
    write(k, end, region, change);
}

// The two faces of the facet at the edge, which has vertices 0 and `middle` on its sides, become
// the two that the line between these vertices divides.
void EdgeRemoval::write_faces(unsigned middle, Change& change) const {
    const std::uint32_t c = vertices_[0], d = vertices_[middle];
    const std::uint32_t label = FlexibleMesh::label_of(sides_[0]);
    // Tetrahedron 0 sees a, b, c counter-clockwise.
    if (sides_[0] % 2 == 0) {
        change.faces.push_back({{c, a_, d}, label});
        change.faces.push_back({{d, b_, c}, label});
    } else {
        change.faces.push_back({{c, d, a_}, label});
        change.faces.push_back({{d, c, b_}, label});
    }
}

bool EdgeRemoval::find(std::uint32_t t, unsigned i, unsigned j, Change& change) {
    change.clear();
    // If another tetrahedron at the edge is worse, the edge is tried for that one.
    if (!collect(t, i, j) || mesh_.qualities[t] > worst_) return false;
    unsigned at[2] = {0, 0};
    const unsigned faces = find_facet(at);
    if (faces == 3 || mesh_.edges.has(a_, b_)) return false;
    // The vertices of each side of the facet are a polygon, or all are one.
    unsigned middle = count_ - 1;
    if (faces == 2) {
        if (is_closed_) turn(at[0]);
        middle = at[1] - at[0];
        if (middle < 2 || (is_closed_ && count_ - middle < 2)) return false;
    } else if (count_ < 3) {
        return false;
    }
    const bool has_two = faces == 2 && is_closed_;
    double after = choose(0, middle);
    if (after > 0 && has_two) after = std::min(after, choose(middle, count_));
    if (!(after > worst_)) return false;
    for (unsigned k = 0; k < count_; ++k) change.removed.push_back(tetrahedra_[k]);
    write(0, middle, mesh_.regions[tetrahedra_[0]], change);
    if (has_two) write(middle, count_, mesh_.regions[tetrahedra_[middle]], change);
    if (faces == 2) write_faces(middle, change);
    change.before = worst_;
    change.after = after;
    return true;
}

}  // namespace mgdt
