// SPDX-License-Identifier: MIT
#include "refinement/cavity_search.hpp"

#include <algorithm>
#include <limits>

#include "kernel/local_numbers.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// The states of a member of the cavity when that shrinks.
constexpr std::uint8_t is_removed = 1, is_reached = 2, is_leaving = 4;

struct CavityTetrahedra {
    const Tetrahedron& of(FacetCode code) const { return mesh.tetrahedra[tetrahedron_of(code)]; }
    const Mesh& mesh;
};

double volume_of(const double* q, const double* a, const double* b, const double* c,
                 double& size) noexcept {
    return rounded_volume(difference<double>(a, q), difference<double>(b, q),
                          difference<double>(c, q), size);
}

// The plane of a facet of the cavity's boundary. The distance of a point from it is the root of its
// squared product over the squared normal.
class WallPlane {
  public:
    WallPlane(const WalledMesh& walled, FacetCode outside) noexcept {
        const Corners4 t(walled.mesh.tetrahedra[tetrahedron_of(outside)]);
        const unsigned char* const f = outer_face[face_of(outside)];
        corner_ = walled.point(t.v[f[0]]);
        normal_ = cross(difference<double>(walled.point(t.v[f[1]]), corner_),
                        difference<double>(walled.point(t.v[f[2]]), corner_));
    }
    double squared_product(const double* x) const noexcept {
        const double product = dot(normal_, difference<double>(corner_, x));
        return product * product;
    }
    double squared_normal() const noexcept { return dot(normal_, normal_); }

  private:
    const double* corner_;
    Vector<double> normal_;
};

// Whether the tetrahedron (q, a, b, c) is positive, exactly.
bool is_positive(const double* q, const double* a, const double* b, const double* c) noexcept {
    double size;
    const double volume = volume_of(q, a, b, c, size);
    const double error = volume_error * size + least_product;
    if (volume > error) return true;
    if (volume < -error) return false;
    return orientation(q, a, b, c) > 0;
}

}  // namespace

// Whether the point sees the inner side of a facet of the boundary.
bool CavitySearch::sees(const Mesh& mesh, FacetCode outside, const double* q) const noexcept {
    const Corners4 t(mesh.tetrahedra[tetrahedron_of(outside)]);
    const unsigned char* const f = outer_face[face_of(outside)];
    return is_positive(q, mesh.point(t.v[f[0]]), mesh.point(t.v[f[1]]), mesh.point(t.v[f[2]]));
}

bool CavitySearch::sees_all(const Mesh& mesh, const double* q) const noexcept {
    const FacetCode* const boundary = workspace.boundary.data;
    return std::all_of(boundary, boundary + workspace.boundary_size,
                       [&](FacetCode outside) { return sees(mesh, outside, q); });
}

// Walks straight from the centroid of the point's tetrahedron to the point, and ends at walls: what
// is behind them has no place for the point, and may have a cavity of very many tetrahedra.
CavitySearch::Outcome CavitySearch::walk(const WalledMesh& walled, const NewPoint& point) noexcept {
    const Mesh& mesh = walled.mesh;
    const double* const q = point.x;
    double from[3];
    find_centroid(mesh, point.start, from);
    refusal_ = Refusal::hidden;
    wall_ = no_index;
    container_ = point.start;
    unsigned entry = 4;
    constexpr int most_steps = 10000;
    for (int step = 0; step < most_steps; ++step) {
        const Tetrahedron& t = mesh.tetrahedra[container_];
        unsigned exit = 4;
        double least = 2;
        for (unsigned i = 0; i < 4; ++i) {
            if (i == entry) continue;
            const double* const a = mesh.point(t.v[outer_face[i][0]]);
            const double* const b = mesh.point(t.v[outer_face[i][1]]);
            const double* const c = mesh.point(t.v[outer_face[i][2]]);
            // The tetrahedron (q, a, b, c) is positive if q is beyond face i.
            if (!is_positive(q, a, b, c)) continue;
            double unused;
            const double there = volume_of(q, a, b, c, unused),
                         here = volume_of(from, a, b, c, unused);
            const double passed = there > here ? -here / (there - here) : 1;
            if (exit != 4 && !(passed < least)) continue;
            exit = i;
            least = passed;
        }
        if (exit == 4) return Outcome::found;
        if (walled.is_wall(facet_code(container_, exit))) {
            wall_ = facet_code(container_, exit);
            return Outcome::refused;
        }
        const FacetCode next = t.n[exit];
        container_ = tetrahedron_of(next);
        if (mesh.tetrahedra.sphere(container_).is_closed()) return Outcome::closed;
        entry = face_of(next);
    }
    return Outcome::refused;
}

