// SPDX-License-Identifier: MIT
//
// The walk goes over the features of the hull, which are its facets, edges and corners. Each step
// leads to a feature with a point nearer to q, until no feature is nearer (Mirtich, V-Clip: fast
// and robust polyhedral collision detection, ACM Transactions on Graphics 17, 1998). Each step is
// decided exactly, and the walk enters a facet only if q is beyond the facet; docs/theory.md,
// "Values between points", shows why this suffices.
#include "interpolation/hull_place.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/foot_weights.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

class HullWalk {
  public:
    HullWalk(const Mesh& mesh, const double* q, TetId ghost) : mesh_(mesh), q_(q), ghost_(ghost) {}

    HullPlace end() {
        while (step()) {
        }
        return place();
    }

  private:
    // A feature of the current ghost: the facet opposite the vertex at infinity, the edge of that
    // facet opposite a corner, or a corner.
    enum class Feature { facet, edge, corner };
    // The positions of the corners in the record, in an order that is positively oriented together
    // with a point inside the hull.
    const unsigned char* places(TetId ghost) const {
        return outer_face[mesh_.tetrahedra[ghost].infinite_slot()];
    }
    const Tetrahedron& present() const { return mesh_.tetrahedra[ghost_]; }
    const double* point(VertexId v) const { return mesh_.point(v); }

    bool is_beyond(TetId ghost) const {
        const VertexId* const v = mesh_.tetrahedra[ghost].v;
        const unsigned char* const at = places(ghost);
        return orientation(q_, point(v[at[0]]), point(v[at[1]]), point(v[at[2]])) <= 0;
    }
    // Whether the edge from v to u begins in a direction that comes closer to q.
    bool is_towards(VertexId v, VertexId u) const {
        return side_of_diametral_sphere(q_, point(u), point(v)) < 0;
    }
    // +1 if the point of the facet's plane that is nearest to q is on the inner side of the edge
    // opposite the corner at `slot`, 0 on the edge, -1 on the outer side.
    int side(TetId ghost, unsigned slot) const {
        const Tetrahedron& t = mesh_.tetrahedra[ghost];
        VertexId end[2], *to = end;
        for (const VertexId u : t.v)
            if (u != infinite_vertex && u != t.v[slot]) *to++ = u;
        return side_of_edge(point(end[0]), point(end[1]), point(t.v[slot]), q_);
    }

    bool step() {
        switch (feature_) {
            case Feature::facet:
                return leave_facet();
            case Feature::edge:
                return leave_edge();
            default:
                return leave_corner();
        }
    }
    bool leave_facet() {
        const unsigned char* const at = places(ghost_);
        unsigned beyond[3], count = 0;
        for (unsigned k = 0; k < 3; ++k) {
            side_[k] = side(ghost_, at[k]);
            if (side_[k] < 0) beyond[count++] = k;
        }
        if (count == 0) return false;
        feature_ = Feature::edge;
        slot_ = at[beyond[0]];
        if (count == 1) return true;
        // If q is beyond two edges, at most one of the edges continues towards q from their common
        // corner.
        const unsigned meet = 3 - beyond[0] - beyond[1];
        const VertexId* const v = present().v;
        if (is_towards(v[at[meet]], v[at[beyond[0]]])) {
            slot_ = at[beyond[1]];
        } else if (!is_towards(v[at[meet]], v[at[beyond[1]]])) {
            feature_ = Feature::corner;
            slot_ = at[meet];
        }
        return true;
    }
    bool leave_edge() {
        const Tetrahedron& t = present();
        for (const unsigned k : {0u, 1u, 2u, 3u})
            if (k != slot_ && t.v[k] != infinite_vertex && !is_towards(t.v[k], other_end(k))) {
                feature_ = Feature::corner;
                slot_ = k;
                return true;
            }
        const FacetCode across = t.n[slot_];
        const struct {
            TetId ghost;
            unsigned slot;
        } sides[2] = {{ghost_, slot_}, {tetrahedron_of(across), face_of(across)}};
        for (const auto& s : sides)
            if (side(s.ghost, s.slot) > 0 && is_beyond(s.ghost)) {
                feature_ = Feature::facet;
                ghost_ = s.ghost;
                return true;
            }
        return false;
    }
    // The other end of the current edge, one end of which is the corner at `slot`.
    VertexId other_end(unsigned slot) const {
        const Tetrahedron& t = present();
        unsigned k = 0;
        while (k == slot || k == slot_ || t.v[k] == infinite_vertex) ++k;
        return t.v[k];
    }
    // Goes around the corner from facet to facet, to an edge that leads towards q and belongs to a
    // facet that q is beyond. Returns false if there is no such edge.
    bool leave_corner() {
        const VertexId v = present().v[slot_];
        VertexId left = infinite_vertex, ahead = infinite_vertex;
        for (const VertexId u : present().v)
            if (u != infinite_vertex && u != v) {
                left = ahead;
                ahead = u;
            }
        for (TetId at = ghost_;;) {
            const Tetrahedron& t = mesh_.tetrahedra[at];
            const auto opposite = static_cast<unsigned>(std::find(t.v, t.v + 4, left) - t.v);
            const TetId next = tetrahedron_of(t.n[opposite]);
            if (is_towards(v, ahead) && (is_beyond(at) || is_beyond(next))) {
                feature_ = Feature::edge;
                ghost_ = at;
                slot_ = opposite;
                return true;
            }
            at = next;
            if (at == ghost_) return false;
            for (const VertexId u : mesh_.tetrahedra[at].v)
                if (u != infinite_vertex && u != v && u != ahead) {
                    left = ahead;
                    ahead = u;
                    break;
                }
        }
    }

    HullPlace place() const;

    const Mesh& mesh_;
    const double* const q_;
    TetId ghost_;
    Feature feature_ = Feature::facet;
    unsigned slot_ = 0;
    int side_[3] = {};  // side() for each edge of the last facet
};

HullPlace HullWalk::place() const {
    const Tetrahedron& t = present();
    HullPlace place = {};
    const auto add = [&](unsigned slot) { place.corner[place.size++] = t.v[slot]; };
    const unsigned char* const at = places(ghost_);
    switch (feature_) {
        case Feature::facet:
            // Corners of weight 0 are left out.
            for (unsigned k = 0; k < 3; ++k)
                if (side_[k] != 0) add(at[k]);
            break;
        case Feature::edge:
            for (unsigned k = 0; k < 3; ++k)
                if (at[k] != slot_) add(at[k]);
            break;
        default:
            add(slot_);
    }
    std::sort(place.corner, place.corner + place.size, [&](VertexId a, VertexId b) {
        return mesh_.vertices[a].index < mesh_.vertices[b].index;
    });
    const double *const a = point(place.corner[0]), *const b = point(place.corner[1]),
                        *const c = point(place.corner[2]);
    place.weight[0] = 1;
    if (place.size == 2) {
        double w[2];
        foot_weights(a, b, q_, w);
        std::copy(w, w + 2, place.weight);
    } else if (place.size == 3) {
        foot_weights(a, b, c, q_, place.weight);
    }
    for (int k = 0; k < 3; ++k)
        place.x[k] = a[k] + (place.weight[1] * (b[k] - a[k]) + place.weight[2] * (c[k] - a[k]));
    return place;
}

}  // namespace

HullPlace nearest_hull_place(const Mesh& mesh, const double* q, TetId ghost) {
    return HullWalk(mesh, q, ghost).end();
}

}  // namespace mgdt
