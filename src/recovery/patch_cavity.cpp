// SPDX-License-Identifier: MIT
#include "recovery/patch_cavity.hpp"

#include <algorithm>

#include "platform/take_out_repeats.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

void PatchCavity::clear() noexcept {
    for (const std::uint32_t t : tetrahedra_) {
        is_inside_[t] = 0;
        std::fill_n(side_of_.begin() + 4 * std::size_t{t}, 4, neither);
    }
    tetrahedra_.clear();
}

void PatchCavity::take_in(std::uint32_t t) {
    is_inside_.grow(mesh_.tetrahedra.size());
    is_inside_.resize(mesh_.tetrahedra.size(), 0);
    side_of_.grow(4 * mesh_.tetrahedra.size());
    side_of_.resize(4 * mesh_.tetrahedra.size(), neither);
    if (is_inside_[t] != 0) return;
    tetrahedra_.push_back(t);
    is_inside_[t] = 1;
}

void PatchCavity::take_in_ring(std::uint32_t a, std::uint32_t b) {
    if (!ring_.collect(mesh_, a, b)) return;
    for (const std::uint32_t t : ring_.tetrahedra) take_in(t);
}

// Takes in the tetrahedra at the edges of the border into which the triangles run.
bool PatchCavity::take_in_border(const BoundaryPatch& patch) {
    const Buffer<std::uint32_t>& corners = patch.corners();
    entries_.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t first = i - i % 3;
        const std::uint32_t from = corners[i], to = corners[first + (i + 1) % 3],
                            third = corners[first + (i + 2) % 3];
        if (patch.border_number(from, to) == no_index) continue;
        if (!ring_.collect(mesh_, from, to)) return false;
        const auto turns = [&](std::uint32_t a, std::uint32_t b) {
            return a == b || orientation(mesh_.point(from), mesh_.point(to), mesh_.point(a),
                                         mesh_.point(b)) >= 0;
        };
        const std::size_t n = ring_.v.size();
        for (std::size_t k = 0; k < n; ++k)
            if (turns(ring_.v[k], third) && turns(third, ring_.v[(k + 1) % n])) {
                take_in(ring_.tetrahedra[k]);
                entries_.push_back(entry(patch.border_number(from, to), ring_.tetrahedra[k]));
            }
    }
    take_out_repeats(entries_);
    return true;
}

bool PatchCavity::divide(const BoundaryPatch& patch) {
    if (!take_in_border(patch)) return false;
    edges_.clear();
    for (std::size_t i = 0; i < tetrahedra_.size(); ++i) {
        const FlipMesh::Tetrahedron t = mesh_.tetrahedra[tetrahedra_[i]];
        for (unsigned k = 0; k < 4; ++k)
            for (unsigned l = 0; l < k; ++l) {
                const std::uint32_t a = t.v[k], b = t.v[l];
                const std::size_t before = edges_.size();
                if (is_kept(a, b) || edges_.add(a, b) != before) continue;
                if (patch.is_met_by(a, b)) take_in_ring(a, b);
            }
    }
    double areas[3] = {0, 0, 0};
    std::uint8_t sides = 0;
    for (const std::uint32_t t : tetrahedra_)
        for (std::uint32_t face = 4 * t; face < 4 * t + 4; ++face) {
            if (is_inside(mesh_.of(face).n[face % 4])) continue;
            if (side_of_[face] == neither) {
                if (sides == 2) return false;
                spread(face, static_cast<Side>(++sides), patch);
            }
            areas[side_of_[face]] += area(face, patch);
        }
    if (sides != 2 || (areas[above] > 0) == (areas[below] > 0)) return false;
    if (!(areas[above] > 0))
        for (const std::uint32_t t : tetrahedra_)
            for (std::uint32_t face = 4 * t; face < 4 * t + 4; ++face)
                if (side_of_[face] != neither)
                    side_of_[face] = side_of_[face] == above ? below : above;
    return true;
}

// Sets the side of all faces of the cavity that are connected with one of them without crossing the
// border of the patch.
void PatchCavity::spread(std::uint32_t face, Side side, const BoundaryPatch& patch) {
    faces_.clear();
    faces_.push_back(face);
    side_of_[face] = side;
    while (!faces_.empty()) {
        const std::uint32_t from = faces_.back();
        faces_.resize(faces_.size() - 1);
        const FlipMesh::Tetrahedron& t = mesh_.of(from);
        for (unsigned k = 1; k < 4; ++k) {
            const unsigned opposite = (from + k) % 4, one = (from + k % 3 + 1) % 4,
                           other = (from + (k + 1) % 3 + 1) % 4;
            const std::uint32_t next =
                next_face(from, opposite, patch.border_number(t.v[one], t.v[other]));
            if (next == no_index || side_of_[next] == side) continue;
            side_of_[next] = side;
            faces_.push_back(next);
        }
    }
}

// The face of the cavity beyond the edge of a face that is opposite to one of its corners, or
// no_index if the patch is between them. `border` is the number of the edge in the patch's border.
std::uint32_t PatchCavity::next_face(std::uint32_t face, unsigned opposite,
                                     std::uint32_t border) const noexcept {
    std::uint32_t t = face / 4;
    // The way around the edge enters a tetrahedron through the face opposite to corner `front`, and
    // leaves it through the face opposite to corner `back`.
    unsigned back = opposite, front = face % 4;
    for (;;) {
        if (border != no_index &&
            std::binary_search(entries_.begin(), entries_.end(), entry(border, t)))
            return no_index;
        const FlipMesh::Tetrahedron& tet = mesh_.tetrahedra[t];
        const std::uint32_t code = tet.n[back];
        if (!is_inside(code)) return 4 * t + back;
        const std::uint32_t kept = tet.v[front];
        t = code / 4;
        front = code % 4;
        back = mesh_.tetrahedra[t].position(kept);
    }
}

