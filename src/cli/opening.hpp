// SPDX-License-Identifier: MIT
// How commands begin: the inputs that they read, and the formats of their outputs.
#pragma once

#include <string>
#include <vector>

#include "cli/formats/format.hpp"

namespace mgdt::cli {

struct InputOptions {
    std::string path;
    std::string from;  // format; if empty, it is found by extension, then by content
    ReadOptions read;
    bool allow_empty = false;   // accept an empty file as no points
    bool needs_facets = false;  // the command has no use for points alone
};

struct OutputOptions {
    std::string path;
    std::string to;  // format; if empty, it is found by extension
    WriteOptions write;
};

// Reads an input. `format` receives the format of the input.
Mesh read_input(const InputOptions& options, const Format** format = nullptr);

// Reports on standard error what was not read of a file, if anything.
void print_left_out(std::size_t mid_side_nodes, const std::string& name);

struct Opened {
    Mesh mesh;
    std::string name;  // of the file, for messages
};
// Reads the points or the mesh of a command that writes `files`, none of which may be the input.
// Unless it is quiet, reports what was not read.
Opened open_input(const InputOptions& options, const std::vector<std::string>& files, bool quiet);

// Throws if binary output would go to a terminal.
void check_terminal(const OutputOptions& options, const Format& format);
// The formats of outputs. They throw a usage error if the format has no place for what is written,
// or cannot be compressed as it should be, and if binary output would go to a terminal.
const Format& points_format(const OutputOptions& output);
const Format& surface_format(const OutputOptions& output);
// `files` receives the names of the files that the format writes.
const Format& mesh_format(const OutputOptions& output, std::vector<std::string>& files);

}  // namespace mgdt::cli
