// SPDX-License-Identifier: MIT
#include "cli/mesh_program.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/interrupt.hpp"
#include "cli/program_triangulation.hpp"
#include "cli/progress.hpp"

namespace mgdt::cli {
namespace {

// Adds the faces that are at a tetrahedron.
void add_faces(const mgdt::Mesh& made, Mesh& mesh) {
    const std::vector<MeshIndex> corners = made.array<MeshIndex>(MeshArray::faces),
                                 tetrahedra = made.array<MeshIndex>(MeshArray::face_tetrahedra),
                                 markers = made.array<MeshIndex>(MeshArray::face_markers);
    for (std::size_t f = 0; f < markers.size(); ++f) {
        const MeshIndex front = tetrahedra[2 * f], back = tetrahedra[2 * f + 1],
                        t = back >= 0 ? back : front;
        if (t < 0) continue;
        const MeshIndex* const face = &corners[3 * f];
        const MeshIndex* const tetrahedron = &mesh.tetrahedra[4 * static_cast<std::size_t>(t)];
        std::uint32_t k = 0;
        while (std::find(face, face + 3, tetrahedron[k]) != face + 3) ++k;
        mesh.faces.corners.insert(mesh.faces.corners.end(), face, face + 3);
        mesh.faces.markers.push_back(markers[f]);
        mesh.faces.sides.push_back(4 * static_cast<std::uint32_t>(t) + k);
    }
}

// The triangles among the facets, with their markers.
void set_faces(const FileFacets& facets, mgdt::Mesh& made) {
    std::vector<std::int64_t> corners;
    std::vector<std::int32_t> markers;
    for (std::size_t f = 0; f < facets.size(); ++f) {
        if (facets.begin[f + 1] - facets.begin[f] != 3) continue;
        for (std::int64_t i = facets.begin[f]; i < facets.begin[f + 1]; ++i)
            corners.push_back(facets.corners[static_cast<std::size_t>(i)]);
        markers.push_back(facets.markers[f]);
    }
    made.set_faces(corners, markers);
}

// The number of a word among the words that an option has.
std::int64_t number_of(const std::string& word, std::initializer_list<const char*> words) {
    return std::find(words.begin(), words.end(), word) - words.begin();
}

// What an improvement has changed. The columns of `values` are before and after.
std::string describe(const mgdt::Mesh& mesh, int goal) {
    const std::vector<double> shapes = mesh.doubles(MeshDoubles::shapes);
    std::string said = fmt::format(
        "dihedral angles: {:.2f} to {:.2f} degrees before, {:.2f} to {:.2f} after; mean "
        "shape: {:.3f} before, {:.3f} after\n",
        shapes[0], shapes[2], shapes[1], shapes[3], shapes[4], shapes[5]);
    const auto left = static_cast<std::size_t>(mesh.statistic(MeshStatistic::below_goal));
    if (left == 0) return said;
    const std::vector<std::int64_t> reasons = mesh.array(MeshArray::reasons);
    const auto because = [&](std::int64_t reason) {
        return static_cast<std::size_t>(std::count(reasons.begin(), reasons.end(), reason));
    };
    said += fmt::format(
        "{} below the goal of {} degrees:", counted(left, "tetrahedron", "tetrahedra"), goal);
    const char* separator = " ";
    const auto add = [&](std::int64_t reason, const char* why) {
        if (const std::size_t n = because(reason); n > 0) {
            said += fmt::format("{}{} {}", separator, n, why);
            separator = ", ";
        }
    };
    add(MGDT_REASON_INPUT_ANGLE, "between facets with a smaller angle");
    add(MGDT_REASON_THIN_FACE, "at thin faces of the surface");
    add(MGDT_REASON_FIXED_CORNERS, "with corners that stay where they are");
    add(MGDT_REASON_OTHER, "for other reasons");
    return said + "\n";
}

}  // namespace

mgdt::Mesh make_mesh(const Mesh& mesh, int threads, std::uint64_t memory_limit,
                     const std::string& name) {
    mgdt::Mesh made;
    try {
        made.set_option(MeshOption::threads, threads);
        made.set_option(MeshOption::memory_limit, static_cast<std::int64_t>(memory_limit));
        made.set_points(mgdt::Points(mesh.points.data(), mesh.point_count()));
        const std::vector<std::int64_t> corners(mesh.tetrahedra.begin(), mesh.tetrahedra.end());
        made.set_tetrahedra(corners, mesh.regions);
        set_faces(mesh.facets, made);
        made.set_edges(mesh.facets.segments);
        made.build();
    } catch (...) {
        rethrow_failure(name, made.last_error());
    }
    return made;
}

Mesh mesh_of(const mgdt::Mesh& made) {
    Mesh mesh;
    mesh.has_tetrahedra = true;
    const std::vector<Point> points = made.points();
    mesh.points.reserve(3 * points.size());
    for (const Point& p : points) mesh.points.insert(mesh.points.end(), p.begin(), p.end());
    mesh.tetrahedra = made.array<MeshIndex>(MeshArray::tetrahedra);
    mesh.neighbors = made.array<MeshIndex>(MeshArray::neighbors);
    const std::vector<MeshIndex> markers = made.array<MeshIndex>(MeshArray::region_markers);
    for (const MeshIndex region : made.array<MeshIndex>(MeshArray::tetrahedron_regions))
        mesh.regions.push_back(markers[static_cast<std::size_t>(region)]);
    add_faces(made, mesh);
    return mesh;
}

void add_improvement(CLI::App& app, ImproveOptions& options, const ImproveDefaults& defaults) {
    options.keep = defaults.keep;
    options.boundary = defaults.boundary;
    app.add_option("--goal", options.goal, "The least dihedral angle, in degrees")
        ->type_name("N")
        ->check(CLI::Range(0, 70))
        ->capture_default_str();
    app.add_option("--boundary", options.boundary,
                   "fixed: the surface keeps its triangles; slide: its points move within plane "
                   "facets and along straight edges, and a refinement inserts points there")
        ->check(CLI::IsMember({"fixed", "slide"}))
        ->capture_default_str();
    app.add_option("--keep", options.keep,
                   "What happens to the points that were read. all: they stay where they are; "
                   "numbers: they may move; none: some may also be left out")
        ->check(CLI::IsMember({"all", "numbers", "none"}))
        ->capture_default_str();
    app.add_option("--mean-passes", options.mean_passes,
                   "Passes that move all points for the mean of the shapes")
        ->type_name("N")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    app.add_option("--passes", options.most_passes, "Most passes over tetrahedra below the goal")
        ->type_name("N")
        ->check(CLI::Range(0, 10000))
        ->capture_default_str();
}

void require_sound(const mgdt::Mesh& mesh, const std::string& name) {
    try {
        mesh.check();
    } catch (const mgdt::Error& e) {
        if (e.status() == MGDT_ERR_CHECK_FAILED)
            throw Error(exit_check_failed,
                        fmt::format("{}: the mesh fails its check: {}; please report this", name,
                                    e.what()));
        rethrow_failure(name, mesh.last_error());
    } catch (...) {
        rethrow_failure(name, mesh.last_error());
    }
}

void set_boundary(mgdt::Mesh& mesh, const ImproveOptions& options) {
    mesh.set_option(MeshOption::boundary, number_of(options.boundary, {"fixed", "slide"}));
}

std::string improve_mesh(mgdt::Mesh& mesh, const ImproveOptions& options, bool quiet,
                         const std::string& name) {
    check_interrupt();
    Progress progress("improving", quiet);
    try {
        mesh.set_option(MeshOption::goal, options.goal);
        set_boundary(mesh, options);
        mesh.set_option(MeshOption::points, number_of(options.keep, {"all", "numbers", "none"}));
        mesh.set_option(MeshOption::mean_passes, options.mean_passes);
        mesh.set_option(MeshOption::most_passes, options.most_passes);
        mesh.set_progress([&](double fraction) { return progress.update_and_hear(fraction); });
        mesh.improve();
        mesh.clear_progress();
    } catch (...) {
        rethrow_failure(name, mesh.last_error());
    }
    return describe(mesh, options.goal);
}

}  // namespace mgdt::cli
