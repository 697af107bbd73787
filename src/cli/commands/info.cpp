// SPDX-License-Identifier: MIT
// mgdt info: prints what a file holds.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numeric>

#include "cli/commands/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/help.hpp"
#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/mesh_program.hpp"
#include "predicates/predicates.hpp"

namespace mgdt::cli {
namespace {

// The exact dimension of the affine hull: each point off the current hull extends it.
int dimension(const std::vector<double>& points) {
    const std::size_t n = points.size() / 3;
    const auto p = [&](std::size_t i) { return points.data() + 3 * i; };
    std::size_t i = 1;
    if (n == 0) return -1;
    while (i < n && compare_lexicographic(p(0), p(i)) == 0) ++i;
    if (i == n) return 0;
    const std::size_t b = i;
    while (i < n && collinear(p(0), p(b), p(i))) ++i;
    if (i == n) return 1;
    const std::size_t c = i;
    while (i < n && orientation(p(0), p(b), p(c), p(i)) == 0) ++i;
    return i == n ? 2 : 3;
}

std::size_t duplicates(const std::vector<double>& points) {
    std::vector<std::size_t> order(points.size() / 3);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto compare = [&](std::size_t a, std::size_t b) {
        return compare_lexicographic(points.data() + 3 * a, points.data() + 3 * b);
    };
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return compare(a, b) < 0; });
    std::size_t count = 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (compare(order[i - 1], order[i]) == 0) ++count;
    }
    return count;
}

// Prints the shapes of the tetrahedra, if they are a mesh.
template <class Line>
void print_shapes(const Mesh& mesh, const std::string& name, const Line& line) {
    mgdt::ShapeSummary shapes;
    try {
        Mesh bare;
        bare.points = mesh.points;
        bare.tetrahedra = mesh.tetrahedra;
        shapes = make_mesh(bare, 1, 0, name).shape_summary();
    } catch (const Error& e) {
        line("no mesh", e.what());
        return;
    }
    line("angles",
         fmt::format("{:.4g} to {:.4g} degrees", shapes.least_angle, shapes.largest_angle));
    line("mean shape", fmt::format("{:.3f}", shapes.mean_volume_length));
    for (std::size_t i = 0; i < shapes.angles.size(); ++i) {
        const double share = static_cast<double>(shapes.angles[i]) /
                             static_cast<double>(6 * mesh.tetrahedron_count());
        const auto bar = static_cast<std::size_t>(std::lround(60 * share));
        line(fmt::format("{:>4} to {}", 10 * i, 10 * (i + 1)).c_str(),
             fmt::format("{:>5.1f} % {}", 100 * share, std::string(bar, '#')));
    }
}

int info(const InputOptions& options) {
    const Format* format = nullptr;
    const Mesh mesh = read_input(options, &format);
    const auto line = [](const char* name, const std::string& value) {
        fmt::print("{:<14} {}\n", name, printable(value));
    };
    line("file", input_name(options.path));
    // The description names what is read, not what would be written.
    line("format", fmt::format("{} ({})", format->name,
                               mesh.detail.empty() ? format->description : mesh.detail));
    line("points", fmt::format("{}", mesh.point_count()));
    line("duplicates", fmt::format("{}", duplicates(mesh.points)));
    line("dimension", fmt::format("{}", dimension(mesh.points)));
    if (mesh.has_tetrahedra) line("tetrahedra", fmt::format("{}", mesh.tetrahedron_count()));
    if (mesh.other_cells > 0) line("other cells", fmt::format("{}", mesh.other_cells));
    if (mesh.mid_side_nodes > 0)
        line("mid-side nodes", fmt::format("{}, left out", mesh.mid_side_nodes));
    for (std::size_t k = 0; k < 3 && mesh.point_count() > 0; ++k) {
        double low = mesh.points[k], high = low;
        for (std::size_t i = k; i < mesh.points.size(); i += 3) {
            low = std::min(low, mesh.points[i]);
            high = std::max(high, mesh.points[i]);
        }
        const char* const names[3] = {"x", "y", "z"};
        line(names[k], fmt::format("{} to {}", low, high));
    }
    for (std::size_t k = 0; k < 3 && mesh.box; ++k) {
        const double* const v = mesh.box->vectors.data() + 3 * k;
        line(k == 0 ? "box" : "", fmt::format("{} {} {}{}", v[0], v[1], v[2],
                                              mesh.box->repeats[k] ? "" : ", not periodic"));
    }
    if (mesh.tetrahedron_count() > 0) print_shapes(mesh, input_name(options.path), line);
    return exit_ok;
}

}  // namespace

const Command info_command = {
    "info", "Print what is in a file: format, counts, duplicates, dimension, extent.",
    [](CLI::App& app) -> std::function<int()> {
        const auto options = std::make_shared<InputOptions>();
        add_input(app, *options, "Points or tetrahedra");
        app.footer(exit_codes());
        return [options] { return info(*options); };
    }};

}  // namespace mgdt::cli
