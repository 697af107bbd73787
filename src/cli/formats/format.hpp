// SPDX-License-Identifier: MIT
// The file formats of the program, one object each, and how a format is chosen.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/formats/file_mesh.hpp"
#include "cli/formats/surface.hpp"
#include "cli/input_file.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli {

struct ReadOptions {
    // The columns of x, y and z in text, from 1, if they are chosen. Otherwise the columns with
    // these names, or the first three, are read.
    std::optional<std::array<int, 3>> columns;
    const char* columns_option = "--columns";  // the option that chooses them, for messages
    // Whether fields are read too: those with these names, or all if there are no names.
    bool has_fields = false;
    bool has_facets = false;  // whether facets are read too
    // Whether the markers of tetrahedra, and triangles as facets, are read too, where the format
    // has them.
    bool has_markers = false;
    std::vector<std::string> field_names;
};

struct WriteOptions {
    int index_base = 0;           // the number of the first point, in formats that leave it open
    bool is_base_chosen = false;  // whether the user has chosen it
    bool compress = false;        // compress .vtu files
};

// The position of the points in a file: rows of bytes of the same length, which begin with x, y and
// z.
struct RowLayout {
    std::size_t begin, rows, row_bytes;
    bool wide;  // doubles, otherwise floats
    bool big_endian;
};

struct Format {
    const char* name;  // for --from and --to
    std::vector<const char*> extensions;
    const char* description;
    bool binary;  // whether its output would upset a terminal

    // Whether the beginning of a file certainly has this format; nullptr if no beginning is
    // certain.
    bool (*sniff)(std::string_view bytes);
    // Reads a file. All coordinates are finite and all vertices are points; otherwise it throws
    // Error. Called by read_mesh().
    Mesh (*read)(const Source& source, const ReadOptions& options);
    // Write points or a mesh; nullptr if the format does not have them.
    void (*write_points)(const std::vector<double>& points, OutputFile& out,
                         const WriteOptions& options);
    void (*write_mesh)(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                       const WriteOptions& options);
    // The files that write_mesh() writes; nullptr if it writes the named file only.
    std::vector<std::string> (*mesh_files)(const std::string& path) = nullptr;
    // Writes the points with their fields, and the tetrahedra if the format has them; nullptr if
    // the format has no fields.
    void (*write_fields)(const Mesh& mesh, OutputFile& out, const WriteOptions& options) = nullptr;
    // The layout of the points, from the beginning of a file of `file_size` bytes, for readers of a
    // share of the points. Nothing if read() has to see the whole file; nullptr if it always has
    // to.
    std::optional<RowLayout> (*rows)(const Source& beginning, std::size_t file_size) = nullptr;
    // Writes the neighbours to their own file among mesh_files(), after write_mesh(), so that both
    // arrays need not be in memory at the same time. nullptr if the format has no neighbours.
    void (*write_neighbors)(const std::vector<MeshIndex>& neighbors, const std::string& path,
                            OutputSet& outputs, const WriteOptions& options) = nullptr;
    // Whether read() reads facets.
    bool has_facets = false;
    // Writes triangles; nullptr if the format does not have them.
    void (*write_surface)(const Surface& surface, OutputFile& out,
                          const WriteOptions& options) = nullptr;
};

const Format& text_format();
const Format& csv_format();
const Format& npy_format();
const Format& raw_format();
const Format& ply_format();
const Format& tetgen_format();
const Format& poly_format();
const Format& gmsh_format();
const Format& gmsh2_format();
const Format& vtu_format();
const Format& vtp_format();
const Format& obj_format();
const Format& off_format();
const Format& stl_format();
const Format& vtk_format();
const Format& medit_format();
const Format& medit_binary_format();
const Format& abaqus_format();
const Format& lammps_dump_format();
const Format& lammps_data_format();
const Format& poscar_format();

const std::vector<const Format*>& all_formats();

// The format with a name (--from, --to). Throws a usage error for an unknown name.
const Format& format_from_name(const std::string& name);
// The format of a file by its extension, or by its name if that is POSCAR or CONTCAR; nullptr if
// neither is known.
const Format* format_from_path(const std::string& path);
// The format of a file by its content; nullptr if that is not certain.
const Format* format_from_content(std::string_view bytes);

// The format of an input: by `name` unless that is empty, then by extension, then by content.
// Content that looks like text is read as points only if there is no extension.
const Format& input_format(const Source& source, const std::string& name);
// Reads a source. Higher-order tetrahedra are reduced to their corners.
Mesh read_mesh(const Format& format, const Source& source, const ReadOptions& options);

// The format of an output: by `name` unless that is empty, then by extension. Throws a usage error
// if neither is known.
const Format& output_format(const std::string& path, const std::string& name);

// The options with which a mesh is written that was made from a file. TetGen's files begin with the
// number that the file begins with, unless the user has chosen one, since other files of the same
// set use these numbers. `format` may be nullptr.
WriteOptions options_after(const Mesh& input, const Format* format, WriteOptions options);

// Throws if compression is asked for, and the format or this program does not have it.
void require_compressible(const WriteOptions& options, const Format& format);

// Whether the field with this name is asked for.
bool wants_field(const ReadOptions& options, const std::string& name);
// Throws if a field that is asked for is not among `names`.
void require_fields(const Source& source, const ReadOptions& options,
                    const std::vector<std::string>& names);

// The path without its extension, if that is one of the format's.
std::string without_extension(const std::string& path, const Format& format);

// Writes integers as an .npy array with rows of 4, for tetrahedra and neighbours.
void write_npy_rows_of_4(const std::vector<MeshIndex>& values, std::int64_t add, OutputFile& out);
// The same with one integer per row.
void write_npy_integers(const std::vector<MeshIndex>& values, std::int64_t add, OutputFile& out);
// Reads rows of 4 as vertices of tetrahedra, and subtracts `base`. The vertices are points of the
// file `points_name`.
std::vector<MeshIndex> read_npy_tetrahedra(const Source& source, int base, std::size_t points,
                                           const std::string& points_name);
// Reads values, one row per point, from an array of one or two dimensions.
Field read_npy_values(const Source& source);

}  // namespace mgdt::cli
