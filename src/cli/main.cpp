// SPDX-License-Identifier: MIT
// The program mgdt: exact 3D Delaunay triangulation from the command line.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <limits>
#include <new>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/data_directory.hpp"
#include "cli/errors.hpp"
#include "cli/formats/number.hpp"
#include "cli/interrupt.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {
namespace {

const char* const exit_codes =
    "Exit codes:\n"
    "  0    success\n"
    "  1    a check failed: not a valid Delaunay triangulation\n"
    "  2    wrong usage\n"
    "  3    an input cannot be read or is malformed\n"
    "  4    an output cannot be written; no partial file is left\n"
    "  5    out of memory, or too large\n"
    "  6    a defect in mgdt\n"
    "  7    nothing to check: a mesh of other cells than tetrahedra\n"
    "  130  cancelled by Ctrl-C (in general 128 + the signal's number)";

std::string formats_footer() {
    std::string text = "Formats (chosen by extension, or with --from and --to):\n";
    for (const Format* f : all_formats()) {
        const std::string extensions = fmt::format("{}", fmt::join(f->extensions, " "));
        const std::string does =
            fmt::format("{}{}{}{}{}", f->read ? "read" : "", f->write_points ? ", points" : "",
                        f->write_mesh ? ", tetrahedra" : "", f->write_fields ? ", values" : "",
                        f->write_surface ? ", triangles" : "");
        text += fmt::format("  {:<8} {:<25} {} [{}]\n", f->name, extensions, f->description, does);
    }
    return text +
           "  [points, tetrahedra, values, triangles: what can be written; values are read too]\n";
}

std::string kinds_footer() {
    std::string text = "Kinds:\n";
    for (const Distribution& d : distributions()) {
        text += fmt::format("  {:<16} {}\n", d.name, d.description);
    }
    return text;
}

std::string schemes() {
    return fmt::format("{}", fmt::join(scheme_names(), ", "));
}

// Like CLI::Range, but refuses nan.
CLI::Validator number_between(double low, double high) {
    return CLI::Validator(
        [low, high](std::string& text) -> std::string {
            double x = 0;
            if (parse_number(text, x) == NumberStatus::ok && x >= low && x <= high) return "";
            return fmt::format("{} is not a number from {} to {}", quote(text), low, high);
        },
        "");
}

void add_columns(CLI::App& app, const char* option, InputOptions& options, const char* whose) {
    options.read.columns_option = option;
    app.add_option_function<std::vector<int>>(
           option,
           [&options](const std::vector<int>& c) {
               options.read.columns = {{c[0], c[1], c[2]}};
           },
           fmt::format("Columns of x, y and z in {}, counted from 1 (default: those with these "
                       "names, or all three)",
                       whose))
        ->delimiter(',')
        ->expected(3)
        ->check(CLI::Range(1, 10000))
        ->type_name("I,J,K");
}

void add_input(CLI::App& app, InputOptions& options, const char* description) {
    app.add_option("input", options.path, description)->required()->type_name("FILE");
    app.add_option("--from", options.from, "Format of the input")->type_name("FORMAT");
    app.add_flag("--allow-empty", options.allow_empty,
                 "Take an input without any text or bytes as no points");
    add_columns(app, "--columns", options, "text");
}

void add_output(CLI::App& app, OutputOptions& options, bool required) {
    app.add_option("-o,--output", options.path, "File to write; - for standard output")
        ->required(required)
        ->type_name("FILE");
    app.add_option("--to", options.to, "Format of the output")->type_name("FORMAT");
}

void add_index_base(CLI::App& app, OutputOptions& options) {
    app.add_option_function<int>(
           "--index-base",
           [&options](int base) {
               options.write.index_base = base;
               options.write.is_base_chosen = true;
           },
           "Number of the first point and tetrahedron in .npy and TetGen files (default 0, or that "
           "of a TetGen input)")
        ->check(CLI::IsMember({0, 1}))
        ->type_name("0|1");
}

void add_compress(CLI::App& app, OutputOptions& options) {
    app.add_flag("--compress", options.write.compress, "Compress .vtu and .vtp files");
}

void add_limits(CLI::App& app, int& threads, std::uint64_t& memory_limit,
                const char* memory = "Most memory, such as 500MB or 4GB") {
    app.add_option("--threads", threads, "Threads; 0 for all cores (default 1)")
        ->check(CLI::Range(0, 1 << 20))
        ->type_name("N");
    app.add_option("--memory-limit", memory_limit, memory)
        ->transform(CLI::AsSizeValue(false))
        ->type_name("SIZE");
}

void add_triangulation(CLI::App& app, TriangulationOptions& options) {
    app.add_option("--scheme", options.scheme, "Order of insertion: " + schemes())
        ->type_name("NAME");
    add_limits(app, options.threads, options.memory_limit,
               "Most memory of the triangulation, such as 500MB or 4GB");
    app.add_flag("--compact", options.compact,
                 "Three tenths less memory for the triangulation, in 20 to 40 percent more time");
    app.add_flag("-q,--quiet", options.quiet, "Print nothing but errors and what is asked for");
}

CLI::Validator not_empty() {
    return CLI::Validator(
        [](std::string& text) -> std::string { return text.empty() ? "it is empty" : ""; }, "");
}

void add_periodic(CLI::App& app, PeriodicOptions& options) {
    CLI::Option* box =
        app.add_option("--box", options.box,
                       "Periodic box: 'a b c', the nine numbers of three vectors, or file for the "
                       "box that the file has")
            ->check(not_empty())
            ->type_name("BOX");
    app.add_option(
           "--periodic", options.directions,
           "Which vectors of the box repeat, such as xy (default: all, or those of the file)")
        ->needs(box)
        ->check(not_empty())
        ->type_name("XYZ");
}

void add_region(CLI::App& app, RegionOptions& options) {
    CLI::Option* box =
        app.add_option(
               "--bounds", options.bounds,
               "Bounds of the cells: least x,y,z and largest x,y,z; or auto for the points'")
            ->check(not_empty())
            ->type_name("BOX");
    app.add_option("--planes", options.planes,
                   "File of the planes that bound the cells: a line a b c d for each, where "
                   "a x + b y + c z <= d")
        ->excludes(box)
        ->check(not_empty())
        ->type_name("FILE");
}

void add_scheme_parameters(CLI::App& app, TriangulationOptions& options) {
    app.add_option("--seed", options.seed, "Seed of the schemes that shuffle (default 0)")
        ->type_name("N");
    app.add_option("--points-per-cell", options.points_per_cell, "Mean points in a cell")
        ->type_name("X");
    app.add_option("--threshold", options.threshold, "Points beyond which a cell gets its own grid")
        ->type_name("X");
    app.add_option("--separation", options.separation,
                   "0: cell after cell, 1: one point from a cell at a time, 2: in rounds")
        ->type_name("0|1|2");
    app.add_option("--round-ratio", options.round_ratio, "Growth of the rounds")->type_name("X");
}

void add_interpolate(CLI::App& app, InterpolateOptions& options) {
    app.add_option("samples", options.samples.path, "Points with values; - for standard input")
        ->required()
        ->type_name("FILE");
    app.add_option("places", options.places.path, "Places, or a mesh whose nodes are meant")
        ->required()
        ->type_name("FILE");
    add_output(app, options.output, true);
    add_compress(app, options.output);
    app.add_option("--method", options.method, "Way to a value (default linear)")
        ->check(CLI::IsMember(interpolation_methods()))
        ->type_name("NAME");
    app.add_option("--outside", options.outside,
                   "Value outside the convex hull (default none, which is nan)")
        ->check(CLI::IsMember(interpolation_outsides()))
        ->type_name("NAME");
    CLI::Option* fields =
        app.add_option("--fields", options.fields, "Names of the fields (default: all of numbers)")
            ->delimiter(',')
            ->type_name("LIST");
    app.add_option("--values", options.values, "File of the values, an .npy with a row to a sample")
        ->excludes(fields)
        ->type_name("FILE");
    app.add_option("--from", options.samples.from, "Format of the samples")->type_name("FORMAT");
    add_columns(app, "--columns", options.samples, "the text of samples");
    app.add_option("--places-from", options.places.from, "Format of the places")
        ->type_name("FORMAT");
    add_columns(app, "--places-columns", options.places, "the text of places");
    add_triangulation(app, options.triangulation);
    app.footer(formats_footer() + "\n" + exit_codes);
}

// CLI11 would only report that a command is missing.
void require_command(const CLI::App& app, const std::string& name) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->get_name() == name) return;
        names.push_back(command->get_name());
    }
    if (name == "bench")
        throw Error(exit_usage, "there is no command bench; it is the program mgdt-bench");
    throw Error(exit_usage, fmt::format("unknown command {}; it is one of {}; see mgdt --help",
                                        quote(name), fmt::join(names, ", ")));
}

