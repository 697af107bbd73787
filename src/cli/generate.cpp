// SPDX-License-Identifier: MIT
// mgdt generate: points of a named distribution.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/errors.hpp"

namespace mgdt::cli {
std::size_t parse_point_count(const std::string& name, const std::string& text) {
    double value = -1;
    const char* last = text.data() + text.size();
    const auto result = std::from_chars(text.data(), last, value);
    if (result.ec != std::errc() || result.ptr != last || !(value >= 0) || value > 1e15 ||
        value != std::floor(value)) {
        throw Error(exit_usage,
                    fmt::format("{} is {}; a number of points such as 1000 or 1e6 is needed", name,
                                quote(text)));
    }
    return static_cast<std::size_t>(value);
}

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
        fmt::print("{}: {}\n", counted(points.size() / 3, "point", "points"), output.path);
    }
    return exit_ok;
}

}  // namespace mgdt::cli
