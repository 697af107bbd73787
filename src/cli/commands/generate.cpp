// SPDX-License-Identifier: MIT
// mgdt generate: points of a named distribution.
#include <fmt/core.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <stdexcept>

#include "cli/commands/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/help.hpp"
#include "cli/counts.hpp"
#include "cli/data_directory.hpp"
#include "cli/errors.hpp"
#include "cli/point_sets/distributions.hpp"

namespace mgdt::cli {
namespace {

struct GenerateCommandOptions {
    std::string kind;
    std::string count;
    OutputOptions output;
    GenerateOptions generate;
    bool quiet = false;
};

std::string kinds() {
    std::string text = "Kinds:\n";
    for (const Distribution& d : distributions()) {
        text += fmt::format("  {:<16} {}\n", d.name, d.description);
    }
    return text;
}

int generate_points(const GenerateCommandOptions& options) {
    const OutputOptions& output = options.output;
    const std::size_t count = parse_point_count("N", options.count);
    const Format& format = points_format(output);
    check_writable(output.path);
    require_apart(data_files({options.kind}, options.generate.data_directory), {output.path});
    std::vector<double> points;
    try {
        points = generate(options.kind, count, options.generate);
    } catch (const std::invalid_argument& e) {
        throw Error(exit_usage, e.what());
    } catch (const std::runtime_error& e) {
        throw Error(exit_input, fmt::format("{}; say where they are with --data", e.what()));
    }
    OutputSet outputs;
    format.write_points(points, outputs.open(output.path), output.write);
    outputs.commit();
    if (!options.quiet && output.path != "-") {
        fmt::print("{}: {}\n", counted(points.size() / 3, "point", "points"),
                   printable(output.path));
    }
    return exit_ok;
}

}  // namespace

const Command generate_command = {
    "generate", "Write points of a distribution.", [](CLI::App& app) -> std::function<int()> {
        const auto options = std::make_shared<GenerateCommandOptions>();
        options->generate.data_directory = default_data_directory();
        app.add_option("kind", options->kind, "Kind of distribution, see below")
            ->required()
            ->type_name("KIND");
        app.add_option("count", options->count, "Number of points, such as 1000 or 1e6")
            ->required()
            ->type_name("N");
        add_output(app, options->output, true);
        add_index_base(app, options->output);
        app.add_option("--seed", options->generate.seed, "Seed (default 1)")->type_name("N");
        app.add_option("--width", options->generate.width, "Width of the spread about curves")
            ->check(CLI::NonNegativeNumber)
            ->type_name("W");
        app.add_option("--power", options->generate.power, "Power of the crowding in clusters")
            ->check(CLI::NonNegativeNumber)
            ->type_name("P");
        app.add_option("--scale", options->generate.scale, "Factor of all coordinates")
            ->type_name("S");
        app.add_option("--data", options->generate.data_directory,
                       "Where machine.msh and church.msh are")
            ->envname("MGDT_DATA")
            ->type_name("DIR");
        app.add_flag("-q,--quiet", options->quiet, "Print nothing but errors");
        app.footer(kinds() + "\n" + exit_codes());
        return [options] { return generate_points(*options); };
    }};

}  // namespace mgdt::cli