void add_voronoi(CLI::App& app, VoronoiOptions& options) {
    add_input(app, options.input, "Points; - for standard input");
    add_output(app, options.output, false);
    add_index_base(app, options.output);
    add_compress(app, options.output);
    app.add_option("--csv", options.table,
                   "Write a table too, with volume, area, centroid and neighbours of each cell")
        ->type_name("FILE");
    add_region(app, options.region);
    add_periodic(app, options.periodic);
    app.add_option("--least-area", options.least_area, "Leave out faces of less area")
        ->check(number_between(0, std::numeric_limits<double>::max()))
        ->type_name("A");
    app.add_option("--least-share", options.least_share,
                   "Leave out faces with less than this share of the area of each of their cells")
        ->check(number_between(0, 0.999999))
        ->type_name("X");
    add_triangulation(app, options.triangulation);
    app.footer(formats_footer() + "\n" + exit_codes);
}

void add_surface(CLI::App& app, SurfaceOptions& options) {
    add_input(app, options.input, "Points; - for standard input");
    add_output(app, options.output, true);
    add_compress(app, options.output);
    app.add_option("--alpha", options.alpha,
                   "Radius of the largest gap that is filled; or auto for the least one that gives "
                   "one solid with all points (default auto)")
        ->type_name("R");
    app.add_flag("--largest", options.largest, "Write the solid of largest volume only");
    add_triangulation(app, options.triangulation);
    app.footer(formats_footer() + "\n" + exit_codes);
}

