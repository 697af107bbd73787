// SPDX-License-Identifier: MIT
#include "cli/mesh_refinement.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/formats/format.hpp"
#include "cli/input_file.hpp"
#include "cli/interrupt.hpp"
#include "cli/program_triangulation.hpp"
#include "cli/progress.hpp"

namespace mgdt::cli {
namespace {

// The size of each region, by its marker.
std::vector<double> sizes_of_regions(const mgdt::Mesh& mesh, const std::vector<double>& given,
                                     const std::string& name) {
    if (given.size() % 2 != 0) throw Error(exit_usage, "--region-size takes 2 numbers");
    const std::vector<std::int64_t> markers = mesh.array(MeshArray::region_markers);
    std::vector<double> sizes(markers.size(), 0);
    for (std::size_t i = 0; i < given.size(); i += 2) {
        bool is_found = false;
        for (std::size_t r = 0; r < markers.size(); ++r) {
            if (static_cast<double>(markers[r]) != given[i]) continue;
            sizes[r] = given[i + 1];
            is_found = true;
        }
        if (!is_found)
            throw Error(exit_usage, fmt::format("{}: no region has the marker {}", name, given[i]));
    }
    return sizes;
}

// Sets sizes at points in space: rows of three coordinates and a size.
void set_size_field(mgdt::Mesh& mesh, const std::string& path) {
    const InputFile file(path);
    const Field field = read_npy_values(file.source());
    constexpr std::size_t columns = 4;
    if (field.components != columns)
        throw Error(exit_input, fmt::format("{}: {} columns; a size field has 4", input_name(path),
                                            field.components));
    std::vector<Point> points;
    std::vector<double> sizes;
    for (std::size_t i = 0; i + columns <= field.values.size(); i += columns) {
        points.push_back({field.values[i], field.values[i + 1], field.values[i + 2]});
        sizes.push_back(field.values[i + 3]);
    }
    try {
        mesh.set_size_field(points, sizes);
    } catch (...) {
        rethrow_failure(input_name(path), mesh.last_error());
    }
}

// What a refinement has done.
std::string describe(const mgdt::Mesh& mesh) {
    std::string said = fmt::format(
        "refined: {} inserted, {}",
        counted(static_cast<std::size_t>(mesh.statistic(MeshStatistic::inserted_points)), "point",
                "points"),
        counted(static_cast<std::size_t>(mesh.statistic(MeshStatistic::tetrahedra)), "tetrahedron",
                "tetrahedra"));
    const auto left = static_cast<std::size_t>(mesh.statistic(MeshStatistic::refused));
    if (left == 0) return said + "\n";
    said += fmt::format("; {} beyond the bounds:", left);
    const std::vector<std::int64_t> refusals = mesh.array(MeshArray::refusals);
    const char* separator = " ";
    const auto add = [&](std::int64_t refusal, const char* why) {
        const auto n = std::count(refusals.begin(), refusals.end(), refusal);
        if (n == 0) return;
        said += fmt::format("{}{} {}", separator, n, why);
        separator = ", ";
    };
    add(MGDT_REFUSAL_HIDDEN, "behind facets");
    add(MGDT_REFUSAL_NEAR_POINT, "near points");
    add(MGDT_REFUSAL_NEAR_FACET, "near facets");
    add(MGDT_REFUSAL_NO_CAVITY, "without a place for a point");
    add(MGDT_REFUSAL_MOST_POINTS, "for the most points");
    return said + "\n";
}

}  // namespace

void add_refinement(CLI::App& app, RefineOptions& options) {
    const CLI::Validator from_zero(
        [](const std::string& text) -> std::string {
            double x = -1;
            return CLI::detail::lexical_cast(text, x) && x >= 0 && x < 1e300
                       ? ""
                       : text + " is no number from 0 on";
        },
        "", "from zero");
    app.add_option("--size", options.size, "The length that edges should have; 0 for any")
        ->type_name("H")
        ->check(from_zero);
    app.add_option("--region-size", options.region_sizes,
                   "The length of edges in the region with marker N; may be repeated")
        ->delimiter(',')
        ->type_name("N,H");
    app.add_option("--size-field", options.size_field,
                   "An .npy with a point and the length of edges there in each row")
        ->type_name("FILE")
        ->check(CLI::ExistingFile);
    app.add_flag("--surface-sizes", options.surface_sizes,
                 "Make edges as long as those of the surface near them");
    app.add_option("--volume", options.volume,
                   "The most volume that a tetrahedron should have; 0 for any")
        ->type_name("V")
        ->check(from_zero);
    app.add_option("--gradation", options.gradation,
                   "How fast lengths of edges may grow with the distance")
        ->type_name("G")
        ->check(from_zero)
        ->capture_default_str();
    app.add_option("--radius-edge", options.radius_edge,
                   "The most circumradius of a tetrahedron, in its shortest edges; 0 for any")
        ->type_name("B")
        ->check(from_zero)
        ->capture_default_str();
    app.add_option("--most-points", options.most_points,
                   "The most points that a refinement inserts; 0 for any number")
        ->type_name("N")
        ->check(CLI::Range(0, std::numeric_limits<int>::max()));
}

void set_given_sizes(mgdt::Mesh& mesh, const std::vector<double>& sizes, const std::string& name) {
    const auto points = static_cast<std::size_t>(mesh.statistic(MeshStatistic::points)),
               tetrahedra = static_cast<std::size_t>(mesh.statistic(MeshStatistic::tetrahedra));
    if (sizes.size() != points && sizes.size() != tetrahedra)
        throw Error(exit_input, fmt::format("{}: {}; the mesh has {} and {}", name,
                                            counted(sizes.size(), "size", "sizes"),
                                            counted(points, "point", "points"),
                                            counted(tetrahedra, "tetrahedron", "tetrahedra")));
    try {
        mesh.set_sizes(sizes.size() == tetrahedra ? Sizes::of_tetrahedra : Sizes::of_points, sizes);
    } catch (...) {
        rethrow_failure(name, mesh.last_error());
    }
}

std::string refine_mesh(mgdt::Mesh& mesh, const RefineOptions& options, bool quiet,
                        const std::string& name) {
    check_interrupt();
    Progress progress("refining", quiet);
    try {
        mesh.set_option(MeshDoubleOption::size, options.size);
        mesh.set_option(MeshDoubleOption::gradation, options.gradation);
        mesh.set_option(MeshDoubleOption::radius_edge, options.radius_edge);
        mesh.set_option(MeshDoubleOption::volume, options.volume);
        mesh.set_option(MeshOption::sizes_of_surface, options.surface_sizes ? 1 : 0);
        mesh.set_option(MeshOption::most_points, options.most_points);
        if (!options.size_field.empty()) set_size_field(mesh, options.size_field);
        if (!options.region_sizes.empty())
            mesh.set_sizes(Sizes::of_regions, sizes_of_regions(mesh, options.region_sizes, name));
        mesh.set_progress([&](double fraction) { return progress.update_and_hear(fraction); });
        mesh.refine();
        mesh.clear_progress();
    } catch (const Error&) {
        throw;
    } catch (const mgdt::Error& e) {
        // The sizes are too small, not the points too many.
        if (e.status() == MGDT_ERR_TOO_LARGE)
            throw Error(exit_memory, fmt::format("{}: {}", name, mesh.last_error()));
        rethrow_failure(name, mesh.last_error());
    } catch (...) {
        rethrow_failure(name, mesh.last_error());
    }
    return describe(mesh);
}

}  // namespace mgdt::cli
