// SPDX-License-Identifier: MIT
// VTK's legacy files, .vtk, text and binary, versions 1 to 5.1: the points and the tetrahedra of an
// unstructured grid, the points of other datasets that list them, and flat cells as facets if these
// are asked for. The VTK User's Guide, "VTK
// File Formats"; what version 5 changed, VTK's vtkDataReader. Written as version 3.0, text.
#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <type_traits>

#include "cli/errors.hpp"
#include "cli/formats/bytes.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/item_type.hpp"
#include "cli/formats/number.hpp"
#include "cli/formats/text_rows.hpp"
#include "cli/formats/vtk_cells.hpp"
#include "cli/formats/words.hpp"

namespace mgdt::cli {
namespace {

constexpr std::string_view magic = "# vtk DataFile Version ";

// Compares keywords as VTK does, without regard to case.
bool same(std::string_view word, std::string_view keyword) {
    return is_same_but_for_case(word, keyword);
}

bool sniff(std::string_view bytes) {
    return bytes.substr(0, magic.size()) == magic;
}

// Converts the name of a type in these files to that in VTK's XML files; empty for unknown types.
// vtkIdType is written with 32 bits.
std::string_view type_of(std::string_view word) {
    static constexpr std::string_view names[][2] = {{"CHAR", "Int8"},
                                                    {"SIGNED_CHAR", "Int8"},
                                                    {"UNSIGNED_CHAR", "UInt8"},
                                                    {"SHORT", "Int16"},
                                                    {"UNSIGNED_SHORT", "UInt16"},
                                                    {"INT", "Int32"},
                                                    {"UNSIGNED_INT", "UInt32"},
                                                    {"VTKIDTYPE", "Int32"},
                                                    {"LONG", "Int64"},
                                                    {"UNSIGNED_LONG", "UInt64"},
                                                    {"VTKTYPEINT64", "Int64"},
                                                    {"VTKTYPEUINT64", "UInt64"},
                                                    {"FLOAT", "Float32"},
                                                    {"DOUBLE", "Float64"}};
    for (const auto& [name, type] : names) {
        if (same(word, name)) return type;
    }
    return {};
}

// Reads a file. Keywords and their numbers are words of text. Arrays are text too, or big-endian
// bytes that begin after the line of their keyword.
class Input {
  public:
    explicit Input(const Source& source) : source_(source), words_(LineReader(source)) {
        LineReader lines(source);
        if (!lines.next() || !sniff(lines.text()))
            source.fail_at_line(1, "not a VTK file: it does not begin with # vtk DataFile Version");
        const std::string_view version = lines.text().substr(magic.size());
        if (parse_number(version, version_) != NumberStatus::ok ||
            !(version_ >= 1 && version_ < 6)) {
            lines.fail(
                fmt::format("version {}; up to 5.1 can be read; write it as .vtu, or as an "
                            "older version",
                            quote(version)));
        }
        if (!lines.next() || !lines.next()) lines.fail("the file is cut short");
        const std::string_view encoding = Fields(lines).word("the encoding");
        is_binary_ = same(encoding, "BINARY");
        if (!is_binary_ && !same(encoding, "ASCII"))
            lines.fail(fmt::format("encoding {}; it is ASCII or BINARY", quote(encoding)));
        detail_ = fmt::format("version {}, {}", version, is_binary_ ? "binary" : "text");
        words_ = Words(lines, no_comment);
    }

    Words& words() { return words_; }
    bool is_binary() const { return is_binary_; }
    // Whether cells are given by a list of offsets and a list of points.
    bool has_offsets() const { return version_ >= 5; }
    const std::string& detail() const { return detail_; }

    std::vector<double> coordinates(std::uint64_t n, std::string_view type) {
        return array<double>(
            n, type, "coordinates",
            [&](auto item, ByteReader& bytes) { return bytes.coordinate<decltype(item)>(); },
            [](Words& words) { return words.number("coordinate"); });
    }
    std::vector<std::int64_t> integers(std::uint64_t n, std::string_view type, const char* what) {
        return array<std::int64_t>(
            n, type, what,
            [&](auto item, ByteReader& bytes) -> std::int64_t {
                if constexpr (std::is_integral_v<decltype(item)>)
                    return static_cast<std::int64_t>(bytes.value<decltype(item)>(what));
                bytes.fail(fmt::format("{} of a floating-point type", what));
            },
            [&](Words& words) { return words.integer(what, 0, most); });
    }
    std::vector<double> values(std::uint64_t n, std::string_view type) {
        return array<double>(
            n, type, "values",
            [&](auto item, ByteReader& bytes) {
                return static_cast<double>(bytes.value<decltype(item)>("value"));
            },
            [](Words& words) { return words.number("value"); });
    }
    void skip(std::uint64_t n, std::string_view type) {
        if (!is_binary_) {
            std::string_view word;
            for (std::uint64_t i = 0; i < n; ++i)
                if (!words_.next(word)) words_.fail("the file is cut short");
            return;
        }
        ByteReader bytes(source_, words_.lines().offset(), true);
        with_type(type, [&](auto item) { bytes.skip(n, sizeof item, "items of an array"); });
        go_on_at(bytes.offset());
    }