void add_hull(CLI::App& app, HullOptions& options) {
    add_input(app, options.input, "Points; - for standard input");
    add_output(app, options.output, true);
    add_compress(app, options.output);
    add_triangulation(app, options.triangulation);
    app.footer(formats_footer() + "\n" + exit_codes);
}

void add_relax(CLI::App& app, RelaxOptions& options) {
    add_input(app, options.input, "Points; - for standard input");
    add_output(app, options.output, true);
    add_index_base(app, options.output);
    app.add_option("--steps", options.steps, "Number of steps")
        ->required()
        ->check(CLI::Range(0, 1000000))
        ->type_name("N");
    add_region(app, options.region);
    add_triangulation(app, options.triangulation);
    app.footer(formats_footer() + "\n" + exit_codes);
}

void add_facets_input(CLI::App& app, InputOptions& options) {
    app.add_option("input", options.path, "Surface; - for standard input")
        ->required()
        ->type_name("FILE");
    app.add_option("--from", options.from, "Format of the input")->type_name("FORMAT");
}

void add_mesh(CLI::App& app, MeshOptions& options) {
    add_facets_input(app, options.input);
    add_output(app, options.output, true);
    add_index_base(app, options.output);
    add_compress(app, options.output);
    app.add_option("--hole", options.holes,
                   "Leave what facets enclose around this place empty; may be repeated")
        ->delimiter(',')
        ->type_name("X,Y,Z");
    app.add_option("--region", options.regions,
                   "Give the tetrahedra around this place a marker; may be repeated")
        ->delimiter(',')
        ->type_name("X,Y,Z,N");
    app.add_flag("--check", options.check, "Prove the mesh before writing");
    app.add_flag("--rounded", options.rounded,
                 "Write points rounded to 2^-36 of the largest coordinate, so that facets are "
                 "covered exactly");
    app.add_flag("--strict", options.strict,
                 "Refuse a mesh that leaves out facets, points, regions or holes");
    app.add_flag("--all-points", options.all_points,
                 "Also write points that are in no tetrahedron");
    add_limits(app, options.threads, options.memory_limit);
    app.add_flag("-q,--quiet", options.quiet, "Print nothing but errors");
    app.footer(formats_footer() + "\n" + exit_codes);
}

