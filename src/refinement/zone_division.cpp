// SPDX-License-Identifier: MIT
#include "refinement/zone_division.hpp"

#include <algorithm>

#include "kernel/circumsphere.hpp"

namespace mgdt {

void ZoneDivision::sort_vertices(const RefinedMesh& mesh, std::size_t count, double shift,
                                 Team& team) {
    const Buffer<Vertex>& vertices = mesh.walled.mesh.vertices;
    zone_of_.resize(vertices.size());
    if (count == 1) {
        std::fill(zone_of_.begin(), zone_of_.end(), 0u);
        return;
    }
    const std::size_t n = vertices.size() - 1;
    const double* const x = vertices[1].x;
    const double low = -1 - shift, high = 2 - shift;
    const PointSet set = {
        {x, x + 1, x + 2}, sizeof(Vertex) / sizeof(double), n, 1.0, {low, low, low},
        {high, high, high}};
    const CurveOrder order = sort_along_curve(team, set, zone_of_.allocator());
    std::size_t used = 0, passed = 0;
    for (std::size_t v = 1; v <= n; ++v) used += WalledMesh::is_used(vertices[v]);
    for (std::size_t k = 0; k < n; ++k) {
        const std::uint32_t v = order.index(k) + 1;
        zone_of_[v] = static_cast<std::uint32_t>(passed * count / used);
        if (WalledMesh::is_used(vertices[v]) && passed + 1 < used) ++passed;
    }
}

void ZoneDivision::divide(const RefinedMesh& mesh, std::size_t count, double shift, Team& team) {
    sort_vertices(mesh, count, shift, team);
    zones.clear();
    zones.resize(count, {0, 0, 0, 0, 0.0});
    for (std::size_t v = 1; v < zone_of_.size(); ++v)
        zones[zone_of_[v]].vertices += WalledMesh::is_used(mesh.walled.mesh.vertices[v]);
    closed_.clear();
    of_bad_.clear();
    bad_between = 0;
    wanted_between = wanted_inside = 0;
    const Mesh& records = mesh.walled.mesh;
    for (TetId t = 0; t < records.tetrahedra.size(); ++t) {
        const Tetrahedron& tet = records.tetrahedra[t];
        if (tet.is_dead() || tet.is_ghost()) continue;
        const bool is_bad = mesh.verdicts[t].is_bad();
        const std::uint32_t zone = zone_of_[tet.v[0]];
        if (zone_of_[tet.v[1]] != zone || zone_of_[tet.v[2]] != zone ||
            zone_of_[tet.v[3]] != zone) {
            closed_.push_back(t);
            if (!is_bad) continue;
            ++bad_between;
            wanted_between += mesh.wanted_points(tet.v);
            continue;
        }
        ++zones[zone].tetrahedra;
        if (!is_bad) continue;
        of_bad_.push_back({t, zone});
        ++zones[zone].end;
        const double wanted = mesh.wanted_points(tet.v);
        wanted_inside += wanted;
        zones[zone].wanted += wanted;
    }
    std::size_t begin = 0;
    for (Zone& zone : zones) {
        const std::size_t n = zone.end;
        zone.begin = zone.end = begin;
        begin += n;
    }
    tetrahedra.resize(of_bad_.size());
    for (const Bad& bad : of_bad_) tetrahedra[zones[bad.zone].end++] = bad.tetrahedron;
}

void ZoneDivision::close(Mesh& mesh) const noexcept {
    for (const TetId t : closed_) mesh.tetrahedra.sphere(t).close();
}

void ZoneDivision::open(Mesh& mesh) const noexcept {
    for (const TetId t : closed_)
        mesh.tetrahedra.sphere(t) = rounded(circumsphere(mesh.tetrahedra[t], mesh.vertices.data()));
}

}  // namespace mgdt
