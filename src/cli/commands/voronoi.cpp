// SPDX-License-Identifier: MIT
// mgdt voronoi: reads points and writes their Voronoi cells, as polyhedra or as a table of
// measures.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "cli/commands/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/help.hpp"
#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/formats/grid.hpp"
#include "cli/periodic_box.hpp"

namespace mgdt::cli {
namespace {

struct VoronoiOptions {
    InputOptions input;
    OutputOptions output;
    std::string table;  // a .csv file of measures, or empty
    RegionOptions region;
    PeriodicOptions periodic;
    double least_area = 0, least_share = 0;  // of faces that are not left out
    TriangulationOptions triangulation;
};

// The arrays of a diagram that the outputs need.
struct Cells {
    explicit Cells(const Voronoi& v)
        : vertices(v.doubles(VoronoiDoubles::vertices)),
          areas(v.doubles(VoronoiDoubles::face_areas)),
          volumes(v.doubles(VoronoiDoubles::cell_volumes)),
          centroids(v.doubles(VoronoiDoubles::cell_centroids)),
          face_offsets(v.array(VoronoiArray::face_offsets)),
          corners(v.array(VoronoiArray::face_corners)),
          sides(v.array(VoronoiArray::face_sides)),
          offsets(v.array(VoronoiArray::cell_offsets)),
          faces(v.array(VoronoiArray::cell_faces)),
          is_bounded(v.array(VoronoiArray::cell_bounded)) {}

    std::size_t count() const { return is_bounded.size(); }
    // Calls take(face) with the faces of a cell.
    template <class Take>
    void each_face(std::size_t cell, const Take& take) const {
        for (auto i = offsets[cell]; i < offsets[cell + 1]; ++i)
            take(static_cast<std::size_t>(faces[static_cast<std::size_t>(i)]));
    }
    double area(std::size_t cell) const {
        double sum = 0;
        each_face(cell, [&](std::size_t face) { sum += areas[face]; });
        return sum;
    }

    std::vector<double> vertices, areas, volumes, centroids;
    std::vector<std::int64_t> face_offsets, corners, sides, offsets, faces, is_bounded;
};

// Collects the cells that are bounded, with the vertices that they use. Cells with fewer vertices
// come first: meshio assigns the measures wrongly otherwise.
class PolyhedraOfCells {
  public:
    explicit PolyhedraOfCells(const Cells& cells)
        : cells_(cells), numbers_(cells.vertices.size() / 3, -1) {
        for (const char* name : {"volume", "area", "faces"})
            polyhedra_.measures.push_back({name, 1, {}});
        std::vector<std::pair<std::size_t, std::size_t>> order;  // number of corners, cell
        for (std::size_t i = 0; i < cells.count(); ++i) {
            const std::vector<std::int64_t> corners = corners_of(i);
            if (cells_.volumes[i] == 0 && corners.empty()) continue;  // the point is no vertex
            if (cells_.offsets[i + 1] - cells_.offsets[i] < 4 && cells_.is_bounded[i] != 0)
                ++without_faces_;
            else if (cells_.is_bounded[i] != 0 && std::all_of(corners.begin(), corners.end(),
                                                              [&](auto c) { return is_finite(c); }))
                order.emplace_back(corners.size(), i);
            else
                ++left_out_;
        }
        std::sort(order.begin(), order.end());
        for (const auto& [size, cell] : order) add(cell);
    }

    Polyhedra& polyhedra() { return polyhedra_; }
    // The number of cells that are unbounded, or have vertices beyond the range of doubles.
    std::size_t left_out() const { return left_out_; }
    // The number of bounded cells of which fewer than four faces are left.
    std::size_t without_faces() const { return without_faces_; }