CavitySearch::Outcome CavitySearch::find(RefinedMesh& mesh, const KernelCalls& kernel,
                                         NewPoint& point) {
    Workspace& w = workspace;
    WalledMesh& walled = mesh.walled;
    if (const Outcome reached = walk(walled, point); reached != Outcome::found) return reached;
    if (!kernel.dig_walled(walled.mesh, w, walled.walls.data(), point.x, point.start))
        return Outcome::closed;
    refusal_ = Refusal::none;
    try {
        if (!sees_all(walled.mesh, point.x)) refusal_ = shrink(walled, point.x);
        if (refusal_ == Refusal::none) refusal_ = judge(mesh, point);
    } catch (...) {
        w.restore_cavity(walled.mesh.tetrahedra, w.cavity_size);
        throw;
    }
    if (refusal_ == Refusal::none) return Outcome::found;
    w.restore_cavity(walled.mesh.tetrahedra, w.cavity_size);
    return Outcome::refused;
}

Refusal CavitySearch::judge(const RefinedMesh& mesh, NewPoint& point) {
    Workspace& w = workspace;
    if (w.cavity_size > w.star_removed || w.boundary_size > w.star_created)
        w.grow_star(w.cavity_size, w.boundary_size);
    if (!keeps_all(mesh.walled)) return Refusal::shapeless;
    const Refusal refusal = judge_vertices(mesh, point);
    if (refusal != Refusal::none) return refusal;
    if (is_near_wall(mesh.walled, point) && (point.is_on_lattice || !is_gain(mesh, point)))
        return Refusal::near_wall;
    return Refusal::none;
}

// Removes members of the cavity until the point sees all facets. What remains is connected and has
// the member that contains the point. If that is refused, the cavity has the marked members still.
Refusal CavitySearch::shrink(WalledMesh& walled, const double* q) {
    Workspace& w = workspace;
    members_.clear();
    removed_.clear();
    for (std::size_t i = 0; i < w.cavity_size; ++i) {
        members_.number(tetrahedron_of(w.cavity.data[i]));
        removed_.push_back(0);
    }
    if (members_.lookup()(container_) == no_index) return Refusal::shapeless;
    while (!dig_within_members(walled, container_, q))
        if ((removed_[members_.number(container_)] & is_leaving) != 0) {
            w.cavity_size = members_.size();
            for (std::uint32_t i = 0; i < members_.size(); ++i)
                w.cavity.data[i] = first_facet(members_.name(i));
            return Refusal::shapeless;
        }
    for (std::uint32_t i = 0; i < members_.size(); ++i)
        if ((removed_[i] & is_reached) == 0)
            walled.mesh.tetrahedra[members_.name(i)].v[1] &= ~in_cavity;
    return Refusal::none;
}

// Digs the cavity anew from `first`, in the members that have not been removed. If the point does
// not see facets of the boundary, removes the members there and returns false.
bool CavitySearch::dig_within_members(const WalledMesh& walled, TetId first, const double* q) {
    Workspace& w = workspace;
    const Mesh& mesh = walled.mesh;
    for (std::uint8_t& state : removed_)
        state = (state & (is_removed | is_leaving)) != 0 ? is_removed : 0;
    const auto member = members_.lookup();
    const Corners4 begin(mesh.tetrahedra[first]);
    for (unsigned i = 1; i < 4; ++i) w.first_corners[i] = begin.v[i];
    w.first_corners[0] = begin.v[1];
    // The new list is no longer than the old one, whose members are in members_.
    std::size_t size = 0, facets = 0;
    bool sees_boundary = true;
    w.cavity.data[size++] = first_facet(first);
    removed_[member(first)] |= is_reached;
    for (std::size_t i = 0; i < size; ++i) {
        const TetId t = tetrahedron_of(w.cavity.data[i]);
        for (unsigned k = 0; k < 4; ++k) {
            const FacetCode beyond = mesh.tetrahedra[t].n[k];
            const std::uint32_t other = member(tetrahedron_of(beyond));
            if (other == no_index || removed_[other] == is_removed ||
                walled.is_wall(facet_code(t, k))) {
                if (!sees(mesh, beyond, q)) {
                    removed_[member(t)] |= is_leaving;
                    sees_boundary = false;
                }
                w.boundary.data[facets++] = beyond;
            } else if ((removed_[other] & is_reached) == 0) {
                removed_[other] |= is_reached;
                w.cavity.data[size++] = beyond;
            }
        }
    }
    w.cavity_size = size;
    w.boundary_size = facets;
    return sees_boundary;
}