    static constexpr std::int64_t most = std::int64_t{1} << 62;

  private:
    template <class Item, class FromBytes, class FromText>
    std::vector<Item> array(std::uint64_t n, std::string_view type, const char* what,
                            const FromBytes& from_bytes, const FromText& from_text) {
        if (!is_binary_) {
            const LineReader& lines = words_.lines();
            const std::size_t left = lines.bytes_left() + lines.text().size() + 1;
            if (n > left / 2)
                words_.fail(
                    fmt::format("{} {}, but only {} bytes are left; the file is cut short "
                                "or the number is wrong",
                                n, what, left));
            std::vector<Item> items(static_cast<std::size_t>(n));
            for (Item& item : items) item = from_text(words_);
            return items;
        }
        if (type.empty()) words_.fail("a type of numbers that is not known");
        ByteReader bytes(source_, words_.lines().offset(), true);
        std::vector<Item> items;
        with_type(type, [&](auto item) {
            bytes.need(n, sizeof item, what);
            items.resize(static_cast<std::size_t>(n));
            for (Item& i : items) i = from_bytes(item, bytes);
        });
        go_on_at(bytes.offset());
        return items;
    }
    // After an array of bytes, lines are numbered from the last line that was read.
    void go_on_at(std::size_t offset) {
        words_ = Words(LineReader(source_, offset, words_.lines().number() + 1), no_comment);
    }