  private:
    bool is_finite(std::int64_t corner) const {
        const double* x = cells_.vertices.data() + 3 * static_cast<std::size_t>(corner);
        return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
    }
    std::int64_t number_of(std::int64_t vertex) {
        const auto v = static_cast<std::size_t>(vertex);
        if (numbers_[v] < 0) {
            numbers_[v] = static_cast<std::int64_t>(polyhedra_.points.size() / 3);
            for (std::size_t k = 0; k < 3; ++k)
                polyhedra_.points.push_back(cells_.vertices[3 * v + k]);
        }
        return numbers_[v];
    }
    std::vector<std::int64_t> corners_of(std::size_t cell) const {
        std::vector<std::int64_t> all;
        cells_.each_face(cell, [&](std::size_t face) {
            for (auto c = cells_.face_offsets[face]; c < cells_.face_offsets[face + 1]; ++c)
                all.push_back(cells_.corners[static_cast<std::size_t>(c)]);
        });
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }
    void add(std::size_t cell) {
        for (const std::int64_t c : corners_of(cell)) polyhedra_.corners.push_back(number_of(c));
        polyhedra_.offsets.push_back(static_cast<std::int64_t>(polyhedra_.corners.size()));
        polyhedra_.faces.push_back(cells_.offsets[cell + 1] - cells_.offsets[cell]);
        cells_.each_face(cell, [&](std::size_t face) { add_face(cell, face); });
        polyhedra_.face_offsets.push_back(static_cast<std::int64_t>(polyhedra_.faces.size()));
        polyhedra_.ids.push_back(static_cast<std::int64_t>(cell));
        polyhedra_.measures[0].values.push_back(cells_.volumes[cell]);
        polyhedra_.measures[1].values.push_back(cells_.area(cell));
        polyhedra_.measures[2].values.push_back(
            static_cast<double>(cells_.offsets[cell + 1] - cells_.offsets[cell]));
    }
    void add_face(std::size_t cell, std::size_t face) {
        const auto begin = static_cast<std::size_t>(cells_.face_offsets[face]),
                   end = static_cast<std::size_t>(cells_.face_offsets[face + 1]);
        polyhedra_.faces.push_back(static_cast<std::int64_t>(end - begin));
        // The normal points out of the cell of the first side.
        const bool is_first = cells_.sides[2 * face] == static_cast<std::int64_t>(cell);
        for (std::size_t i = 0; i < end - begin; ++i)
            polyhedra_.faces.push_back(
                number_of(cells_.corners[is_first ? begin + i : end - 1 - i]));
    }