// Whether all vertices of the cavity, and all edges that the mesh keeps, are on its boundary.
bool CavitySearch::keeps_all(const WalledMesh& walled) {
    Workspace& w = workspace;
    const Mesh& mesh = walled.mesh;
    bool is_direct = false;
    {
        DirectNumbers numbers(w);
        is_direct = numbers.add_cavity(w, CavityTetrahedra{mesh});
        vertices_ = numbers.count();
    }
    if (!is_direct) {
        ProbedNumbers numbers(w);
        numbers.add_cavity(w, CavityTetrahedra{mesh});
        vertices_ = numbers.count();
        // A sphere of F triangles has F / 2 + 2 vertices.
        if (2 * std::size_t{vertices_} != w.boundary_size + 4) return false;
    }
    if (walled.loose_edges.size() == 0) return true;
    for (std::size_t i = 0; i < w.cavity_size; ++i) {
        const Corners4 t(mesh.tetrahedra[tetrahedron_of(w.cavity.data[i])]);
        for (unsigned j = 0; j < 4; ++j)
            for (unsigned k = 0; k < j; ++k) {
                if (walled.loose_edges.find(t.v[j], t.v[k]) == no_index) continue;
                const auto has_edge = [&](FacetCode outside) {
                    const Corners4 o(mesh.tetrahedra[tetrahedron_of(outside)]);
                    const VertexId apex = o.v[face_of(outside)];
                    int ends = 0;
                    for (const VertexId v : o.v) ends += v != apex && (v == t.v[j] || v == t.v[k]);
                    return ends == 2;
                };
                if (std::none_of(w.boundary.data, w.boundary.data + w.boundary_size, has_edge))
                    return false;
            }
    }
    return true;
}

// Finds the size of the point, and whether the point is far enough from all vertices.
Refusal CavitySearch::judge_vertices(const RefinedMesh& mesh, NewPoint& point) const noexcept {
    point.find_size(mesh, vertices_, [&](std::uint32_t i) { return workspace.ids.data[i]; });
    return point.nearest2 < point.least2 ? Refusal::near_vertex : Refusal::none;
}

FacetCode CavitySearch::find_wall(RefinedMesh& mesh, const KernelCalls& kernel,
                                  const NewPoint& point) {
    WalledMesh& walled = mesh.walled;
    if (walk(walled, point) != Outcome::found) return wall_;
    Workspace& w = workspace;
    if (!kernel.dig_walled(walled.mesh, w, walled.walls.data(), point.x, point.start))
        return no_index;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < w.boundary_size; ++i) {
        const FacetCode outside = w.boundary.data[i];
        if (!walled.is_wall(outside)) continue;
        const WallPlane plane(walled, outside);
        const double relative = plane.squared_product(point.x) / plane.squared_normal();
        if (!(relative < least)) continue;
        least = relative;
        wall_ = walled.mesh.tetrahedra[tetrahedron_of(outside)].n[face_of(outside)];
    }
    w.restore_cavity(walled.mesh.tetrahedra, w.cavity_size);
    return wall_;
}

// Whether the point is near the plane of a wall at which the cavity ends.
bool CavitySearch::is_near_wall(const WalledMesh& walled, const NewPoint& point) const noexcept {
    return std::any_of(workspace.boundary.data, workspace.boundary.data + workspace.boundary_size,
                       [&](FacetCode outside) {
                           if (!walled.is_wall(outside)) return false;
                           const WallPlane plane(walled, outside);
                           return plane.squared_product(point.x) <
                                  point.from_wall2 * plane.squared_normal();
                       });
}

// Whether the star has fewer bad tetrahedra than the cavity.
bool CavitySearch::is_gain(const RefinedMesh& mesh, const NewPoint& point) const noexcept {
    const Workspace& w = workspace;
    const WalledMesh& walled = mesh.walled;
    std::size_t before = 0, after = 0;
    for (std::size_t i = 0; i < w.cavity_size; ++i) {
        const Corners4 t(walled.mesh.tetrahedra[tetrahedron_of(w.cavity.data[i])]);
        before += mesh.excess(t.v) > 1;
    }
    for (std::size_t i = 0; i < w.boundary_size; ++i) {
        const FacetCode outside = w.boundary.data[i];
        const Corners4 t(walled.mesh.tetrahedra[tetrahedron_of(outside)]);
        const unsigned char* const f = outer_face[face_of(outside)];
        const VertexId a = t.v[f[0]], b = t.v[f[1]], c = t.v[f[2]];
        const ElementShape e =
            element_of(point.x, walled.point(a), walled.point(b), walled.point(c));
        const double size = 0.25 * ((point.size + mesh.sizes[a]) + (mesh.sizes[b] + mesh.sizes[c]));
        after += mesh.bounds.excess(e, size) > 1;
        if (after >= before) return false;
    }
    return true;
}

}  // namespace mgdt
