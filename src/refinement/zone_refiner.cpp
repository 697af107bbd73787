// SPDX-License-Identifier: MIT
#include "refinement/zone_refiner.hpp"

#include <algorithm>
#include <limits>

#include "predicates/circumcenter.hpp"

namespace mgdt {
namespace {

// The mesh is between -1 and 1.
bool is_in_box(const double* x) noexcept {
    return std::fabs(x[0]) <= 1 && std::fabs(x[1]) <= 1 && std::fabs(x[2]) <= 1;
}

}  // namespace

void ZoneRefiner::begin_zone(const TetId* begin, const TetId* end) {
    bad_.clear();
    for (const TetId* t = begin; t != end; ++t)
        bad_.add({*t, mesh_.walled.mesh.tetrahedra[*t].v[0]}, mesh_.verdicts[*t].class_of());
}

// Divides a tetrahedron if it is still there. Returns false if the slots are used up.
bool ZoneRefiner::divide(const BadTetrahedron& bad, ZoneSupply& supply) {
    const Mesh& mesh = mesh_.walled.mesh;
    if (mesh.tetrahedra[bad.slot].v[0] != bad.newest) return true;
    Verdict& verdict = mesh_.verdicts[bad.slot];
    Refusal refusal = Refusal::hidden;
    NewPoint point;
    if (propose(bad.slot, point)) {
        switch (search_.find(mesh_, calls_, point)) {
            case CavitySearch::Outcome::closed:
                return true;
            case CavitySearch::Outcome::refused:
                refusal = search_.refusal();
                break;
            case CavitySearch::Outcome::found:
                Workspace& w = search_.workspace;
                if (w.boundary_size > w.cavity_size + supply.slots()) {
                    w.restore_cavity(mesh_.walled.mesh.tetrahedra, w.cavity_size);
                    return false;
                }
                insert(point, supply);
                return true;
        }
    }
    if (point.is_last) {
        verdict = Verdict(refusal);
    } else {
        verdict.count_try();
        bad_.add(bad, verdict.class_of());
    }
    return true;
}

// Finds the point that is to divide a tetrahedron. Returns false if that is outside of the mesh.
bool ZoneRefiner::propose(TetId t, NewPoint& point) const noexcept {
    const VertexId(&v)[4] = mesh_.walled.mesh.tetrahedra[t].v;
    const ElementShape e = mesh_.element(v);
    const double size = mesh_.mean_size(v);
    const double least = mesh_.bounds.least_edge * size, near = mesh_.bounds.from_wall * size;
    const bool is_large = mesh_.bounds.exceeds_size(e, size);
    point.start = t;
    point.from_wall2 = std::min(near * near, 0.25 * e.radius2);
    point.least2 = mesh_.bounds.exceeds_shape(e) ? e.shortest2 : 0.25 * e.radius2;
    if (is_large) point.least2 = least * least;
    point.is_on_lattice = false;
    point.is_last = !is_large;
    if (!choose_place(t, e, point) || !is_in_box(point.x)) return false;
    // Tiny coordinates would be outside of the normal range.
    for (double& x : point.x)
        if (std::fabs(x) < 0x1p-100) x = 0;
    point.size = mesh_.places.at(point.x, mesh_.walled.regions[t]);
    return true;
}

// Chooses the place: first the circumcentre, or for a tetrahedron that is too large, the lattice
// point nearest to it, then the circumcentre itself, and then the same for the centroid, which is
// on this side of all walls. Returns false for a place that is not in conflict with the
// tetrahedron.
bool ZoneRefiner::choose_place(TetId t, const ElementShape& e, NewPoint& point) const noexcept {
    const VertexId(&v)[4] = mesh_.walled.mesh.tetrahedra[t].v;
    const double* const p[4] = {mesh_.walled.point(v[0]), mesh_.walled.point(v[1]),
                                mesh_.walled.point(v[2]), mesh_.walled.point(v[3])};
    const bool is_large = !point.is_last, has_lattice = lattice_.step > 0;
    const unsigned tries = mesh_.verdicts[t].tries();
    // Tries of the circumcentre, and of the centroid.
    const unsigned each = has_lattice ? 2 : 1;
    const bool is_snapped = is_large && has_lattice && tries % 2 == 0;
    point.is_last = !is_large || tries + 1 == 2 * each;
    double radius2 = e.radius2, centre[3];
    for (int k = 0; k < 3; ++k) centre[k] = p[0][k] + e.offset.x[k];
    // Rounding may take the circumcentre of a flat tetrahedron far away.
    bool is_accurate = radius2 < 16;
    for (int j = 1; j < 4; ++j) {
        const Vector<double> d = difference<double>(p[j], centre);
        is_accurate = is_accurate && std::fabs(dot(d, d) - radius2) < 0x1p-10 * radius2;
    }
    if (!is_accurate) {
        const Circumcenter exact = circumcenter(p);
        std::copy_n(exact.x, 3, centre);
        radius2 = exact.radius2;
    }
    if (tries < each)
        std::copy_n(centre, 3, point.x);
    else
        find_centroid(mesh_.walled.mesh, t, point.x);
    if (!is_snapped || !is_in_box(point.x)) return !is_snapped;
    double snapped[3];
    lattice_.snap(point.x, snapped);
    std::copy_n(snapped, 3, point.x);
    point.is_on_lattice = true;
    const Vector<double> d = difference<double>(snapped, centre);
    return dot(d, d) < 0.9 * radius2;
}

// Inserts a point whose cavity is in the workspace.
void ZoneRefiner::insert(const NewPoint& point, ZoneSupply& supply) {
    WalledMesh& walled = mesh_.walled;
    Mesh& mesh = walled.mesh;
    const Workspace& w = search_.workspace;
    const VertexId vertex = *supply.next_vertex++;
    ++inserted;
    walled.set_vertex(vertex, point.x);
    mesh_.set_sizes(vertex, point.size, point.interpolated, point.spacing);
    // Facets of the boundary stay what they are. Slots of the cavity are used again, so this is
    // read first.
    const std::size_t n = w.boundary_size;
    const std::uint32_t region = walled.regions[tetrahedron_of(w.cavity.data[0])];
    facets_.grow(n);
    facets_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const FacetCode outside = w.boundary.data[i];
        const FacetCode inside = mesh.tetrahedra[tetrahedron_of(outside)].n[face_of(outside)];
        facets_[i] = {walled.is_wall(outside), walled.sides[inside]};
    }
    calls_.fill_walled(mesh, search_.workspace, vertex, &supply.slots_end);
    for (std::size_t i = 0; i < n; ++i) {
        const TetId t = tetrahedron_of(w.slots.data[i]);
        walled.walls[t] = facets_[i].is_wall ? 1 : 0;
        walled.sides[4 * std::size_t{t}] = facets_[i].side;
        walled.regions[t] = region;
        const Verdict verdict(mesh_.excess(mesh.tetrahedra[t].v));
        mesh_.verdicts[t] = verdict;
        if (verdict.is_bad()) bad_.add({t, vertex}, verdict.class_of());
    }
}

}  // namespace mgdt
