// SPDX-License-Identifier: MIT
#include "cli/opening.hpp"

#include <fmt/core.h>

#include <string_view>

#include "cli/errors.hpp"
#include "cli/formats/mid_side_nodes.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {
namespace {

// Whether the bytes are only a byte order mark and blanks, or none at all.
bool holds_nothing(std::string_view bytes) {
    if (bytes.substr(0, 3) == "\xef\xbb\xbf") bytes.remove_prefix(3);
    return bytes.find_first_not_of(" \t\n\v\f\r") == std::string_view::npos;
}

}  // namespace

Mesh read_input(const InputOptions& options, const Format** format) {
    const InputFile file(options.path);
    const Source source = file.source();
    const bool blank = holds_nothing(source.bytes);
    const Format& f =
        input_format(blank ? Source{source.name, source.path, ""} : source, options.from);
    if (format) *format = &f;
    Mesh mesh;
    // A file of raw doubles may consist of bytes that are blanks in text.
    if (!blank || (&f == &raw_format() && !source.bytes.empty())) {
        mesh = read_mesh(f, source, options.read);
    } else if (options.allow_empty) {
        mesh.detail = "empty";
    } else {
        // Commands that read facets have no use for an empty file, and no such option.
        source.fail(
            fmt::format("is empty, as after a program that failed to write it{}",
                        options.needs_facets ? "" : "; --allow-empty takes it as no points"));
    }
    if (file.identity()) mesh.inputs.push_back(*file.identity());
    return mesh;
}

void print_left_out(std::size_t mid_side_nodes, const std::string& name) {
    if (mid_side_nodes == 0) return;
    fmt::print(stderr, "mgdt: {}: {}: tetrahedra of higher order are read by their corners\n", name,
               describe_mid_side_nodes(mid_side_nodes));
}

Opened open_input(const InputOptions& options, const std::vector<std::string>& files, bool quiet) {
    Opened opened = {read_input(options), input_name(options.path)};
    require_apart(opened.mesh.inputs, files);
    if (!quiet) print_left_out(opened.mesh.mid_side_nodes, opened.name);
    return opened;
}

void check_terminal(const OutputOptions& options, const Format& format) {
    if (options.path == "-" && format.binary && system::is_terminal(system::standard_output)) {
        throw Error(exit_usage,
                    fmt::format("{} is binary and standard output is a terminal; give -o a file",
                                format.name));
    }
}

const Format& points_format(const OutputOptions& output) {
    const Format& format = output_format(output.path, output.to);
    if (!format.write_points) {
        throw Error(exit_usage, fmt::format("{} ({}) is not for points alone; write .npy, .xyz, "
                                            ".csv, .f64, .ply or .node",
                                            format.name, format.description));
    }
    check_terminal(output, format);
    return format;
}

const Format& surface_format(const OutputOptions& output) {
    const Format& format = output_format(output.path, output.to);
    if (!format.write_surface) {
        throw Error(exit_usage, fmt::format("{} ({}) has no place for triangles; write .ply, .stl, "
                                            ".off, .obj or .vtp",
                                            format.name, format.description));
    }
    require_compressible(output.write, format);
    check_terminal(output, format);
    return format;
}

const Format& mesh_format(const OutputOptions& output, std::vector<std::string>& files) {
    const Format& format = output_format(output.path, output.to);
    if (!format.write_mesh) {
        throw Error(exit_usage,
                    fmt::format("{} ({}) has no place for tetrahedra; write .vtu, .msh, .mesh, "
                                ".inp, .vtk, .ele or .npy",
                                format.name, format.description));
    }
    require_compressible(output.write, format);
    check_terminal(output, format);
    files =
        format.mesh_files ? format.mesh_files(output.path) : std::vector<std::string>{output.path};
    return format;
}

}  // namespace mgdt::cli