    const Source& source_;
    Words words_;
    std::string detail_;
    double version_ = 0;
    bool is_binary_ = false;
};

struct Cells {
    std::vector<std::int64_t> nodes;
    std::vector<std::size_t> begin;  // the first node of each cell, and the end of the last
    std::size_t count() const { return begin.empty() ? 0 : begin.size() - 1; }
    const std::int64_t* begin_of(std::size_t i) const { return nodes.data() + begin[i]; }
    std::size_t size_of(std::size_t i) const { return begin[i + 1] - begin[i]; }
};

// Reads cells of versions up to 4: `count` cells in a list of `size` integers, which has the number
// of nodes of each cell and then the nodes.
Cells read_list_of_cells(Input& input, std::int64_t count, std::int64_t size) {
    const std::vector<std::int64_t> list =
        input.integers(static_cast<std::uint64_t>(size), "Int32", "the list of cells");
    Cells cells;
    std::size_t at = 0;
    for (std::int64_t i = 0; i < count; ++i) {
        if (at == list.size()) input.words().fail("the list of cells is too short");
        const std::int64_t n = list[at++];
        if (n < 0 || static_cast<std::uint64_t>(n) > list.size() - at)
            input.words().fail(fmt::format("a cell of {} points", n));
        cells.begin.push_back(cells.nodes.size());
        const auto first = list.begin() + static_cast<std::ptrdiff_t>(at);
        cells.nodes.insert(cells.nodes.end(), first, first + n);
        at += static_cast<std::size_t>(n);
    }
    cells.begin.push_back(cells.nodes.size());
    return cells;
}

std::string_view array_type(Input& input, std::string_view keyword) {
    std::string_view word;
    if (!input.words().next(word) || !same(word, keyword))
        input.words().fail(fmt::format("{} is to follow", keyword));
    if (!input.words().next(word)) input.words().fail("the type is to follow");
    return type_of(word);
}

// Reads cells of version 5: `count` offsets, one more than there are cells, and `size` nodes.
Cells read_offsets_of_cells(Input& input, std::int64_t count, std::int64_t size) {
    const std::string_view offset_type = array_type(input, "OFFSETS");
    const std::vector<std::int64_t> offsets =
        input.integers(static_cast<std::uint64_t>(count), offset_type, "offsets");
    const std::string_view node_type = array_type(input, "CONNECTIVITY");
    Cells cells;
    cells.nodes = input.integers(static_cast<std::uint64_t>(size), node_type, "points of cells");
    std::int64_t least = 0;
    for (const std::int64_t offset : offsets) {
        if (offset < least || offset > size)
            input.words().fail(fmt::format("the cells' offset {} after {}", offset, least));
        least = offset;
        cells.begin.push_back(static_cast<std::size_t>(offset));
    }
    return cells;
}

// Reads cells after a keyword such as CELLS.
Cells read_cells(Input& input) {
    Words& words = input.words();
    const std::int64_t count = words.integer("the number of cells", 0, Input::most);
    const std::int64_t size = words.integer("the size of the list of cells", 0, Input::most);
    return input.has_offsets() ? read_offsets_of_cells(input, count, size)
                               : read_list_of_cells(input, count, size);
}

// Reads the types of the cells.
std::vector<std::int64_t> read_types(const Cells& cells, Input& input, const Mesh& mesh) {
    Words& words = input.words();
    const std::int64_t n = words.integer("the number of cell types", 0, Input::most);
    if (static_cast<std::uint64_t>(n) != cells.count())
        words.fail(fmt::format("{} types of {} cells", n, cells.count()));
    std::vector<std::int64_t> types =
        input.integers(static_cast<std::uint64_t>(n), "Int32", "the cell's type");
    const auto last = static_cast<std::int64_t>(mesh.point_count()) - 1;
    for (std::size_t i = 0; i < types.size(); ++i) {
        const std::int64_t* const nodes = cells.begin_of(i);
        const std::size_t count = cells.size_of(i);
        if (!may_have_nodes(types[i], count))
            words.fail(fmt::format("a cell of type {} with {} points", types[i], count));
        for (std::size_t k = 0; k < count; ++k) {
            if (nodes[k] < 0 || nodes[k] > last)
                words.fail(fmt::format("cell {}: point is {}; it must be from 0 to {}", i, nodes[k],
                                       last));
        }
    }
    return types;
}

void add_cells(const Cells& cells, const std::vector<std::int64_t>& types, bool has_facets,
               const VtkCellMarkers& markers, Mesh& mesh) {
    for (std::size_t i = 0; i < types.size(); ++i) {
        const std::int64_t* const nodes = cells.begin_of(i);
        if (is_vtk_tetrahedron(types[i]))
            add_vtk_tetrahedron(nodes, cells.size_of(i), markers, i, mesh);
        else
            ++mesh.other_cells;
        if (has_facets)
            add_vtk_facet(types[i], nodes, cells.size_of(i), mesh.facets, markers.facet(i));
    }
}

// Reads the lines, polygons or strips of a surface, which are cells of one type.
void take_surface_cells(Input& input, std::int64_t type, bool has_facets, Mesh& mesh) {
    const Cells cells = read_cells(input);
    mesh.other_cells += cells.count();
    for (std::size_t i = 0; has_facets && i < cells.count(); ++i)
        add_vtk_facet(type, cells.begin_of(i), cells.size_of(i), mesh.facets);
}

// The arrays of cell data that have markers, and where they go.
class MarkerArrays {
  public:
    explicit MarkerArrays(VtkCellMarkers& markers) : markers_(markers) {}

    // Whether an array has markers, and none has been read whose name comes before it in the list.
    bool wants(std::string_view name) const {
        return rank_of(name) < best_[is_of_facets(name) ? 1 : 0];
    }
    void take(std::string_view name, const std::vector<double>& values, Words& words) {
        const bool is_facet = is_of_facets(name);
        best_[is_facet ? 1 : 0] = rank_of(name);
        (is_facet ? markers_.facets
                  : markers_.regions) = vtk_markers_of(values, [&](std::size_t cell, double value) {
            words.fail(fmt::format("{} of cell {}: {} is no 32-bit integer", name, cell, value));
        });
    }

  private:
    static bool is_of_facets(std::string_view name) {
        return rank_in(vtk_facet_arrays, name) < std::size(vtk_facet_arrays);
    }
    // The position of a name in a list; beyond the end if it is not there.
    template <std::size_t n>
    static std::size_t rank_in(const char* const (&names)[n], std::string_view name) {
        return static_cast<std::size_t>(std::find(names, names + n, name) - names);
    }
    static std::size_t rank_of(std::string_view name) {
        return is_of_facets(name) ? rank_in(vtk_facet_arrays, name)
                                  : rank_in(vtk_region_arrays, name);
    }

