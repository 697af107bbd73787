// SPDX-License-Identifier: MIT
#include "domain/cavity_filling.hpp"

#include <algorithm>

#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

bool has_same_corners(const std::uint32_t (&v)[3], const std::uint32_t (&w)[3]) {
    return std::is_permutation(v, v + 3, w);
}

// Whether two faces have the same corners, seen from opposite sides.
bool are_opposite(const std::uint32_t (&v)[3], const std::uint32_t (&w)[3]) {
    for (int i = 0; i < 3; ++i)
        if (v[0] == w[i]) return v[1] == w[(i + 2) % 3] && v[2] == w[(i + 1) % 3];
    return false;
}

}  // namespace

CavityFilling::Face CavityFilling::make_face(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                             std::uint32_t behind, std::uint32_t facet,
                                             bool is_above) const {
    BoundingBox box(mesh_.point(a));
    box.include(BoundingBox(mesh_.point(b)));
    box.include(BoundingBox(mesh_.point(c)));
    return {{a, b, c}, behind, facet, is_above, box};
}

Simplex CavityFilling::triangle(const std::uint32_t (&v)[3]) const {
    return {3, {mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2])}, {v[0], v[1], v[2]}};
}

void CavityFilling::replace(FacetWalk& facet, std::uint32_t number,
                            const Buffer<std::uint32_t>& crossed) {
    collect(facet, crossed);
    for (const std::uint32_t t : crossed) mesh_.remove(t);
    two_sided_.clear();
    fill(facet, number, true);
    fill(facet, number, false);
    join_sides();
}

// Joins the new tetrahedra on the two sides of each face that is a part of a facet.
void CavityFilling::join_sides() {
    while (!two_sided_.empty()) {
        const Face face = two_sided_.back();
        two_sided_.pop_back();
        Face* const other = std::find_if(two_sided_.begin(), two_sided_.end(),
                                         [&](const Face& f) { return are_opposite(face.v, f.v); });
        if (other == two_sided_.end())
            fail(MGDT_ERR_INTERNAL, "the sides of a facet do not match; please report it");
        mesh_.join(face.behind, other->behind);
        mesh_.mark(face.behind, face.facet);
        *other = two_sided_.back();
        two_sided_.pop_back();
    }
}

// Collects the corners, and the faces that bound the cavity or are parts of facets inside of it.
void CavityFilling::collect(FacetWalk& facet, const Buffer<std::uint32_t>& crossed) {
    boundary_.clear();
    corners_.clear();
    crossed_.clear();
    for (const std::uint32_t t : crossed) crossed_.push_back(t);
    std::sort(crossed_.begin(), crossed_.end());
    const auto is_crossed = [&](std::uint32_t face) {
        return face != ConstrainedMesh::no_face &&
               std::binary_search(crossed_.begin(), crossed_.end(), face / 4);
    };
    for (const std::uint32_t t : crossed) {
        const ConstrainedMesh::Tetrahedron& tet = mesh_.tetrahedra[t];
        for (unsigned i = 0; i < 4; ++i) {
            corners_.push_back(tet.v[i]);
            const unsigned char* const f = outer_face[i];
            const std::uint32_t a = tet.v[f[0]], b = tet.v[f[1]], c = tet.v[f[2]];
            const int sides[3] = {facet.side(a), facet.side(b), facet.side(c)};
            const bool is_above = sides[0] >= 0 && sides[1] >= 0 && sides[2] >= 0,
                       is_below = sides[0] <= 0 && sides[1] <= 0 && sides[2] <= 0;
            if (!is_above && !is_below) continue;
            const bool is_inside = is_crossed(tet.n[i]);
            if (is_inside && tet.facets[i] == ConstrainedMesh::no_facet) continue;
            // (q, a, b, c) is positive beyond the face, so (a, b, c, q) is positive inside.
            boundary_.push_back(
                make_face(a, b, c, is_inside ? inside : tet.n[i], tet.facets[i], is_above));
        }
    }
    std::sort(corners_.begin(), corners_.end());
    corners_.resize(
        static_cast<std::size_t>(std::unique(corners_.begin(), corners_.end()) - corners_.begin()));
}

