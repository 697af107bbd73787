// SPDX-License-Identifier: MIT
// mgdt check: checks whether a file holds a Delaunay triangulation.
#include <fmt/core.h>

#include <cstdio>

#include "cli/commands.hpp"
#include "cli/errors.hpp"
#include "cli/formats/mid_side_nodes.hpp"
#include "cli/mesh_check.hpp"

namespace mgdt::cli {
namespace {

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

}  // namespace

int check(const CheckOptions& options) {
    const bool quiet = options.triangulation.quiet;
    const std::string name = input_name(options.input.path);
    const Format* format = nullptr;
    const bool pair = !options.points.empty();
    const Mesh mesh = pair ? read_pair(options) : read_input(options.input, &format);
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
    const MeshReport report = check_mesh(mesh, reference);
    const std::size_t canonical = reference.tetrahedra.size() / 4;
    if (!quiet) {
        for (const Finding& f : report.findings) print(f.what, f.good, f.detail);
    }
    if (!report.valid) {
        std::string first;
        for (const Finding& f : report.findings) {
            if (!f.good && first.empty()) first = fmt::format("{}: {}", f.what, f.detail);
        }
        throw Error(exit_check_failed,
                    fmt::format("{}: not a Delaunay triangulation of its points: {}", name, first));
    }
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

}  // namespace mgdt::cli
