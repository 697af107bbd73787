// SPDX-License-Identifier: MIT
#include "refinement/wall_insertion.hpp"

#include <algorithm>

#include "kernel/circumsphere.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// The states of a member.
constexpr std::uint8_t at_divided_wall = 1, has_left = 2, has_been_met = 4;

// Whether a point in the plane of a triangle is inside of its circumcircle, roughly.
bool is_in_circle(const double* q, const double* a, const double* b, const double* c) noexcept {
    const Vector<double> u = difference<double>(b, a), v = difference<double>(c, a),
                         n = cross(u, v), d = difference<double>(q, a);
    // The centre is a + o / (2 n.n).
    const Vector<double> o = dot(u, u) * cross(v, n) + dot(v, v) * cross(n, u);
    return dot(n, n) * dot(d, d) < dot(o, d);
}

// Whether q sees ab under more than 120 degrees.
bool is_near_edge(const double* q, const double* a, const double* b) noexcept {
    const Vector<double> u = difference<double>(a, q), v = difference<double>(b, q);
    const double product = dot(u, v);
    return product < 0 && 4 * product * product > dot(u, u) * dot(v, v);
}

}  // namespace

void WallInsertion::clear() {
    divided_.clear();
    rims_.clear();
    members_.clear();
    states_.clear();
    boundary_.clear();
}

void WallInsertion::add_member(TetId t) {
    if (members_.number(t) == states_.size()) states_.push_back(0);
}

bool WallInsertion::is_divided(FacetCode wall) const noexcept {
    return std::find(divided_.begin(), divided_.end(), wall) != divided_.end() ||
           std::find(divided_.begin(), divided_.end(), edges_.behind(wall)) != divided_.end();
}

bool WallInsertion::divide_facet(const double* q, FacetCode wall, const Segment& divided,
                                 Segment* near) {
    const WalledMesh& walled = mesh_.walled;
    const std::size_t first = divided_.size(), first_rim = rims_.size();
    divided_.push_back(wall);
    for (std::size_t i = first; i < divided_.size(); ++i) {
        const FacetCode code = divided_[i];
        VertexId v[3];
        edges_.corners(code, v);
        for (int k = 0; k < 3; ++k) {
            const VertexId x = v[k], y = v[(k + 1) % 3];
            if ((x == divided.a && y == divided.b) || (x == divided.b && y == divided.a)) continue;
            const FacetCode other = edges_.across(code, x, y);
            if (other == no_index) {
                if (near && is_near_edge(q, walled.point(x), walled.point(y))) {
                    *near = {x, y, code};
                    return false;
                }
            } else if (std::find(divided_.begin() + first, divided_.end(), other) !=
                       divided_.end()) {
                continue;
            } else {
                VertexId w[3];
                edges_.corners(other, w);
                if (is_in_circle(q, walled.point(w[0]), walled.point(w[1]), walled.point(w[2]))) {
                    divided_.push_back(other);
                    continue;
                }
            }
            const bool is_hull = edges_.is_hull(code);
            rims_.push_back({x, y, code, edges_.side(code),
                             is_hull ? edges_.side(code) : edges_.side(edges_.behind(code))});
        }
    }
    // An edge between two divided walls may have been listed before the second one was found.
    const auto is_inside = [&](const Rim& rim) {
        const FacetCode other = edges_.across(rim.wall, rim.x, rim.y);
        return other != no_index &&
               std::find(divided_.begin() + first, divided_.end(), other) != divided_.end();
    };
    rims_.resize(static_cast<std::size_t>(
        std::remove_if(rims_.begin() + first_rim, rims_.end(), is_inside) - rims_.begin()));
    return true;
}

Refusal WallInsertion::find_in_wall(const double* q, FacetCode wall, Segment& near) {
    clear();
    if (!divide_facet(q, wall, Segment(), &near)) return Refusal::near_vertex;
    if (rims_.size() != divided_.size() + 2) return Refusal::shapeless;
    return dig(q);
}

// Divides the walls of a facet at a segment, unless they are divided already. Returns false if they
// are no polygon with the segment as an edge and without vertices inside.
bool WallInsertion::divide_at_segment(const double* q, FacetCode wall, const Segment& segment) {
    if (is_divided(wall)) return true;
    const std::size_t walls = divided_.size(), rims = rims_.size();
    divide_facet(q, wall, segment, nullptr);
    return rims_.size() - rims + 1 == divided_.size() - walls + 2;
}

