// SPDX-License-Identifier: MIT
// The commands of the program. Each returns an exit code or throws Error.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/distributions.hpp"
#include "cli/formats/format.hpp"
#include "cli/program_triangulation.hpp"

namespace mgdt::cli {

struct InputOptions {
    std::string path;
    std::string from;  // format; empty: by extension, then by content
    ReadOptions read;
    bool allow_empty = false;  // take a file of nothing as no points
};

struct OutputOptions {
    std::string path;
    std::string to;  // format; empty: by extension
    WriteOptions write;
};

struct TriangulateOptions {
    InputOptions input;
    OutputOptions output;
    TriangulationOptions triangulation;
    std::string neighbors;    // .npy file, or empty
    std::string point_map;    // .npy file, or empty
    bool all_points = false;  // write points that are in no tetrahedron too
    int check_level = 0;
    bool statistics = false;
    int parts = 0;  // 0: one triangulation
};
int triangulate(const TriangulateOptions& options);
int triangulate_in_parts(const TriangulateOptions& options);

struct GenerateCommandOptions {
    std::string kind;
    std::string count;
    OutputOptions output;
    GenerateOptions generate;
    bool quiet = false;
};
int generate_points(const GenerateCommandOptions& options);

struct CheckOptions {
    InputOptions input;
    std::string points;  // file of the points, where `input` is an array of tetrahedra
    int index_base = 0;  // of that array
    TriangulationOptions triangulation;
};
int check(const CheckOptions& options);

int info(const InputOptions& options);

struct InterpolateOptions {
    InputOptions samples, places;
    std::string values;  // .npy file of the values, or empty: they are in `samples`
    std::vector<std::string> fields;
    std::string method = "linear", outside = "none";
    OutputOptions output;
    TriangulationOptions triangulation;
};
int interpolate(const InterpolateOptions& options);
// Names of methods, and of what is done outside the hull.
std::vector<std::string> interpolation_methods();
std::vector<std::string> interpolation_outsides();

// Reads an input; `format` receives the format it was read as.
Mesh read_input(const InputOptions& options, const Format** format = nullptr);

// Says on standard error what of a file was left out, if anything.
void print_left_out(std::size_t mid_side_nodes, const std::string& name);

// The data files that points of these distributions are made from.
std::vector<FileIdentity> data_files(const std::vector<std::string>& names,
                                     const std::string& directory);

// Refuses to send bytes to a terminal.
void check_terminal(const OutputOptions& options, const Format& format);

// A whole number, which may be written 1e6. `name` is that of the argument, for messages.
std::size_t parse_point_count(const std::string& name, const std::string& text);

// "1 point", "2 points".
std::string counted(std::size_t n, const char* singular, const char* plural);

}  // namespace mgdt::cli
