// SPDX-License-Identifier: MIT
#include "refinement/mesh_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "platform/error.hpp"
#include "refinement/refiner.hpp"

namespace mgdt {
namespace {

constexpr double infinite_size = std::numeric_limits<double>::infinity();

ElementBounds bounds_of(const RefinementOptions& options, double scale) {
    ElementBounds bounds;
    bounds.radius_edge = options.radius_edge > 0 ? options.radius_edge : infinite_size;
    bounds.volume = options.volume > 0 ? options.volume * scale * scale * scale : infinite_size;
    return bounds;
}

// A lattice for a mesh with one size; no lattice for sizes that vary, or that are too small for
// doubles to tell its points apart.
CubicLattice lattice_for(const Buffer<double>& sizes) {
    // The mean edge of the lattice is 0.924 steps long.
    constexpr double steps_per_size = 1.09, off_origin = 0.0123, least_size = 0x1p-40;
    CubicLattice lattice;
    double least = infinite_size, most = 0;
    for (std::size_t v = 1; v < sizes.size(); ++v) {
        least = std::min(least, sizes[v]);
        most = std::max(most, sizes[v]);
    }
    if (least < most || !(least < infinite_size) || least < least_size) return lattice;
    lattice.step = steps_per_size * least;
    // Walls are often where coordinates are round numbers.
    for (double& x : lattice.origin) x = off_origin * lattice.step;
    return lattice;
}

// Whether scaling has changed no corner: some coordinates may be so much smaller than others that
// they are rounded, and tetrahedra become flat.
bool is_exact(const LinkedMesh& linked, const SolidMesh& mesh) {
    return std::all_of(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), [&](std::uint32_t v) {
        for (std::size_t k = 3 * std::size_t{v}; k < 3 * std::size_t{v} + 3; ++k)
            if (linked.x[k] / linked.scale() != mesh.points[k]) return false;
        return true;
    });
}

// Refuses sizes that would take more points than there are numbers for.
void require_possible(double wanted) {
    constexpr double most = 0x1p27;  // 2^30 tetrahedra have fewer
    if (wanted > most) fail(MGDT_ERR_TOO_LARGE, "the sizes would take about %.2g points", wanted);
}
double wanted_points(const RefinedMesh& mesh) {
    double wanted = 0;
    const Mesh& records = mesh.walled.mesh;
    for (TetId t = 0; t < records.tetrahedra.size(); ++t) {
        const Tetrahedron& tet = records.tetrahedra[t];
        if (!tet.is_dead() && !tet.is_ghost()) wanted += mesh.wanted_points(tet.v);
    }
    return wanted;
}

// Finds the sizes that are wanted at the vertices and at places between them.
void find_sizes(RefinedMesh& mesh, const SolidMesh& solid, const RefinementOptions& options,
                const SizeWishes& wishes, double scale, Team& team, Allocator& allocator,
                StageProgress& progress) {
    const bool may_be_any = options.most_points > 0;
    set_sizes(mesh, solid, wishes, options.size, options.sizes_of_surface, scale, progress);
    std::optional<SizeSampler> sampler;
    if (!wishes.varying.empty()) {
        sampler.emplace(wishes.varying, scale, team, allocator, progress);
        add_sizes_at_vertices(mesh, *sampler, progress);
    }
    limit_sizes(mesh, mesh.sizes, 0, progress);
    if (!may_be_any) require_possible(wanted_points(mesh));
    if (!sampler) return;
    constexpr std::size_t cells_per_point = 16, least_cells = 0x10000, most_cells = 0x400000;
    const std::size_t cells =
        may_be_any ? std::min(least_cells +
                                  cells_per_point * static_cast<std::size_t>(options.most_points),
                              most_cells)
                   : most_cells;
    add_varying_sizes(mesh, *sampler, cells, progress);
    limit_sizes(mesh, mesh.sizes, 0, progress);
    if (!may_be_any) {
        require_possible(mesh.places.varying.wanted_points());
        require_possible(wanted_points(mesh));
    }
}

}  // namespace

void refine_mesh(SolidMesh& mesh, const RefinementOptions& options, const SizeWishes& wishes,
                 Team& team, Allocator& allocator, StageProgress& progress,
                 RefinementReport& report) {
    constexpr double begun = 0.1, refined = 0.9;
    LinkedMesh linked(mesh, team, allocator);
    RefinementReport made(report.sizes.allocator());
    if (linked.can_move() && is_exact(linked, mesh)) {
        const double scale = linked.scale();
        RefinedMesh refined_mesh(linked, team, allocator);
        refined_mesh.bounds = bounds_of(options, scale);
        refined_mesh.gradation = options.gradation;
        const auto most_points = static_cast<std::size_t>(options.most_points);
        progress.enter(0, begun);
        find_sizes(refined_mesh, mesh, options, wishes, scale, team, allocator, progress);
        const CubicLattice lattice = lattice_for(refined_mesh.sizes);
        Refiner refiner(refined_mesh, lattice, default_kernel(), team, allocator);
        if (most_points > 0) refiner.most_points = most_points;
        if (options.divides_walls) {
            refined_mesh.find_spacings();
            refiner.divide_walls();
        }
        StageProgress inner = progress.within(begun, refined);
        refiner.run(inner);
        // New edges may be shorter than the ways along which sizes were limited.
        constexpr int most_limits = 10;
        constexpr double tolerance = 0.05;
        for (int i = 0; i < most_limits; ++i) {
            StageProgress quiet = progress.quiet();
            if (!limit_sizes(refined_mesh, refined_mesh.sizes, tolerance, quiet)) break;
            refiner.run(quiet);
        }
        made.inserted = refiner.inserted;
        // The tetrahedra and vertices of the linked mesh, in its order.
        refined_mesh.walled.write(linked);
        for (VertexId v = 1; v < refined_mesh.walled.mesh.vertices.size(); ++v)
            if (WalledMesh::is_used(refined_mesh.walled.mesh.vertices[v])) {
                const double size = refined_mesh.sizes[v];
                made.sizes.push_back(size < infinite_size ? size / scale : 0);
            }
        for (TetId t = 0; t < refined_mesh.walled.mesh.tetrahedra.size(); ++t) {
            const Tetrahedron& tet = refined_mesh.walled.mesh.tetrahedra[t];
            if (tet.is_dead() || tet.is_ghost()) continue;
            const Verdict& verdict = refined_mesh.verdicts[t];
            made.refusals.push_back(verdict.is_bad() ? Refusal::no_points_left : verdict.refusal());
        }
    } else {
        // There is no way to write points between the given ones.
        made.refusals.resize(linked.tetrahedra.size(), Refusal::shapeless);
        made.sizes.resize(mesh.points.size() / 3, 0);
    }
    SolidMesh result(mesh.points.allocator());
    Buffer<std::uint32_t> number(allocator);
    linked.write(mesh, result, number);
    Buffer<Refusal> sorted(made.refusals.allocator());
    sorted.resize(made.refusals.size());
    for (std::size_t t = 0; t < number.size(); ++t) {
        sorted[number[t]] = made.refusals[t];
        made.refused += made.refusals[t] != Refusal::none;
    }
    progress.enter(refined, 1);
    progress.report(1);
    made.refusals = std::move(sorted);
    made.is_made = true;
    mesh = std::move(result);
    report = std::move(made);
}

}  // namespace mgdt
