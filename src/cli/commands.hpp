// SPDX-License-Identifier: MIT
// The commands of the program. Each returns an exit code or throws Error.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/distributions.hpp"
#include "cli/formats/format.hpp"
#include "cli/periodic_box.hpp"
#include "cli/program_triangulation.hpp"
#include "cli/region.hpp"

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

struct TriangulateOptions {
    InputOptions input;
    OutputOptions output;
    TriangulationOptions triangulation;
    std::string neighbors;    // .npy file, or empty
    std::string point_map;    // .npy file, or empty
    bool all_points = false;  // also write points that are in no tetrahedron
    int check_level = 0;
    double drop_flat = 0;  // the radius ratio below which tetrahedra are taken off the hull
    bool statistics = false;
    int parts = 0;  // number of parts; 0 for one triangulation
    PeriodicOptions periodic;
    std::string images;  // a .csv file of the images that are nodes, or empty
};
int triangulate(const TriangulateOptions& options);
int triangulate_in_parts(const TriangulateOptions& options);
int triangulate_in_box(const TriangulateOptions& options);

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
    std::string points;           // file of the points, if `input` is an array of tetrahedra
    int index_base = 0;           // the index base of that array
    bool is_constrained = false;  // check a mesh that need not be Delaunay or convex
    TriangulationOptions triangulation;
};
int check(const CheckOptions& options);

int info(const InputOptions& options);

struct InterpolateOptions {
    InputOptions samples, places;
    std::string values;  // an .npy file of values; if empty, the values are in `samples`
    std::vector<std::string> fields;
    std::string method = "linear", outside = "none";
    OutputOptions output;
    TriangulationOptions triangulation;
};
int interpolate(const InterpolateOptions& options);
// The names of the methods of interpolation, and of the treatments of places outside the hull.
std::vector<std::string> interpolation_methods();
std::vector<std::string> interpolation_outsides();

struct VoronoiOptions {
    InputOptions input;
    OutputOptions output;
    std::string table;  // a .csv file of measures, or empty
    RegionOptions region;
    PeriodicOptions periodic;
    double least_area = 0, least_share = 0;  // of faces that are not left out
    TriangulationOptions triangulation;
};
int write_voronoi(const VoronoiOptions& options);

struct SurfaceOptions {
    InputOptions input;
    OutputOptions output;
    std::string alpha = "auto";  // the radius of the alpha shape; or "auto" for one solid
    bool largest = false;        // write the solid of largest volume only
    TriangulationOptions triangulation;
};
int write_alpha_surface(const SurfaceOptions& options);

struct HullOptions {
    InputOptions input;
    OutputOptions output;
    TriangulationOptions triangulation;
};
int write_hull(const HullOptions& options);

struct RelaxOptions {
    InputOptions input;
    OutputOptions output;
    RegionOptions region = {"auto", ""};
    int steps = 0;
    TriangulationOptions triangulation;
};
int relax(const RelaxOptions& options);

struct MeshOptions {
    InputOptions input;
    OutputOptions output;
    std::vector<double> holes;    // three numbers for each
    std::vector<double> regions;  // three numbers and the marker for each
    bool check = false;
    bool rounded = false;     // write rounded points, which facets cover exactly
    bool strict = false;      // refuse a mesh that leaves out a part of the input
    bool all_points = false;  // also write points that are in no tetrahedron
    int threads = 1;
    std::uint64_t memory_limit = 0;  // bytes, 0 for none
    bool quiet = false;
};
int mesh_surface(const MeshOptions& options);

struct ValidateOptions {
    InputOptions input;
    OutputOptions output;  // a .vtp file of what offends, or empty
    int threads = 1;
    std::uint64_t memory_limit = 0;
    bool quiet = false;
};
int validate_surface(const ValidateOptions& options);

// Reads an input. `format` receives the format of the input.
Mesh read_input(const InputOptions& options, const Format** format = nullptr);

// Reports on standard error what was not read of a file, if anything.
void print_left_out(std::size_t mid_side_nodes, const std::string& name);

// The data files that these distributions need.
std::vector<FileIdentity> data_files(const std::vector<std::string>& names,
                                     const std::string& directory);

// Throws if binary output would go to a terminal.
void check_terminal(const OutputOptions& options, const Format& format);
// The format of an output of tetrahedra, and the files that it writes. Throws a usage error if the
// format has no tetrahedra, or cannot be compressed as it should be.
const Format& mesh_format(const OutputOptions& output, std::vector<std::string>& files);

// Parses an integer, which may be written as 1e6. `name` is the name of the argument, for messages.
std::size_t parse_point_count(const std::string& name, const std::string& text);

// "1 point", "2 points".
std::string counted(std::size_t n, const char* singular, const char* plural);

}  // namespace mgdt::cli
