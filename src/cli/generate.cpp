// SPDX-License-Identifier: MIT
// mgdt generate: points of a named distribution.
#include <fmt/core.h>

#include <cstdio>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/errors.hpp"

namespace mgdt::cli {

int generate_points(const GenerateCommandOptions& options) {
    const OutputOptions& output = options.output;
    const std::size_t count = parse_point_count("N", options.count);
    const Format& format = output_format(output.path, output.to);
    if (!format.write_points) {
        throw Error(exit_usage, fmt::format("{} ({}) is not for points alone; write .npy, .xyz, "
                                            ".csv, .f64, .ply or .node",
                                            format.name, format.description));
    }
    check_terminal(output, format);
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

}  // namespace mgdt::cli