// Fills the part of the cavity on one side of the facet.
void CavityFilling::fill(FacetWalk& facet, std::uint32_t number, bool above) {
    candidates_.clear();
    for (const std::uint32_t v : corners_)
        if (above ? facet.side(v) >= 0 : facet.side(v) <= 0) candidates_.push_back(v);
    open_.clear();
    for (const Face& face : boundary_)
        if (face.is_above == above) open_.push_back(face);
    const std::size_t most = candidates_.size() * candidates_.size() + 16;
    for (std::size_t made = 0; !open_.empty(); ++made) {
        if (made > most) fail(MGDT_ERR_INTERNAL, "a cavity is not filled; please report it");
        const Face face = open_.back();
        add_tetrahedron(facet, number, face, choose_apex(face));
    }
}

// The apex is the first point, in the order in which a sphere through the corners of the face that
// grows inwards meets the points, whose tetrahedron is inside of the part that is not filled.
std::uint32_t CavityFilling::choose_apex(const Face& face) {
    const double *const a = mesh_.point(face.v[0]), *const b = mesh_.point(face.v[1]),
                        *const c = mesh_.point(face.v[2]);
    Buffer<std::uint32_t> inner(candidates_.allocator());
    for (const std::uint32_t v : candidates_)
        if (orientation(a, b, c, mesh_.point(v)) > 0) inner.push_back(v);
    while (!inner.empty()) {
        std::size_t best = 0;
        for (std::size_t i = 1; i < inner.size(); ++i)
            if (side_of_sphere_perturbed(a, b, c, mesh_.point(inner[best]), mesh_.point(inner[i])) >
                0)
                best = i;
        if (fits(face, inner[best])) return inner[best];
        inner[best] = inner.back();
        inner.pop_back();
    }
    fail(MGDT_ERR_INTERNAL, "a face of a cavity has no apex; please report it");
}

bool CavityFilling::fits(const Face& face, std::uint32_t apex) const {
    for (unsigned i = 0; i < 3; ++i)
        if (crosses_open_face({face.v[i], face.v[(i + 1) % 3], apex}, face)) return false;
    return true;
}

bool CavityFilling::crosses_open_face(const std::uint32_t (&v)[3], const Face& base) const {
    const Simplex side = triangle(v);
    const Face bounds = make_face(v[0], v[1], v[2], 0, 0, false);
    for (const Face& other : open_) {
        if (!other.box.overlaps(bounds.box) || has_same_corners(other.v, v) ||
            has_same_corners(other.v, base.v))
            continue;
        if (!meet_in_common_face(side, triangle(other.v))) return true;
    }
    return false;
}

// Adds the tetrahedron of the last open face and an apex.
void CavityFilling::add_tetrahedron(FacetWalk& facet, std::uint32_t number, const Face& face,
                                    std::uint32_t apex) {
    const std::uint32_t t = mesh_.add(face.v[0], face.v[1], face.v[2], apex);
    open_.pop_back();
    close(4 * t + 3, face);
    const std::uint32_t v[4] = {face.v[0], face.v[1], face.v[2], apex};
    for (unsigned i = 0; i < 3; ++i) {
        // The new face opposite corner i, seen from the other side.
        const unsigned char* const f = outer_face[i];
        const std::uint32_t a = v[f[0]], b = v[f[2]], c = v[f[1]], code = 4 * t + i;
        const Face made = make_face(a, b, c, code, ConstrainedMesh::no_facet, face.is_above);
        Face* const other = std::find_if(open_.begin(), open_.end(), [&](const Face& open) {
            return are_opposite(open.v, made.v);
        });
        if (other != open_.end()) {
            const Face closed = *other;
            *other = open_.back();
            open_.pop_back();
            close(code, closed);
        } else if (facet.side(a) == 0 && facet.side(b) == 0 && facet.side(c) == 0) {
            two_sided_.push_back(made);
            two_sided_.back().facet = number;
        } else {
            open_.push_back(made);
        }
    }
}

// Joins a face of a new tetrahedron to an open face with the same corners.
void CavityFilling::close(std::uint32_t code, const Face& open) {
    mesh_.of(code).facets[code % 4] = open.facet;
    if (open.behind == inside) {
        two_sided_.push_back(open);
        two_sided_.back().behind = code;
    } else {
        mesh_.join(code, open.behind);
    }
}

}  // namespace mgdt