Refusal WallInsertion::find_on_segment(const double* q, const Segment& segment) {
    clear();
    // This loop goes around the segment from wall to wall. If it comes to the hull, it goes the
    // other way from the given wall, too.
    FacetCode wall = segment.wall;
    for (int way = 0; way < 2; ++way) {
        for (;;) {
            if (!divide_at_segment(q, wall, segment)) return Refusal::shapeless;
            // The tetrahedra of the sector between this wall and the next.
            for (FacetCode code = wall;;) {
                const TetId t = tetrahedron_of(code);
                add_member(t);
                states_[members_.number(t)] = at_divided_wall;
                const Tetrahedron& tet = mesh_.walled.mesh.tetrahedra[t];
                unsigned other = 0;
                while (other == face_of(code) || tet.v[other] == segment.a ||
                       tet.v[other] == segment.b)
                    ++other;
                wall = facet_code(t, other);
                if (mesh_.walled.is_wall(wall)) break;
                code = tet.n[other];
            }
            if (!divide_at_segment(q, wall, segment)) return Refusal::shapeless;
            if (edges_.is_hull(wall)) break;
            wall = edges_.behind(wall);
            if (wall == segment.wall) return dig(q);
        }
        // The other way around.
        if (edges_.is_hull(segment.wall)) break;
        wall = edges_.behind(segment.wall);
    }
    return dig(q);
}

// Finds the tetrahedra in conflict with the point, from those at divided walls on.
Refusal WallInsertion::dig(const double* q) {
    const WalledMesh& walled = mesh_.walled;
    const Mesh& mesh = walled.mesh;
    for (const FacetCode wall : divided_)
        for (const FacetCode code : {wall, edges_.behind(wall)}) {
            const TetId t = tetrahedron_of(code);
            if (mesh.tetrahedra[t].is_ghost()) continue;
            add_member(t);
            states_[members_.number(t)] = at_divided_wall;
        }
    for (std::uint32_t i = 0; i < members_.size(); ++i) {
        const TetId t = members_.name(i);
        for (unsigned k = 0; k < 4; ++k) {
            if (walled.is_wall(facet_code(t, k))) continue;
            const TetId next = tetrahedron_of(mesh.tetrahedra[t].n[k]);
            if (members_.lookup()(next) != no_index) continue;
            const VertexId(&v)[4] = mesh.tetrahedra[next].v;
            if (side_of_sphere(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]),
                               mesh.point(v[3]), q) > 0)
                add_member(next);
        }
    }
    const Refusal refusal = shrink(q);
    if (refusal != Refusal::none) return refusal;
    return keeps_all() ? Refusal::none : Refusal::shapeless;
}

// Removes members until the point sees the whole boundary. Those at divided walls have to stay.
Refusal WallInsertion::shrink(const double* q) {
    const WalledMesh& walled = mesh_.walled;
    const Mesh& mesh = walled.mesh;
    const auto number = members_.lookup();
    for (bool sees_all = false; !sees_all;) {
        sees_all = true;
        boundary_.clear();
        queue_.clear();
        for (std::uint32_t i = 0; i < members_.size(); ++i) {
            states_[i] &= at_divided_wall | has_left;
            if ((states_[i] & at_divided_wall) == 0) continue;
            states_[i] |= has_been_met;
            queue_.push_back(i);
        }
        for (std::size_t at = 0; at < queue_.size(); ++at) {
            const TetId t = members_.name(queue_[at]);
            for (unsigned k = 0; k < 4; ++k) {
                const FacetCode face = facet_code(t, k);
                const bool is_wall = walled.is_wall(face);
                if (is_wall && is_divided(face)) continue;
                const std::uint32_t next = number(tetrahedron_of(mesh.tetrahedra[t].n[k]));
                if (!is_wall && next != no_index && (states_[next] & has_left) == 0) {
                    if ((states_[next] & has_been_met) == 0) {
                        states_[next] |= has_been_met;
                        queue_.push_back(next);
                    }
                    continue;
                }
                const Tetrahedron& tet = mesh.tetrahedra[t];
                const unsigned char* const f = outer_face[k];
                if (orientation(q, mesh.point(tet.v[f[0]]), mesh.point(tet.v[f[2]]),
                                mesh.point(tet.v[f[1]])) > 0) {
                    boundary_.push_back(face);
                    continue;
                }
                if ((states_[queue_[at]] & at_divided_wall) != 0) return Refusal::shapeless;
                states_[queue_[at]] |= has_left;
                sees_all = false;
            }
        }
    }
    return Refusal::none;
}

