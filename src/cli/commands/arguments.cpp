// SPDX-License-Identifier: MIT
#include "cli/commands/arguments.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "cli/errors.hpp"
#include "cli/formats/number.hpp"

namespace mgdt::cli {
namespace {

std::string schemes() {
    return fmt::format("{}", fmt::join(scheme_names(), ", "));
}

CLI::Validator not_empty() {
    return CLI::Validator(
        [](std::string& text) -> std::string { return text.empty() ? "it is empty" : ""; }, "");
}

}  // namespace

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

void add_limits(CLI::App& app, int& threads, std::uint64_t& memory_limit, const char* memory) {
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

void add_cleaning(CLI::App& app, CleanOptions& options) {
    constexpr double most = 0.0999;
    app.add_flag("--clean", options.clean,
                 "Mend the surface where that takes no new points: repeated, collapsed and equal "
                 "facets, points and edges in facets");
    app.add_option("--weld", options.weld,
                   "Clean, and take places within this share of the surface's size for one")
        ->type_name("X")
        ->check(number_between(0, most));
    app.add_option(
           "--flat", options.flat,
           "Clean, and take facets within this share of the size of one plane for facets in "
           "it, whose common edges may be exchanged")
        ->type_name("X")
        ->check(number_between(0, most));
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

void add_facets_input(CLI::App& app, InputOptions& options) {
    app.add_option("input", options.path, "Surface; - for standard input")
        ->required()
        ->type_name("FILE");
    app.add_option("--from", options.from, "Format of the input")->type_name("FORMAT");
}

}  // namespace mgdt::cli