void add_validate(CLI::App& app, ValidateOptions& options) {
    add_facets_input(app, options.input);
    app.add_option("-o,--output", options.output.path,
                   "Write what offends too, as .vtp for ParaView")
        ->type_name("FILE");
    add_compress(app, options.output);
    add_limits(app, options.threads, options.memory_limit);
    app.add_flag("-q,--quiet", options.quiet, "Print nothing but errors");
    app.footer(formats_footer() + "\n" + exit_codes);
}

int run(const std::vector<std::string>& words) {
    CLI::App app("Exact 3D Delaunay triangulation of any set of points.", "mgdt");
    app.set_version_flag(
        "--version", fmt::format("mgdt {} (ABI {})", mgdt_version_string(), mgdt_abi_version()));
    app.require_subcommand(1);
    app.allow_windows_style_options(false);  // /name is a file
    app.footer(formats_footer() + "\n" + exit_codes +
               "\n\nExample:\n  mgdt generate galaxy 1e5 -o points.npy\n"
               "  mgdt triangulate points.npy -o mesh.vtu --stats\n  mgdt check mesh.vtu");
    app.get_formatter()->column_width(28);

    TriangulateOptions t;
    CLI::App* triangulate_app = app.add_subcommand(
        "triangulate", "Read points, write the tetrahedra of their Delaunay triangulation.");
    add_input(*triangulate_app, t.input, "Points; - for standard input");
    add_output(*triangulate_app, t.output, false);
    add_index_base(*triangulate_app, t.output);
    add_compress(*triangulate_app, t.output);
    add_triangulation(*triangulate_app, t.triangulation);
    add_scheme_parameters(*triangulate_app, t.triangulation);
    triangulate_app->add_option("--neighbors", t.neighbors, "Write the neighbours too, as .npy")
        ->type_name("FILE");
    triangulate_app
        ->add_option("--point-map", t.point_map,
                     "Write for each point the number of the one that stands for it, as .npy")
        ->type_name("FILE");
    triangulate_app->add_flag("--all-points", t.all_points,
                              "Write points too that are in no tetrahedron, such as repeats");
    triangulate_app->add_flag("--canonical", t.triangulation.canonical,
                              "Sort the tetrahedra, so that the file depends on the points alone");
    triangulate_app
        ->add_option("--check", t.check_level,
                     "Prove the result before writing: 1 combinatorial, 2 geometric, 3 canonical")
        ->check(CLI::Range(1, 3))
        ->type_name("LEVEL");
    add_periodic(*triangulate_app, t.periodic);
    triangulate_app
        ->add_option("--images", t.images,
                     "Write a table of the images that are nodes: node, point and offset of each")
        ->type_name("FILE");
    triangulate_app
        ->add_option("--drop-flat", t.drop_flat,
                     "Take tetrahedra off the hull whose radius ratio is less, such as 1e-9, one "
                     "layer after another")
        ->check(number_between(0, 1))
        ->type_name("RATIO");
    triangulate_app->add_flag("--stats", t.statistics, "Print counts and times");
    triangulate_app
        ->add_option("--parts", t.parts,
                     "Triangulate in so many parts, one in memory at a time; writes FILE.pvtu and "
                     "a .vtu file for each")
        ->check(CLI::Range(1, 1 << 20))
        ->type_name("N");
    triangulate_app->footer(formats_footer() + "\n" + exit_codes);

    GenerateCommandOptions g;
    g.generate.data_directory = default_data_directory();
    CLI::App* generate_app = app.add_subcommand("generate", "Write points of a distribution.");
    generate_app->add_option("kind", g.kind, "Kind of distribution, see below")
        ->required()
        ->type_name("KIND");
    generate_app->add_option("count", g.count, "Number of points, such as 1000 or 1e6")
        ->required()
        ->type_name("N");
    add_output(*generate_app, g.output, true);
    add_index_base(*generate_app, g.output);
    generate_app->add_option("--seed", g.generate.seed, "Seed (default 1)")->type_name("N");
    generate_app->add_option("--width", g.generate.width, "Width of the spread about curves")
        ->check(CLI::NonNegativeNumber)
        ->type_name("W");
    generate_app->add_option("--power", g.generate.power, "Power of the crowding in clusters")
        ->check(CLI::NonNegativeNumber)
        ->type_name("P");
    generate_app->add_option("--scale", g.generate.scale, "Factor of all coordinates")
        ->type_name("S");
    generate_app
        ->add_option("--data", g.generate.data_directory, "Where machine.msh and church.msh are")
        ->envname("MGDT_DATA")
        ->type_name("DIR");
    generate_app->add_flag("-q,--quiet", g.quiet, "Print nothing but errors");
    generate_app->footer(kinds_footer() + "\n" + exit_codes);

    CheckOptions c;
    CLI::App* check_app = app.add_subcommand(
        "check",
        "Prove that a file holds a Delaunay triangulation of its points, whoever wrote it. Points "
        "alone are triangulated and the result is checked.");
    add_input(*check_app, c.input, "Tetrahedra (.vtu, .msh, .ele, .npy) or points");
    check_app
        ->add_option("--points", c.points, "File of the points, if FILE is an .npy of tetrahedra")
        ->type_name("FILE");
    check_app->add_option("--index-base", c.index_base, "Number of the first point in that .npy")
        ->check(CLI::IsMember({0, 1}))
        ->type_name("0|1");
    check_app->add_flag("--constrained", c.is_constrained,
                        "Check a mesh that need not be Delaunay or convex: tetrahedra that meet in "
                        "faces, and a boundary that does not cross itself. Files with triangles "
                        "that are no Delaunay triangulation are checked so, too");
    add_triangulation(*check_app, c.triangulation);
    check_app->footer(exit_codes);

    InputOptions i;
    CLI::App* info_app = app.add_subcommand(
        "info", "Print what is in a file: format, counts, duplicates, dimension, extent.");
    add_input(*info_app, i, "Points or tetrahedra");
    info_app->footer(exit_codes);

    InterpolateOptions v;
    CLI::App* interpolate_app =
        app.add_subcommand("interpolate", "Read values at points, write values at other places.");
    add_interpolate(*interpolate_app, v);

    VoronoiOptions d;
    CLI::App* voronoi_app =
        app.add_subcommand("voronoi", "Read points, write their Voronoi cells.");
    add_voronoi(*voronoi_app, d);

    SurfaceOptions s;
    CLI::App* surface_app =
        app.add_subcommand("surface", "Read points, write the surface of their alpha shape.");
    add_surface(*surface_app, s);

    HullOptions h;
    CLI::App* hull_app =
        app.add_subcommand("hull", "Read points, write the surface of their convex hull.");
    add_hull(*hull_app, h);

    RelaxOptions r;
    CLI::App* relax_app = app.add_subcommand(
        "relax", "Read points, move them to the centroids of their cells, write them.");
    add_relax(*relax_app, r);

    MeshOptions m;
    CLI::App* mesh_app =
        app.add_subcommand("mesh", "Read a closed surface, write tetrahedra that fill it.");
    add_mesh(*mesh_app, m);

    ValidateOptions a;
    CLI::App* validate_app = app.add_subcommand(
        "validate", "Read a surface, list all facets that cross or touch where they must not.");
    add_validate(*validate_app, a);

    if (words.size() > 1 && words[1].substr(0, 1) != "-") require_command(app, words[1]);
    try {
        // CLI11 takes arguments in reverse order.
        app.parse(std::vector<std::string>(words.rbegin(), words.rend() - (words.empty() ? 0 : 1)));
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
        const CLI::App* at = &app;
        while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
        const std::string command = at == &app ? "mgdt" : "mgdt " + at->get_name();
        throw Error(exit_usage, fmt::format("{}; see {} --help", e.what(), command));
    }
    if (*triangulate_app) return triangulate(t);
    if (*generate_app) return generate_points(g);
    if (*check_app) return check(c);
    if (*interpolate_app) return interpolate(v);
    if (*voronoi_app) return write_voronoi(d);
    if (*surface_app) return write_alpha_surface(s);
    if (*hull_app) return write_hull(h);
    if (*relax_app) return relax(r);
    if (*mesh_app) return mesh_surface(m);
    if (*validate_app) return validate_surface(a);
    return info(i);
}

}  // namespace
}  // namespace mgdt::cli

int main(int argc, char** argv) {
    using namespace mgdt::cli;
    try {
        install_signal_handlers();
        const int code = run(system::arguments(argc, argv));
        // Reports what could not be written to standard output.
        if (std::fflush(stdout) != 0) throw Error(exit_output, "standard output: cannot write");
        return code;
    } catch (...) {
        return report_exception(stderr);
    }
}
