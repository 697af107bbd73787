// SPDX-License-Identifier: MIT
// mgdt check: checks whether a file holds a Delaunay triangulation.
#include <fmt/core.h>

#include <cstdio>
#include <functional>
#include <memory>

#include "cli/commands/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/help.hpp"
#include "cli/counts.hpp"
#include "cli/domain_program.hpp"
#include "cli/errors.hpp"
#include "cli/formats/mid_side_nodes.hpp"
#include "cli/mesh_check.hpp"

namespace mgdt::cli {
namespace {

struct CheckOptions {
    InputOptions input;
    std::string points;           // file of the points, if `input` is an array of tetrahedra
    int index_base = 0;           // the index base of that array
    bool is_constrained = false;  // check a mesh that need not be Delaunay or convex
    TriangulationOptions triangulation;
};

// Reads tetrahedra from an .npy file and points from another file.
Mesh read_pair(const CheckOptions& options) {
    InputOptions points = options.input;
    points.path = options.points;
    points.from = "";
    Mesh mesh = read_input(points);
    const InputFile file(options.input.path);
    mesh.tetrahedra =
        read_npy_tetrahedra(file.source(), options.index_base, mesh.point_count(), options.points);
    mesh.has_tetrahedra = true;
    return mesh;
}

void print(const char* what, bool good, const std::string& detail) {
    fmt::print("  {:<12} {:<4} {}\n", what, good ? "ok" : "BAD", detail);
}

// Prints the findings, unless it is quiet, and returns the first bad one, or nullptr.
const Finding* print_findings(const MeshReport& report, bool quiet) {
    const Finding* first = nullptr;
    for (const Finding& f : report.findings) {
        if (!quiet) print(f.what, f.good, f.detail);
        if (!f.good && first == nullptr) first = &f;
    }
    return first;
}

// Says whether boundary facets of a mesh cross or touch.
Finding crossings(const Mesh& mesh, const std::vector<MeshIndex>& boundary,
                  const CheckOptions& options, const std::string& name) {
    Mesh surface;
    std::vector<std::int64_t> number(mesh.point_count(), -1);
    for (std::size_t i = 0; i < boundary.size(); i += 3) {
        std::int64_t corners[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = static_cast<std::size_t>(boundary[i + k]);
            if (number[v] < 0) {
                number[v] = static_cast<std::int64_t>(surface.point_count());
                surface.points.insert(surface.points.end(), &mesh.points[3 * v],
                                      &mesh.points[3 * v] + 3);
            }
            corners[k] = number[v];
        }
        surface.facets.add_facet(corners, 3);
    }
    Domain domain = make_domain(surface, options.triangulation.threads,
                                options.triangulation.memory_limit, name);
    try {
        domain.validate();
    } catch (const mgdt::Error& e) {
        if (e.status() != MGDT_ERR_INVALID_BOUNDARY) rethrow_failure(name, domain.last_error());
        return {"crossings", false,
                fmt::format("{} of boundary facets cross or touch",
                            counted(offending_pairs(domain).size(), "pair", "pairs"))};
    }
    return {"crossings", true, "boundary facets meet in common corners and edges only"};
}

int check_constrained(const Mesh& mesh, const Reference& reference, const CheckOptions& options,
                      const std::string& name) {
    auto [report, boundary] = check_constrained_mesh(mesh, reference);
    if (report.valid) report.findings.push_back(crossings(mesh, boundary, options, name));
    if (const Finding* const first = print_findings(report, options.triangulation.quiet))
        throw Error(exit_check_failed, fmt::format("{}: not a mesh of tetrahedra: {}: {}", name,
                                                   first->what, first->detail));
    if (!options.triangulation.quiet)
        fmt::print("{}: a mesh whose boundary does not cross itself\n", name);
    return exit_ok;
}

int check(const CheckOptions& options) {
    const bool quiet = options.triangulation.quiet;
    const std::string name = input_name(options.input.path);
    const Format* format = nullptr;
    const bool pair = !options.points.empty();
    InputOptions input = options.input;
    input.read.has_facets = true;  // the faces that are constrained
    const Mesh mesh = pair ? read_pair(options) : read_input(input, &format);
    if (!quiet) {
        fmt::print("{}: {}, {}", name, format ? format->name : "npy",
                   counted(mesh.point_count(), "point", "points"));
        if (mesh.has_tetrahedra) {
            fmt::print(", {}", counted(mesh.tetrahedron_count(), "tetrahedron", "tetrahedra"));
        }
        if (mesh.other_cells > 0) fmt::print(", {} other cells left out", mesh.other_cells);
        if (mesh.mid_side_nodes > 0)
            fmt::print(", {}", describe_mid_side_nodes(mesh.mid_side_nodes));
        fmt::print("\n");
    }

    if (!mesh.has_tetrahedra && mesh.other_cells > 0) {
        throw Error(exit_no_tetrahedra,
                    fmt::format("{}: a mesh of {} with no tetrahedron that mgdt reads; there is "
                                "nothing to check",
                                name, counted(mesh.other_cells, "other cell", "other cells")));
    }

    Triangulation t = make_triangulation(options.triangulation);
    insert(t, mesh.points, name, quiet);
    const std::string defect = find_defect(t, MGDT_CHECK_CANONICAL);
    if (!quiet) {
        print("library", defect.empty(),
              defect.empty() ? fmt::format("mgdt's own triangulation of the points, {}, passes the "
                                           "library's check at level 3",
                                           counted(static_cast<std::size_t>(t.tetrahedron_count()),
                                                   "tetrahedron", "tetrahedra"))
                             : defect);
    }
    if (!defect.empty()) {
        throw Error(exit_check_failed,
                    fmt::format("{}: mgdt's own triangulation fails its check: {}; please report "
                                "this",
                                name, defect));
    }
    if (!mesh.has_tetrahedra) {
        if (!quiet) fmt::print("{}: points only; their Delaunay triangulation is valid\n", name);
        return exit_ok;
    }

    const Reference reference{tetrahedra(t), t.point_map<MeshIndex>()};
    t = Triangulation();  // frees its memory for the tests
    if (options.is_constrained) return check_constrained(mesh, reference, options, name);
    const MeshReport report = check_mesh(mesh, reference);
    // A file with triangles says that it has a boundary of its own.
    if (!report.valid && mesh.facets.size() > 0)
        return check_constrained(mesh, reference, options, name);
    const std::size_t canonical = reference.tetrahedra.size() / 4;
    if (const Finding* const first = print_findings(report, quiet))
        throw Error(exit_check_failed,
                    fmt::format("{}: not a Delaunay triangulation of its points: {}: {} "
                                "(--constrained checks other meshes)",
                                name, first->what, first->detail));
    if (!quiet) {
        const bool same = report.in_common == canonical && canonical == mesh.tetrahedron_count();
        fmt::print("{}: a valid Delaunay triangulation, {}\n", name,
                   same
                       ? "the canonical one"
                       : fmt::format("with {} of {} tetrahedra as in the canonical one, the others "
                                     "from cospherical points split in another way",
                                     report.in_common, mesh.tetrahedron_count()));
    }
    return exit_ok;
}

}  // namespace

const Command check_command = {
    "check",
    "Prove that a file holds a Delaunay triangulation of its points, whoever wrote it. Points "
    "alone are triangulated and the result is checked.",
    [](CLI::App& app) -> std::function<int()> {
        const auto options = std::make_shared<CheckOptions>();
        add_input(app, options->input, "Tetrahedra (.vtu, .msh, .ele, .npy) or points");
        app.add_option("--points", options->points,
                       "File of the points, if FILE is an .npy of tetrahedra")
            ->type_name("FILE");
        app.add_option("--index-base", options->index_base,
                       "Number of the first point in that .npy")
            ->check(CLI::IsMember({0, 1}))
            ->type_name("0|1");
        app.add_flag("--constrained", options->is_constrained,
                     "Check a mesh that need not be Delaunay or convex: tetrahedra that meet in "
                     "faces, and a boundary that does not cross itself. Files with triangles "
                     "that are no Delaunay triangulation are checked so, too");
        add_triangulation(app, options->triangulation);
        app.footer(exit_codes());
        return [options] { return check(*options); };
    }};

}  // namespace mgdt::cli