    const Cells& cells_;
    std::vector<std::int64_t> numbers_;  // of the vertices in the file, or -1
    Polyhedra polyhedra_;
    std::size_t left_out_ = 0, without_faces_ = 0;
};

// Writes a row for each point, with the neighbours in the last column.
void write_table(const Cells& cells, const std::vector<double>& points, std::int64_t base,
                 OutputFile& out) {
    out.write("point,x,y,z,volume,area,centroid_x,centroid_y,centroid_z,faces,neighbors\n");
    const auto number = [&](double x) {
        out.write(",");
        out.write_number(x);
    };
    for (std::size_t i = 0; i < cells.count(); ++i) {
        out.write_integer(static_cast<std::int64_t>(i) + base);
        for (std::size_t k = 0; k < 3; ++k) number(points[3 * i + k]);
        number(cells.volumes[i]);
        number(cells.area(i));
        for (std::size_t k = 0; k < 3; ++k) number(cells.centroids[3 * i + k]);
        out.write(",");
        out.write_integer(cells.offsets[i + 1] - cells.offsets[i]);
        const char* before = ",";
        if (cells.offsets[i] == cells.offsets[i + 1]) out.write(before);
        cells.each_face(i, [&](std::size_t face) {
            const std::int64_t* side = cells.sides.data() + 2 * face;
            const std::int64_t other = side[side[0] == static_cast<std::int64_t>(i) ? 1 : 0];
            out.write(before);
            out.write_integer(other < 0 ? other : other + base);
            before = " ";
        });
        out.write("\n");
    }
}

Voronoi make_voronoi(const Triangulation& t, const Planes& planes, const std::string& name) {
    try {
        return Voronoi(t, planes);
    } catch (const mgdt::Error& e) {
        if (e.status() == MGDT_ERR_INVALID_ARGUMENT || e.status() == MGDT_ERR_NOT_FINITE)
            throw Error(exit_input, fmt::format("{}: {}", name, e.what()));
        rethrow_failure(name, t.last_error());
    } catch (const OutOfMemory&) {
        rethrow_failure(name, t.last_error());
    }
}

Voronoi diagram_of_points(const VoronoiOptions& options, const Mesh& mesh, const Planes& planes,
                          const std::string& name) {
    Triangulation t = make_triangulation(options.triangulation);
    insert(t, mesh.points, name, options.triangulation.quiet);
    if (t.dimension() < 3 && mesh.point_count() > 0 && planes.empty())
        throw Error(exit_input, fmt::format("{}: {}, so there are no cells", name, shape(t)));
    return make_voronoi(t, planes, name);
}

Voronoi diagram_in_box(const VoronoiOptions& options, const Mesh& mesh, const std::string& name) {
    const Periodic box = make_periodic(options.periodic, options.triangulation, mesh, name);
    try {
        return box.voronoi();
    } catch (const mgdt::Error& e) {
        if (e.status() == MGDT_ERR_INVALID_ARGUMENT)
            throw Error(exit_input, fmt::format("{}: {}", name, e.what()));
        rethrow_failure(name, box.last_error());
    } catch (const OutOfMemory&) {
        rethrow_failure(name, box.last_error());
    }
}

int write_voronoi(const VoronoiOptions& options) {
    const OutputOptions& output = options.output;
    std::vector<std::string> files;
    if (!output.path.empty()) {
        const Format& format = output_format(output.path, output.to);
        if (&format != &vtu_format())
            throw Error(exit_usage, fmt::format("{} ({}) has no place for polyhedra; write .vtu",
                                                format.name, format.description));
        require_compressible(output.write, format);
        check_terminal(output, format);
        files.push_back(output.path);
    } else if (options.table.empty()) {
        throw Error(exit_usage, "nothing to do; say where to write with -o or with --csv");
    } else if (output.write.compress || !output.to.empty()) {
        throw Error(exit_usage, "--compress and --to are for the polyhedra, which -o writes");
    }
    if (!options.table.empty()) {
        if (options.table == output.path)
            throw Error(exit_usage, "-o and --csv name the same file");
        files.push_back(options.table);
    }
    for (const std::string& file : files) check_writable(file);
    std::FILE* text = output.path == "-" || options.table == "-" ? stderr : stdout;

    if (options.periodic.is_periodic() &&
        (!options.region.bounds.empty() || !options.region.planes.empty()))
        throw Error(exit_usage, "--box excludes --bounds and --planes");

    auto [mesh, name] = open_input(options.input, files, options.triangulation.quiet);
    const Planes planes = planes_of(options.region, mesh.points, mesh.inputs);
    require_apart(mesh.inputs, files);
    Voronoi diagram = options.periodic.is_periodic()
                          ? diagram_in_box(options, mesh, name)
                          : diagram_of_points(options, mesh, planes, name);
    if (options.least_area > 0 || options.least_share > 0)
        diagram.drop_small_faces(options.least_area, options.least_share);
    const Cells cells(diagram);
    diagram = Voronoi(nullptr);

    OutputSet outputs;
    if (!options.table.empty())
        write_table(cells, mesh.points, output.write.index_base, outputs.open(options.table));
    std::size_t left_out = 0, without_faces = 0, written = 0;
    if (!output.path.empty()) {
        PolyhedraOfCells made(cells);
        left_out = made.left_out();
        without_faces = made.without_faces();
        written = made.polyhedra().offsets.size();
        made.polyhedra().is_compressed = output.write.compress;
        for (std::int64_t& id : made.polyhedra().ids) id += output.write.index_base;
        write_polyhedra(made.polyhedra(), outputs.open(output.path));
    }
    outputs.commit();
    if (options.triangulation.quiet) return exit_ok;
    if (left_out > 0)
        fmt::print(stderr, "mgdt: {}: {} unbounded and left out; clip with --bounds\n", name,
                   left_out == 1 ? "1 cell is" : fmt::format("{} cells are", left_out));
    if (without_faces > 0)
        fmt::print(stderr, "mgdt: {}: {} fewer than four faces and {} left out\n", name,
                   without_faces == 1 ? "1 cell has" : fmt::format("{} cells have", without_faces),
                   without_faces == 1 ? "is" : "are");
    if (text == stdout && !output.path.empty())
        fmt::print("{}, {}, {}: {}\n", counted(mesh.point_count(), "point", "points"),
                   counted(written, "cell", "cells"), counted(cells.areas.size(), "face", "faces"),
                   printable(output.path));
    return exit_ok;
}

}  // namespace

const Command voronoi_command = {
    "voronoi", "Read points, write their Voronoi cells.",
    [](CLI::App& app) -> std::function<int()> {
        const auto options = std::make_shared<VoronoiOptions>();
        add_input(app, options->input, "Points; - for standard input");
        add_output(app, options->output, false);
        add_index_base(app, options->output);
        add_compress(app, options->output);
        app.add_option("--csv", options->table,
                       "Write a table too, with volume, area, centroid and neighbours of each cell")
            ->type_name("FILE");
        add_region(app, options->region);
        add_periodic(app, options->periodic);
        app.add_option("--least-area", options->least_area, "Leave out faces of less area")
            ->check(number_between(0, std::numeric_limits<double>::max()))
            ->type_name("A");
        app.add_option(
               "--least-share", options->least_share,
               "Leave out faces with less than this share of the area of each of their cells")
            ->check(number_between(0, 0.999999))
            ->type_name("X");
        add_triangulation(app, options->triangulation);
        app.footer(formats_and_exit_codes);
        return [options] { return write_voronoi(*options); };
    }};

}  // namespace mgdt::cli
