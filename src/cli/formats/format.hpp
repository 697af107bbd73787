// SPDX-License-Identifier: MIT
// The file formats that the program knows, one object each, and how one is chosen.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/formats/file_mesh.hpp"
#include "cli/input_file.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli {

struct ReadOptions {
    // Of x, y and z in text, from 1, where they are chosen. Otherwise those that have the names, or
    // the first three.
    std::optional<std::array<int, 3>> columns;
    const char* columns_option = "--columns";  // which chooses them, for messages
    // Whether the fields are wanted too: those of these names, or all where there are no names.
    bool has_fields = false;
    std::vector<std::string> field_names;
};

struct WriteOptions {
    int index_base = 0;           // of formats that leave it open
    bool is_base_chosen = false;  // or else it is the default
    bool compress = false;        // .vtu
};

// Where a file has its points: rows of bytes of one length, with x, y and z at the beginning.
struct RowLayout {
    std::size_t begin, rows, row_bytes;
    bool wide;  // doubles, or else floats
    bool big_endian;
};

struct Format {
    const char* name;  // for --from and --to
    std::vector<const char*> extensions;
    const char* description;
    bool binary;  // whether what is written would upset a terminal

    // Whether the beginning of a file is this format's for certain; nullptr where none can be.
    bool (*sniff)(std::string_view bytes);
    // Every coordinate that comes back is finite and every vertex is a point; else Error. Called
    // by read_mesh().
    Mesh (*read)(const Source& source, const ReadOptions& options);
    // nullptr where the format has no place for them.
    void (*write_points)(const std::vector<double>& points, OutputFile& out,
                         const WriteOptions& options);
    void (*write_mesh)(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                       const WriteOptions& options);
    // The files that write_mesh() writes; nullptr where it is the one that is named.
    std::vector<std::string> (*mesh_files)(const std::string& path) = nullptr;
    // The points with their fields, which read() takes too, and the tetrahedra where the format has
    // a place for them; nullptr where it has none for fields.
    void (*write_fields)(const Mesh& mesh, OutputFile& out, const WriteOptions& options) = nullptr;
    // Where the points are, by the beginning of a file of so many bytes, for those who read a share
    // of them; nothing where read() has to see the whole file. nullptr where it always has to.
    std::optional<RowLayout> (*rows)(const Source& beginning, std::size_t file_size) = nullptr;
    // The neighbours in their own file among mesh_files(), after write_mesh(): both arrays need not
    // be in memory at one time. nullptr where the format has no neighbours.
    void (*write_neighbors)(const std::vector<MeshIndex>& neighbors, const std::string& path,
                            OutputSet& outputs, const WriteOptions& options) = nullptr;
};

const Format& text_format();
const Format& csv_format();
const Format& npy_format();
const Format& raw_format();
const Format& ply_format();
const Format& tetgen_format();
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

const std::vector<const Format*>& all_formats();

// By name (--from, --to); throws a usage error for an unknown one.
const Format& format_from_name(const std::string& name);
// By the name of a file; nullptr where its extension says nothing.
const Format* format_from_path(const std::string& path);
// By content; nullptr where that says nothing.
const Format* format_from_content(std::string_view bytes);

// The format of an input: `name` unless empty, then the extension, then the content. Text is taken
// for points only where there is no extension.
const Format& input_format(const Source& source, const std::string& name);
// What a source holds. The nodes of tetrahedra of higher order are their corners alone.
Mesh read_mesh(const Format& format, const Source& source, const ReadOptions& options);

// The format of an output: `name` unless empty, then the extension; usage error if neither.
const Format& output_format(const std::string& path, const std::string& name);

// Throws where compression is asked for, and the format or this program has none.
void require_compressible(const WriteOptions& options, const Format& format);

// Whether a field of this name is wanted.
bool wants_field(const ReadOptions& options, const std::string& name);
// Throws where a field that is wanted is not among `names`.
void require_fields(const Source& source, const ReadOptions& options,
                    const std::vector<std::string>& names);

// The path without the extension, if it has one of the format's.
std::string without_extension(const std::string& path, const Format& format);

// Arrays of integers as .npy, n rows of 4: how tetrahedra and neighbours leave for NumPy.
void write_npy_rows_of_4(const std::vector<MeshIndex>& values, std::int64_t add, OutputFile& out);
// The same, one a row.
void write_npy_integers(const std::vector<MeshIndex>& values, std::int64_t add, OutputFile& out);
// The rows of 4 read back, as vertices of tetrahedra: less `base`, numbers of the points in the
// file of that name.
std::vector<MeshIndex> read_npy_tetrahedra(const Source& source, int base, std::size_t points,
                                           const std::string& points_name);
// Values, a row to a point, from an array of one or two dimensions.
Field read_npy_values(const Source& source);

}  // namespace mgdt::cli
