// SPDX-License-Identifier: MIT
#include "domain/facet_walk.hpp"

#include "predicates/predicates.hpp"

namespace mgdt {

int FacetWalk::side(std::uint32_t v) {
    Sign& sign = signs_[v];
    if (sign.walk != walk_)
        sign = {walk_, orientation(plane_[0], plane_[1], plane_[2], mesh_.point(v))};
    return sign.side;
}

bool FacetWalk::crosses(const ConstrainedMesh::Tetrahedron& t, unsigned face) {
    bool has_above = false, has_below = false;
    for (unsigned k = 0; k < 4; ++k) {
        if (k == face) continue;
        has_above = has_above || side(t.v[k]) > 0;
        has_below = has_below || side(t.v[k]) < 0;
    }
    return has_above && has_below;
}

void FacetWalk::run(const std::uint32_t (&corner)[3], std::uint32_t a, std::uint32_t b) {
    for (int k = 0; k < 3; ++k) plane_[k] = mesh_.point(corner[k]);
    ++walk_;
    signs_.resize(mesh_.points.size() / 3, Sign{0, 0});
    // Cavities may have added tetrahedra.
    stamps_.grow(mesh_.tetrahedra.size());
    face_stamps_.grow(4 * mesh_.tetrahedra.size());
    stamps_.resize(mesh_.tetrahedra.size(), 0u);
    face_stamps_.resize(4 * mesh_.tetrahedra.size(), 0u);
    faces_.clear();
    crossed_.clear();
    begin(a, b, corner[2]);
    for (std::size_t f = 0, t = 0; f < faces_.size() || t < crossed_.size();) {
        if (f < faces_.size())
            leave_face(faces_[f++]);
        else
            leave_tetrahedron(crossed_[t++]);
    }
}

// Enters the face or the tetrahedron at the edge ab in the direction of a point.
void FacetWalk::begin(std::uint32_t a, std::uint32_t b, std::uint32_t towards) {
    const std::uint32_t first = mesh_.tetrahedron_at(a, b);
    if (first == no_tetrahedron) fail(MGDT_ERR_INTERNAL, "a subsegment is no edge");
    const double *const pa = mesh_.point(a), *const pb = mesh_.point(b),
                        *const w = mesh_.point(towards);
    // Tries the tetrahedra around the edge, first in one direction, then in the other if the hull
    // is met.
    for (int direction = 0; direction < 2; ++direction) {
        std::uint32_t t = first;
        std::uint32_t behind = no_index;
        do {
            const ConstrainedMesh::Tetrahedron& tet = mesh_.tetrahedra[t];
            // The corners that are not on the edge, so that (a, b, v[p], v[q]) is positive.
            unsigned p = 0, q = 0;
            while (tet.v[p] == a || tet.v[p] == b) ++p;
            for (q = p + 1; tet.v[q] == a || tet.v[q] == b;) ++q;
            if (orientation(pa, pb, mesh_.point(tet.v[p]), mesh_.point(tet.v[q])) < 0)
                std::swap(p, q);
            const int at_p = orientation(pa, pb, mesh_.point(tet.v[p]), w),
                      at_q = orientation(pa, pb, w, mesh_.point(tet.v[q]));
            if (at_p > 0 && at_q > 0) return enter_tetrahedron(t);
            if (at_p == 0 && at_q > 0) return enter_face(4 * t + q);
            if (at_p > 0 && at_q == 0) return enter_face(4 * t + p);
            const unsigned through = direction == 0 ? p : q;
            behind = tet.n[through];
            t = behind / 4;
        } while (behind != no_index && t != first);
    }
    fail(MGDT_ERR_INTERNAL, "a facet leaves the mesh");
}

void FacetWalk::enter_tetrahedron(std::uint32_t t) {
    if (stamps_[t] == walk_) return;
    stamps_[t] = walk_;
    crossed_.push_back(t);
}

void FacetWalk::enter_face(std::uint32_t face) {
    const std::uint32_t other = mesh_.of(face).n[face % 4];
    if (face_stamps_[face] == walk_) return;
    face_stamps_[face] = walk_;
    if (other != no_index) face_stamps_[other] = walk_;
    faces_.push_back(face);
}

// Goes on beyond the faces of a crossed tetrahedron that the plane crosses, and beyond its edge in
// the plane if it has one.
void FacetWalk::leave_tetrahedron(std::uint32_t t) {
    const ConstrainedMesh::Tetrahedron tet = mesh_.tetrahedra[t];
    unsigned in_plane[4], count = 0, above = 0, below = 0;
    for (unsigned i = 0; i < 4; ++i) {
        const int of = side(tet.v[i]);
        if (of == 0) in_plane[count++] = i;
        if (of > 0) above = i;
        if (of < 0) below = i;
    }
    for (unsigned i = 0; i < 4; ++i) {
        if (!crosses(tet, i)) continue;
        if (tet.n[i] == no_index) fail(MGDT_ERR_INTERNAL, "a facet leaves the hull");
        enter_tetrahedron(tet.n[i] / 4);
    }
    if (count != 2) return;
    const std::uint32_t a = tet.v[in_plane[0]], b = tet.v[in_plane[1]];
    if (subsegments_.find(a, b) != no_index) return;
    // The face with the edge and the corner above, and the one with the corner below.
    if (!turn(4 * t + below, a, b) && !turn(4 * t + above, a, b))
        fail(MGDT_ERR_INTERNAL, "a facet ends inside of the hull");
}

// Goes on beyond the edges of a face.
void FacetWalk::leave_face(std::uint32_t face) {
    const ConstrainedMesh::Tetrahedron tet = mesh_.of(face);
    for (unsigned i = 0; i < 4; ++i) {
        if (i == face % 4) continue;
        // The edge of the face that is opposite corner i.
        std::uint32_t ends[2];
        unsigned n = 0;
        for (unsigned k = 0; k < 4; ++k)
            if (k != i && k != face % 4) ends[n++] = tet.v[k];
        if (subsegments_.find(ends[0], ends[1]) != no_index) continue;
        // Turns away from the face on one of its sides.
        if (turn(4 * (face / 4) + i, ends[0], ends[1])) continue;
        const std::uint32_t other = tet.n[face % 4];
        if (other != no_index) {
            const unsigned k = mesh_.of(other).position(tet.v[i]);
            if (turn(4 * (other / 4) + k, ends[0], ends[1])) continue;
        }
        fail(MGDT_ERR_INTERNAL, "a facet ends inside of the hull");
    }
}

// Turns around the edge ab, through tetrahedra on one side of the plane, to the face or tetrahedron
// in which the plane continues. `face` has the edge and a corner outside of the plane; the turn
// leaves the tetrahedron of `face` through it. Returns false if the hull is met before.
bool FacetWalk::turn(std::uint32_t face, std::uint32_t a, std::uint32_t b) {
    const auto third = [&](std::uint32_t of) {
        const ConstrainedMesh::Tetrahedron& t = mesh_.of(of);
        unsigned i = 0;
        while (i == of % 4 || t.v[i] == a || t.v[i] == b) ++i;
        return i;
    };
    const int start = side(mesh_.of(face).v[third(face)]);
    assert(start != 0 && "the turn starts in the plane");
    for (;;) {
        const std::uint32_t next = mesh_.of(face).n[face % 4];
        if (next == no_index) return false;
        const int here = side(mesh_.apex(next));
        // The face that has the edge and the new corner is opposite the corner of the last face.
        const std::uint32_t beyond = next / 4 * 4 + third(next);
        if (here == 0) {
            enter_face(beyond);
            return true;
        }
        if (here != start) {
            enter_tetrahedron(next / 4);
            return true;
        }
        face = beyond;
    }
}

}  // namespace mgdt