// Twice the area of a face of the cavity as seen from above, which is positive if the cavity is
// below the face.
double PatchCavity::area(std::uint32_t face, const BoundaryPatch& patch) const noexcept {
    const std::uint32_t* const v = mesh_.of(face).v;
    // The order of outer_face is counter-clockwise as seen from the inside.
    const unsigned char* const f = outer_face[face % 4];
    return patch.area(mesh_.point(v[f[0]]), mesh_.point(v[f[2]]), mesh_.point(v[f[1]]));
}

void PatchCavity::set_side(std::uint32_t face, Side side) {
    changes_.push_back({face, side_of_[face]});
    side_of_[face] = side;
}

bool PatchCavity::grow(Side side, std::uint32_t point, const BoundaryPatch& patch) {
    const std::size_t before = tetrahedra_.size(), most = 200 + 8 * before;
    changes_.clear();
    faces_.clear();
    for (const std::uint32_t t : tetrahedra_)
        for (std::uint32_t face = 4 * t; face < 4 * t + 4; ++face)
            if (side_of_[face] == side) faces_.push_back(face);
    bool is_done = true;
    for (std::size_t i = 0; i < faces_.size() && is_done; ++i) {
        const std::uint32_t face = faces_[i];
        if (side_of_[face] != side) continue;
        FlipMesh::Corners seen;
        std::copy_n(mesh_.of(face).v, 4, seen.v);
        seen.v[face % 4] = point;
        if (!mesh_.is_positive(seen))
            is_done = tetrahedra_.size() < most && take_in_behind(face, side);
    }
    if (is_done && loses_nothing(patch)) return true;
    for (std::size_t i = changes_.size(); i-- > 0;) side_of_[changes_[i].face] = changes_[i].before;
    for (std::size_t i = before; i < tetrahedra_.size(); ++i) is_inside_[tetrahedra_[i]] = 0;
    tetrahedra_.resize(before);
    return false;
}

// Takes in the tetrahedron behind a face. Its other faces are on the same side. Returns false if
// one of them is a face of the other side, or if there is no tetrahedron.
bool PatchCavity::take_in_behind(std::uint32_t face, Side side) {
    const std::uint32_t code = mesh_.of(face).n[face % 4];
    if (code == no_index) return false;
    const std::uint32_t t = code / 4;
    for (std::uint32_t next = 4 * t; next < 4 * t + 4; ++next) {
        const std::uint32_t behind = mesh_.of(next).n[next % 4];
        if (is_inside(behind) && side_of_[behind] != side) return false;
    }
    take_in(t);
    for (std::uint32_t next = 4 * t; next < 4 * t + 4; ++next) {
        const std::uint32_t behind = mesh_.of(next).n[next % 4];
        if (is_inside(behind)) {
            set_side(behind, neither);
        } else {
            set_side(next, side);
            faces_.push_back(next);
        }
    }
    return true;
}

bool PatchCavity::loses_nothing(const BoundaryPatch& patch) {
    edges_.clear();
    lost_.clear();
    for (const std::uint32_t i : tetrahedra_) {
        const FlipMesh::Tetrahedron& t = mesh_.tetrahedra[i];
        for (unsigned k = 0; k < 4; ++k) {
            const std::uint32_t v[3] = {t.v[(k + 1) % 4], t.v[(k + 2) % 4], t.v[(k + 3) % 4]};
            const bool is_outer = side_of_[4 * i + k] != neither;
            const bool is_lost = !is_outer && patch.is_outer_triangle(v[0], v[1], v[2]);
            for (int j = 0; j < 3; ++j) {
                // A vertex is listed as an edge from itself to itself.
                if (is_outer) edges_.add(v[j], v[j]);
                if (is_outer) edges_.add(v[j], v[(j + 1) % 3]);
                if (is_lost) lost_.add(v[j], v[(j + 1) % 3]);
            }
        }
    }
    vanishing_.clear();
    bool has_all = true;
    for (const std::uint32_t i : tetrahedra_) {
        const std::uint32_t* const v = mesh_.tetrahedra[i].v;
        for (unsigned k = 0; k < 4; ++k) {
            if (edges_.find(v[k], v[k]) == no_index && !patch.has_vertex(v[k])) {
                has_all = has_all && v[k] >= first_added_;
                vanishing_.push_back(v[k]);
            }
            for (unsigned l = 0; l < k; ++l)
                if (is_kept(v[k], v[l]) && edges_.find(v[k], v[l]) == no_index &&
                    patch.inner_edges().find(v[k], v[l]) == no_index)
                    lost_.add(v[k], v[l]);
        }
    }
    return has_all && lost_.size() == 0;
}

void PatchCavity::collect_vertices(Side side, Buffer<std::uint32_t>& vertices) const {
    vertices.clear();
    for (const std::uint32_t t : tetrahedra_)
        for (std::uint32_t face = 4 * t; face < 4 * t + 4; ++face)
            for (unsigned k = 1; k < 4 && side_of_[face] == side; ++k)
                vertices.push_back(mesh_.tetrahedra[t].v[(face + k) % 4]);
    take_out_repeats(vertices);
}

}  // namespace mgdt