// Whether all vertices of the cavity, and all edges that the mesh keeps, are on its boundary.
bool WallInsertion::keeps_all() {
    const WalledMesh& walled = mesh_.walled;
    const Mesh& mesh = walled.mesh;
    vertices_.clear();
    for (const FacetCode face : boundary_) {
        VertexId v[3];
        edges_.corners(face, v);
        for (const VertexId corner : v) vertices_.number(corner);
    }
    const auto is_on_boundary = vertices_.lookup();
    for (const std::uint32_t i : queue_)
        for (const VertexId v : mesh.tetrahedra[members_.name(i)].v)
            if (is_on_boundary(v) == no_index) return false;
    if (walled.loose_edges.size() == 0) return true;
    for (const std::uint32_t i : queue_) {
        const VertexId(&v)[4] = mesh.tetrahedra[members_.name(i)].v;
        for (int j = 0; j < 4; ++j)
            for (int k = 0; k < j; ++k) {
                if (walled.loose_edges.find(v[j], v[k]) == no_index) continue;
                const bool stays =
                    std::any_of(boundary_.begin(), boundary_.end(), [&](FacetCode face) {
                        VertexId w[3];
                        edges_.corners(face, w);
                        int ends = 0;
                        for (const VertexId x : w) ends += x == v[j] || x == v[k];
                        return ends == 2;
                    });
                if (!stays) return false;
            }
    }
    return true;
}

// Reads what the star needs to know of the cavity's boundary, and gives its tetrahedra back.
void WallInsertion::list_facets() {
    const WalledMesh& walled = mesh_.walled;
    Mesh& mesh = mesh_.walled.mesh;
    facets_.clear();
    for (const FacetCode face : boundary_) {
        const TetId t = tetrahedron_of(face);
        const Tetrahedron& tet = mesh.tetrahedra[t];
        const unsigned char* const f = outer_face[face_of(face)];
        facets_.push_back({{tet.v[f[0]], tet.v[f[2]], tet.v[f[1]]},
                           tet.n[face_of(face)],
                           walled.sides[face],
                           walled.regions[t],
                           walled.is_wall(face)});
    }
    for (const FacetCode wall : divided_)
        for (const FacetCode code : {wall, edges_.behind(wall)})
            if (mesh.tetrahedra[tetrahedron_of(code)].is_ghost())
                given_back_.push_back(tetrahedron_of(code));
    for (const std::uint32_t i : queue_) given_back_.push_back(members_.name(i));
    for (const TetId t : given_back_) mesh.tetrahedra[t].kill();
}

void WallInsertion::fill(VertexId q) {
    WalledMesh& walled = mesh_.walled;
    Mesh& mesh = walled.mesh;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
        const Facet& facet = facets_[i];
        const TetId t = star_[i];
        mesh.tetrahedra[t] = {{q, facet.v[0], facet.v[1], facet.v[2]},
                              {facet.outside, no_index, no_index, no_index}};
        mesh.tetrahedra[tetrahedron_of(facet.outside)].n[face_of(facet.outside)] = facet_code(t, 0);
        mesh.tetrahedra.sphere(t) = rounded(circumsphere(mesh.tetrahedra[t], mesh.vertices.data()));
        walled.walls[t] = facet.is_wall ? 1 : 0;
        walled.sides[4 * std::size_t{t}] = facet.side;
        walled.regions[t] = facet.region;
    }
}

void WallInsertion::find_star_edges() {
    star_edges_.clear();
    around_.clear();
    for (std::size_t i = 0; i < facets_.size(); ++i)
        for (unsigned k = 0; k < 3; ++k) {
            // Face k + 1 of the tetrahedron has the edge from x to y.
            const VertexId x = facets_[i].v[(k + 1) % 3], y = facets_[i].v[(k + 2) % 3];
            const std::uint32_t e = star_edges_.add(x, y);
            if (e == around_.size()) around_.push_back({x, y, {no_index, no_index}});
            around_[e].codes[around_[e].x == x ? 0 : 1] = facet_code(star_[i], k + 1);
        }
}

// The faces from the point to rims are walls.
void WallInsertion::mark_walls() {
    WalledMesh& walled = mesh_.walled;
    const auto mark = [&](FacetCode code, LinkedMesh::Side side) {
        if (code == no_index) return;
        walled.walls[tetrahedron_of(code)] |= static_cast<std::uint8_t>(1u << face_of(code));
        walled.sides[code] = side;
    };
    for (const Rim& rim : rims_) {
        const std::uint32_t e = star_edges_.find(rim.x, rim.y);
        const StarEdge& edge = around_[e];
        const bool is_same = edge.x == rim.x;
        mark(edge.codes[is_same ? 0 : 1], rim.here);
        mark(edge.codes[is_same ? 1 : 0], rim.there);
    }
}

}  // namespace mgdt
