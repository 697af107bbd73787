// SPDX-License-Identifier: MIT
#include "cli/region.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "cli/errors.hpp"
#include "cli/formats/lines.hpp"
#include "cli/formats/number.hpp"
#include "cli/input_file.hpp"

namespace mgdt::cli {
namespace {

using Box = std::array<double, 6>;  // the least coordinates, then the largest

Box box_around(const std::vector<double>& points) {
    constexpr double most = std::numeric_limits<double>::max();
    Box box = {most, most, most, -most, -most, -most};
    for (std::size_t i = 0; i < points.size(); ++i) {
        box[i % 3] = std::min(box[i % 3], points[i]);
        box[3 + i % 3] = std::max(box[3 + i % 3], points[i]);
    }
    return points.empty() ? Box{} : box;
}

Box parse_bounds(const std::string& text) {
    Box box;
    std::string_view rest = text;
    for (std::size_t i = 0; i < 6; ++i) {
        const std::size_t comma = i < 5 ? rest.find(',') : rest.size();
        if (comma == std::string_view::npos ||
            parse_number(rest.substr(0, comma), box[i]) != NumberStatus::ok) {
            throw Error(exit_usage,
                        fmt::format("--bounds is {}; the least x,y,z and the largest x,y,z are "
                                    "needed, six numbers with commas between them, or auto",
                                    quote(text)));
        }
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    for (std::size_t k = 0; k < 3; ++k) {
        if (box[k] < box[3 + k]) continue;
        throw Error(exit_usage, fmt::format("--bounds: the largest {} is {}, and the least {}",
                                            "xyz"[k], box[3 + k], box[k]));
    }
    return box;
}

Planes planes_of_box(const Box& box) {
    Planes planes;
    for (std::size_t k = 0; k < 3; ++k) {
        planes.push_back({0, 0, 0, -box[k]});
        planes.back()[k] = -1;
        planes.push_back({0, 0, 0, box[3 + k]});
        planes.back()[k] = 1;
    }
    return planes;
}

Planes read_planes(const std::string& path, std::vector<FileIdentity>& inputs) {
    const InputFile file(path);
    if (file.identity()) inputs.push_back(*file.identity());
    const Source source = file.source();
    LineReader lines(source);
    Planes planes;
    while (lines.next_with_text()) {
        Fields fields(lines);
        for (double& x : planes.emplace_back()) x = fields.number("number of a plane a b c d");
        std::string_view word;
        if (fields.next(word))
            lines.fail(fmt::format("{} after the four numbers a b c d of a plane", quote(word)));
    }
    if (planes.empty()) source.fail("has no planes, which are lines of four numbers a b c d");
    return planes;
}

}  // namespace

Planes planes_of(const RegionOptions& options, const std::vector<double>& points,
                 std::vector<FileIdentity>& inputs) {
    if (!options.planes.empty()) return read_planes(options.planes, inputs);
    if (options.bounds.empty()) return {};
    return planes_of_box(options.bounds == "auto" ? box_around(points)
                                                  : parse_bounds(options.bounds));
}

}  // namespace mgdt::cli
