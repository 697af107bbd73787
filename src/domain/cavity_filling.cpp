// SPDX-License-Identifier: MIT
#include "domain/cavity_filling.hpp"

#include <algorithm>

#include "platform/take_out_repeats.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

CavityFilling::Face CavityFilling::make_face(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                             std::uint32_t behind, std::uint32_t facet) const {
    return {{a, b, c}, behind, facet, box_of(triangle({a, b, c})), true};
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

// Collects the corners of the cavity, the faces that bound it, and the faces inside of it that are
// parts of facets.
void CavityFilling::collect(FacetWalk& facet, const Buffer<std::uint32_t>& crossed) {
    boundary_.clear();
    corners_.clear();
    const auto is_crossed = [&](std::uint32_t face) {
        return face != no_index && std::binary_search(crossed.begin(), crossed.end(), face / 4);
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
            if (is_inside && tet.facets[i] == no_index) continue;
            // (q, a, b, c) is positive for q beyond the face, so (a, b, c, q) is positive for q
            // inside.
            boundary_.push_back(
                {make_face(a, b, c, is_inside ? inside : tet.n[i], tet.facets[i]), is_above});
        }
    }
    take_out_repeats(corners_);
}

// Fills the part of the cavity on one side of the facet.
void CavityFilling::fill(FacetWalk& facet, std::uint32_t number, bool above) {
    candidates_.clear();
    for (const std::uint32_t v : corners_)
        if (above ? facet.side(v) >= 0 : facet.side(v) <= 0) candidates_.push_back(v);
    has_delaunay_ = candidates_.size() > few_candidates;
    if (has_delaunay_) delaunay_.set(mesh_, candidates_);
    open_.clear();
    foreign_.clear();
    for (const BoundaryFace& of : boundary_)
        if (of.is_above == above) open(of.face);
    // n points have fewer than n^2 / 2 tetrahedra.
    const std::size_t n = candidates_.size(), most = n * n;
    std::size_t made = 0;
    for (std::uint32_t i = 0; i < open_.size(); ++i) {
        if (!open_[i].is_open) continue;
        stop_.poll_in_step(made);
        if (++made > most) fail(MGDT_ERR_INTERNAL, "a cavity is not filled; please report it");
        const Face face = open_[i];
        open_.close(i);
        add_tetrahedron(facet, number, face, choose_apex(face));
    }
}

// Adds an open face, and notes whether the Delaunay triangulation of the candidates lacks it.
void CavityFilling::open(const Face& face) {
    const std::uint32_t i = open_.add(face);
    if (has_delaunay_ && delaunay_.apex(face.v[0], face.v[1], face.v[2]) == no_index)
        foreign_.push_back(i);
}

// Chooses the apex for a face. A sphere through the corners of the face that grows inwards meets
// the points in some order; the apex is the first point in this order whose tetrahedron is inside
// of the part that is not filled. If the Delaunay triangulation has a tetrahedron with this face,
// its apex is the first of all points, and only a face that the triangulation lacks can cross this
// tetrahedron.
std::uint32_t CavityFilling::choose_apex(const Face& face) {
    if (has_delaunay_) {
        const std::uint32_t first = delaunay_.apex(face.v[0], face.v[1], face.v[2]);
        if (first != no_index && fits(face, first, true)) return first;
    }
    const double *const a = mesh_.point(face.v[0]), *const b = mesh_.point(face.v[1]),
                        *const c = mesh_.point(face.v[2]);
    inner_.clear();
    for (const std::uint32_t v : candidates_)
        if (orientation(a, b, c, mesh_.point(v)) > 0) inner_.push_back(v);
    while (!inner_.empty()) {
        std::size_t best = 0;
        for (std::size_t i = 1; i < inner_.size(); ++i)
            if (side_of_sphere_perturbed(a, b, c, mesh_.point(inner_[best]),
                                         mesh_.point(inner_[i])) > 0)
                best = i;
        if (fits(face, inner_[best], false)) return inner_[best];
        inner_[best] = inner_.back();
        inner_.pop_back();
    }
    fail(MGDT_ERR_INTERNAL, "a face of a cavity has no apex; please report it");
}

// Whether the tetrahedron of a face and an apex crosses no open face.
bool CavityFilling::fits(const Face& face, std::uint32_t apex, bool is_delaunay) const {
    for (unsigned i = 0; i < 3; ++i) {
        const std::uint32_t v[3] = {face.v[i], face.v[(i + 1) % 3], apex};
        const Face side = make_face(v[0], v[1], v[2], 0, 0);
        if (is_delaunay) {
            for (const std::uint32_t other : foreign_)
                if (crosses(v, side.box, open_[other])) return false;
        } else {
            for (std::uint32_t other = 0; other < open_.size(); ++other)
                if (crosses(v, side.box, open_[other])) return false;
        }
    }
    return true;
}

bool CavityFilling::crosses(const std::uint32_t (&v)[3], const BoundingBox& box,
                            const Face& other) const {
    return other.is_open && other.box.overlaps(box) && !std::is_permutation(v, v + 3, other.v) &&
           !meet_in_common_face(triangle(v), triangle(other.v));
}

// Adds the tetrahedron of a face and an apex.
void CavityFilling::add_tetrahedron(FacetWalk& facet, std::uint32_t number, const Face& face,
                                    std::uint32_t apex) {
    const std::uint32_t t = mesh_.add(face.v[0], face.v[1], face.v[2], apex);
    close(4 * t + 3, face);
    const std::uint32_t v[4] = {face.v[0], face.v[1], face.v[2], apex};
    for (unsigned i = 0; i < 3; ++i) {
        // The face opposite corner i, oriented as seen from the other side.
        const unsigned char* const f = outer_face[i];
        const std::uint32_t a = v[f[0]], b = v[f[2]], c = v[f[1]], code = 4 * t + i;
        const std::uint32_t other = open_.find_opposite(a, b, c);
        if (other != no_index) {
            open_.close(other);
            close(code, open_[other]);
        } else if (facet.side(a) == 0 && facet.side(b) == 0 && facet.side(c) == 0) {
            add_two_sided({a, b, c}, code, number);
        } else {
            open(make_face(a, b, c, code, no_index));
        }
    }
}

// Joins a face of a new tetrahedron to an open face with the same corners.
void CavityFilling::close(std::uint32_t code, const Face& open) {
    mesh_.of(code).facets[code % 4] = open.facet;
    if (open.behind == inside)
        add_two_sided(open.v, code, open.facet);
    else
        mesh_.join(code, open.behind);
}

void CavityFilling::add_two_sided(const std::uint32_t (&v)[3], std::uint32_t code,
                                  std::uint32_t facet) {
    TwoSidedFace face = {{v[0], v[1], v[2]}, code, facet};
    std::sort(face.v, face.v + 3);
    two_sided_.push_back(face);
}

// Joins the new tetrahedra on the two sides of each face that is a part of a facet.
void CavityFilling::join_sides() {
    std::sort(two_sided_.begin(), two_sided_.end());
    for (std::size_t i = 0; i < two_sided_.size(); i += 2) {
        const TwoSidedFace& face = two_sided_[i];
        if (i + 1 == two_sided_.size() || face < two_sided_[i + 1])
            fail(MGDT_ERR_INTERNAL, "the sides of a facet do not match; please report it");
        mesh_.join(face.code, two_sided_[i + 1].code);
        mesh_.mark(face.code, face.facet);
    }
}

}  // namespace mgdt