    VtkCellMarkers& markers_;
    // The ranks of the arrays of regions and of facets that have been read.
    std::size_t best_[2] = {std::size(vtk_region_arrays), std::size(vtk_facet_arrays)};
};

// Reads or skips an array of `tuples` times `components` numbers.
void read_data(Input& input, std::string_view name, std::int64_t components, std::int64_t tuples,
               std::string_view type_name, MarkerArrays* markers) {
    const std::string_view type = type_of(type_name);
    if (input.is_binary() && type.empty())
        input.words().fail(
            fmt::format("a field of type {} in a binary file; take it out", quote(type_name)));
    const auto count = static_cast<std::uint64_t>(components * tuples);
    if (markers != nullptr && components == 1 && markers->wants(name))
        markers->take(name, input.values(count, type), input.words());
    else
        input.skip(count, type);
}

std::string next_word(Words& words, const char* what) {
    std::string_view word;
    if (!words.next(word)) words.fail(fmt::format("{} is to follow", what));
    return std::string(word);
}

// Reads the arrays of FIELD. Each has its name, components, tuples and type before its numbers.
void read_fields(Input& input, MarkerArrays* markers) {
    Words& words = input.words();
    next_word(words, "a name");
    const std::int64_t arrays = words.integer("the number of arrays", 0, Input::most);
    for (std::int64_t i = 0; i < arrays; ++i) {
        std::string name = next_word(words, "an array");
        if (same(name, "METADATA")) {
            words.skip_to_blank_line();
            name = next_word(words, "an array");
        }
        const auto components = words.integer("the number of components", 0, 1 << 20);
        const auto tuples = words.integer("the number of tuples", 0, std::int64_t{1} << 40);
        const std::string type = next_word(words, "the type");
        read_data(input, name, components, tuples, type, markers);
    }
}

// Reads SCALARS after the keyword. The number of components may be left out.
void read_scalars(Input& input, std::int64_t tuples, MarkerArrays* markers) {
    Words& words = input.words();
    const std::string name = next_word(words, "a name"), type = next_word(words, "the type");
    std::int64_t components = 1;
    std::string word = next_word(words, "LOOKUP_TABLE");
    if (!same(word, "LOOKUP_TABLE")) {
        if (!parse_integer(word, components) || components < 1 || components > 4)
            words.fail(fmt::format("{} components; there are 1 to 4", quote(word)));
        word = next_word(words, "LOOKUP_TABLE");
    }
    if (!same(word, "LOOKUP_TABLE")) words.fail("LOOKUP_TABLE is to follow");
    next_word(words, "the name of a table");
    read_data(input, name, components, tuples, type, markers);
}

// Reads the markers from the data of cells, and skips all other data. `word` is POINT_DATA or
// CELL_DATA.
VtkCellMarkers read_markers(Input& input, std::string_view word, std::size_t cells) {
    // Keywords that a name and a type follow, and how many numbers each point or cell has then.
    static constexpr struct {
        std::string_view keyword;
        std::int64_t components;
    } others[] = {{"VECTORS", 3},  {"NORMALS", 3},    {"TENSORS", 9},
                  {"TENSORS6", 6}, {"GLOBAL_IDS", 1}, {"PEDIGREE_IDS", 1}};
    VtkCellMarkers found;
    MarkerArrays arrays(found);
    MarkerArrays* of_cells = nullptr;
    std::int64_t tuples = 0;
    Words& words = input.words();
    do {
        if (same(word, "POINT_DATA") || same(word, "CELL_DATA")) {
            of_cells = same(word, "CELL_DATA") ? &arrays : nullptr;
            tuples = words.integer("the number of values", 0, std::int64_t{1} << 40);
            if (of_cells != nullptr && static_cast<std::uint64_t>(tuples) != cells)
                words.fail(fmt::format("data of {} cells; there are {}", tuples, cells));
        } else if (same(word, "SCALARS")) {
            read_scalars(input, tuples, of_cells);
        } else if (same(word, "FIELD")) {
            read_fields(input, of_cells);
        } else if (same(word, "METADATA")) {
            words.skip_to_blank_line();
        } else if (const auto* const other =
                       std::find_if(std::begin(others), std::end(others),
                                    [&](const auto& o) { return same(word, o.keyword); });
                   other != std::end(others)) {
            const std::string name = next_word(words, "a name"),
                              type = next_word(words, "the type");
            read_data(input, name, other->components, tuples, type, nullptr);
        } else if (input.is_binary()) {
            words.fail(fmt::format("{} in a binary file; take it out", quote(word)));
        }
    } while (words.next(word));
    return found;
}

Mesh read_vtk(const Source& source, const ReadOptions& options) {
    Input input(source);
    Mesh mesh;
    mesh.detail = input.detail();
    Cells cells;
    std::vector<std::int64_t> types;
    const bool has_facets = options.has_facets || options.has_markers;
    bool has_points = false, has_cells = false, has_types = false, is_grid = false;
    std::string_view word;
    Words& words = input.words();
    bool has_data = false;
    while (!has_data && words.next(word)) {
        has_data = same(word, "POINT_DATA") || same(word, "CELL_DATA");
        if (same(word, "DATASET")) {
            is_grid = words.next(word) && same(word, "UNSTRUCTURED_GRID");
        } else if (same(word, "METADATA")) {
            words.skip_to_blank_line();
        } else if (same(word, "FIELD") && input.is_binary()) {
            read_fields(input, nullptr);
        } else if (same(word, "POINTS")) {
            if (has_points) words.fail("POINTS come twice");
            has_points = true;
            const std::int64_t n = words.integer("the number of points", 0, Input::most / 4);
            const std::string_view type = words.next(word) ? type_of(word) : std::string_view();
            mesh.points = input.coordinates(3 * static_cast<std::uint64_t>(n), type);
        } else if (same(word, "CELLS")) {
            if (has_cells || has_types) words.fail("CELLS come twice, or after their types");
            has_cells = true;
            cells = read_cells(input);
        } else if (same(word, "VERTICES")) {
            read_cells(input);
        } else if (same(word, "LINES") || same(word, "POLYGONS") || same(word, "TRIANGLE_STRIPS")) {
            constexpr std::int64_t poly_line = 4, strip = 6, polygon = 7;
            const std::int64_t type = same(word, "LINES")      ? poly_line
                                      : same(word, "POLYGONS") ? polygon
                                                               : strip;
            take_surface_cells(input, type, has_facets, mesh);
        } else if (same(word, "CELL_TYPES")) {
            if (has_types) words.fail("CELL_TYPES come twice");
            has_types = true;
            mesh.has_tetrahedra = true;
            types = read_types(cells, input, mesh);
        }
    }
    VtkCellMarkers markers;
    if (options.has_markers && has_types && has_data)
        markers = read_markers(input, word, types.size());
    if (!has_points) source.fail("has no POINTS");
    if ((is_grid || has_cells) && !has_types)
        source.fail("has no CELL_TYPES; the file is cut short");
    add_cells(cells, types, has_facets, markers, mesh);
    return mesh;
}

void write_mesh(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                const WriteOptions&) {
    OutputFile& out = outputs.open(path);
    out.write(fmt::format("{}3.0\nmgdt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n",
                          magic, mesh.point_count()));
    write_points(mesh.points, {}, out);
    const std::size_t n = mesh.tetrahedron_count(), faces = mesh.faces.size();
    out.write(fmt::format("CELLS {} {}\n", n + faces, 5 * n + 4 * faces));
    write_rows_of_4(mesh.tetrahedra, 0, {{}, "4 "}, out);
    for (std::size_t f = 0; f < faces; ++f) {
        const MeshIndex* const v = &mesh.faces.corners[3 * f];
        out.write(fmt::format("3 {} {} {}\n", v[0], v[1], v[2]));
    }
    out.write(fmt::format("CELL_TYPES {}\n", n + faces));
    for (std::size_t i = 0; i < n; ++i) out.write("10\n");
    for (std::size_t f = 0; f < faces; ++f) out.write("5\n");
    if (mesh.regions.empty()) return;
    out.write(fmt::format("CELL_DATA {}\n", n + faces));
    // Tetrahedra have the array "region" and triangles the array "facet". VTK needs a value for
    // every cell in both, so the array is 0 for cells of the other kind.
    for (const bool of_facets : {false, true}) {
        out.write(fmt::format("SCALARS {} int 1\nLOOKUP_TABLE default\n",
                              of_facets ? "facet" : "region"));
        for (std::size_t i = 0; i < n + faces; ++i) {
            const bool is_face = i >= n;
            out.write_integer(is_face != of_facets ? 0
                              : is_face            ? mesh.faces.markers[i - n]
                                                   : mesh.regions[i]);
            out.write("\n");
        }
    }
}

}  // namespace

const Format& vtk_format() {
    static const Format format = [] {
        Format f = {"vtk",   {".vtk"},  "VTK's legacy files", false, sniff, read_vtk,
                    nullptr, write_mesh};
        f.has_facets = true;
        return f;
    }();
    return format;
}

}  // namespace mgdt::cli
