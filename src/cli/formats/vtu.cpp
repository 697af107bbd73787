// SPDX-License-Identifier: MIT
// VTK's XML unstructured grid (.vtu), as ParaView reads it, and its surfaces (.vtp), of which the
// points are read, and the cells as facets if these are asked for.
// Written with appended raw arrays, each compressed or with a 64-bit length before it; read in
// every form but compression by other libraries than zlib. The fields are the arrays of numbers in
// PointData.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>

#include "cli/errors.hpp"
#include "cli/formats/bytes.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/grid.hpp"
#include "cli/formats/item_type.hpp"
#include "cli/formats/lines.hpp"
#include "cli/formats/number.hpp"
#include "cli/formats/vtk_arrays.hpp"
#include "cli/formats/xml.hpp"

namespace mgdt::cli {
namespace {

constexpr std::size_t none = std::string_view::npos;

using Attributes = std::map<std::string, std::string, std::less<>>;

struct Tag {
    std::string_view name;
    Attributes attributes;
    std::size_t begin = none;  // the position of '<'
    std::size_t end = none;    // the position after '>'
};

// A minimal XML reader: start tags with attributes, and end tags. Comments are skipped.
class TagReader {
  public:
    explicit TagReader(const Source& source) : source_(source) {}

    // Reads the next start or end tag ("/Name"). Returns false at the end of the file.
    bool next(Tag& tag) {
        const std::string_view text = source_.bytes;
        for (;;) {
            const std::size_t open = text.find('<', at_);
            if (open == none) return false;
            if (text.substr(open, 4) == "<!--") {
                at_ = text.find("-->", open);
                if (at_ == none) source_.fail_at_byte(open, "a comment without end");
                continue;
            }
            const std::size_t close = text.find('>', open);
            if (close == none)
                source_.fail_at_byte(open, "a tag without end; the file is cut short");
            at_ = close + 1;
            if (text[open + 1] == '?' || text[open + 1] == '!') continue;
            tag = Tag();
            tag.begin = open;
            tag.end = at_;
            parse(text.substr(open + 1, close - open - 1), tag);
            return true;
        }
    }

  private:
    void parse(std::string_view text, Tag& tag) const {
        constexpr std::string_view blanks = " \t\r\n";
        std::size_t at = text.find_first_of(" \t\r\n/", 1);
        tag.name = text.substr(0, at);
        while (at != none) {
            at = text.find_first_not_of(" \t\r\n/", at);
            if (at == none) return;
            const std::size_t equals = text.find('=', at);
            const std::size_t quote_at =
                equals == none ? none : text.find_first_not_of(blanks, equals + 1);
            if (quote_at == none || (text[quote_at] != '"' && text[quote_at] != '\'')) {
                source_.fail_at_byte(tag.begin, "a malformed attribute");
            }
            const std::size_t end = text.find(text[quote_at], quote_at + 1);
            if (end == none) source_.fail_at_byte(tag.begin, "an attribute without end");
            std::string_view name = text.substr(at, equals - at);
            name = name.substr(0, name.find_first_of(blanks));
            tag.attributes.emplace(name, text.substr(quote_at + 1, end - quote_at - 1));
            at = end + 1;
        }
    }

    const Source& source_;
    std::size_t at_ = 0;
};

std::string attribute(const Tag& tag, std::string_view name, const char* otherwise) {
    const auto found = tag.attributes.find(name);
    return found == tag.attributes.end() ? otherwise : found->second;
}

// The description of the file before its data.
struct Layout {
    bool is_surface = false;  // PolyData: cells are lines and polygons
    std::uint64_t points = 0, cells = 0;
    std::uint64_t lines = 0, strips = 0, polygons = 0;  // the cells of a surface
    // The bytes that may still be decoded; arrays that share bytes would let a small file fill the
    // memory.
    mutable std::uint64_t bytes_left = 0;
    ArrayEncoding encoding;  // of arrays in bytes; appended arrays may be in base64
    std::string compressor;
    std::map<std::string, Tag>
        arrays;  // "points", "connectivity", "offsets", "types"; "Polys offsets"
    std::vector<Tag> fields, cell_data;
    std::size_t appended = none;  // the position after '_'
};

std::uint64_t parse_count(const Source& source, const Tag& tag, const char* name) {
    std::int64_t value = 0;
    const std::string text = attribute(tag, name, "");
    if (!parse_integer(text, value) || value < 0) {
        source.fail_at_byte(tag.begin,
                            fmt::format("{} is {}; a count is needed", name, quote(text)));
    }
    return static_cast<std::uint64_t>(value);
}

Layout parse_layout(const Source& source) {
    Layout layout;
    TagReader reader(source);
    Tag tag;
    std::string_view section;
    bool grid = false;
    int pieces = 0;
    while (reader.next(tag)) {
        if (tag.name == "VTKFile") {
            const std::string type = attribute(tag, "type", "");
            layout.is_surface = type == "PolyData";
            if (!layout.is_surface && type != "UnstructuredGrid") {
                source.fail_at_byte(
                    tag.begin,
                    fmt::format("type {}; UnstructuredGrid or PolyData is needed", quote(type)));
            }
            layout.compressor = attribute(tag, "compressor", "");
            layout.encoding.is_compressed = layout.compressor != "";
            layout.encoding.is_big_endian =
                attribute(tag, "byte_order", "LittleEndian") == "BigEndian";
            layout.encoding.has_wide_header = attribute(tag, "header_type", "UInt32") == "UInt64";
            grid = true;
        } else if (tag.name == "Piece") {
            if (++pieces > 1)
                source.fail_at_byte(tag.begin, "more than one Piece; merge them first");
            layout.points = parse_count(source, tag, "NumberOfPoints");
            if (!layout.is_surface) layout.cells = parse_count(source, tag, "NumberOfCells");
            const auto count = [&](const char* kind, std::uint64_t& of) {
                if (!layout.is_surface || tag.attributes.count(kind) == 0) return;
                of = parse_count(source, tag, kind);
                layout.cells += of;
            };
            count("NumberOfLines", layout.lines);
            count("NumberOfStrips", layout.strips);
            count("NumberOfPolys", layout.polygons);
        } else if (tag.name == "Points" || tag.name == "Cells" || tag.name == "PointData" ||
                   tag.name == "CellData" || tag.name == "Lines" || tag.name == "Strips" ||
                   tag.name == "Polys") {
            section = tag.name;
        } else if (tag.name == "/Points" || tag.name == "/Cells" || tag.name == "/PointData" ||
                   tag.name == "/CellData" || tag.name == "/Lines" || tag.name == "/Strips" ||
                   tag.name == "/Polys") {
            section = "";
        } else if (tag.name == "DataArray" && section == "Points") {
            layout.arrays.emplace("points", tag);
        } else if (tag.name == "DataArray" && section == "Cells") {
            layout.arrays.emplace(attribute(tag, "Name", ""), tag);
        } else if (tag.name == "DataArray" &&
                   (section == "Lines" || section == "Strips" || section == "Polys")) {
            layout.arrays.emplace(fmt::format("{} {}", section, attribute(tag, "Name", "")), tag);
        } else if (tag.name == "DataArray" && section == "PointData") {
            layout.fields.push_back(tag);
        } else if (tag.name == "DataArray" && section == "CellData") {
            layout.cell_data.push_back(tag);
        } else if (tag.name == "AppendedData") {
            layout.encoding.in_base64 = attribute(tag, "encoding", "") != "raw";
            layout.appended = source.bytes.find('_', tag.end);
            if (layout.appended == none)
                source.fail_at_byte(tag.end, "the appended data are missing");
            ++layout.appended;
            break;
        }
    }
    if (!grid || pieces == 0) {
        source.fail_at_byte(0, "not a VTK XML grid, or cut short: no VTKFile with a Piece");
    }
    return layout;
}

// The size of a type; 0 if it is not a type of numbers.
std::size_t item_size(const std::string& type) {
    std::size_t size = 0;
    with_type(type, [&](auto item) { size = sizeof item; });
    return size;
}

// The kinds of arrays: how an item is read from bytes and from text.
struct Coordinates {
    using Item = double;
    template <class T>
    static Item from_bytes(ByteReader& bytes) {
        if constexpr (std::is_floating_point_v<T>) return bytes.coordinate<T>();
        bytes.fail("coordinates of an integer type; Float64 or Float32 is needed");
    }
    static Item from_text(Fields& fields) { return fields.number("coordinate"); }
};

struct Indices {
    using Item = std::int64_t;
    template <class T>
    static Item from_bytes(ByteReader& bytes) {
        if constexpr (std::is_integral_v<T>) return static_cast<Item>(bytes.value<T>("index"));
        bytes.fail("indices of a floating-point type; an integer type is needed");
    }
    static Item from_text(Fields& fields) { return fields.integer("index"); }
};

struct Values {
    using Item = double;
    template <class T>
    static Item from_bytes(ByteReader& bytes) {
        return static_cast<Item>(bytes.value<T>("value"));
    }
    static Item from_text(Fields& fields) { return fields.value("value"); }
};

// Reads the items of an array in bytes.
template <class Kind>
std::vector<typename Kind::Item> items_of(const Source& source, const Layout& layout,
                                          std::size_t begin, const ArrayEncoding& encoding,
                                          const std::string& type, const std::string& name,
                                          std::uint64_t count) {
    const std::size_t size = item_size(type);
    if (count > layout.bytes_left / size)
        source.fail_at_byte(begin, fmt::format("the array {} has {} items; the file has {} bytes",
                                               name, count, source.bytes.size()));
    layout.bytes_left -= count * size;
    std::string copy;
    Source part = source;
    if (encoding.in_base64 || encoding.is_compressed) {
        copy = array_bytes(source, begin, encoding, name, count * size);
        part.bytes = copy;
        begin = 0;
    } else {
        const std::size_t header = encoding.has_wide_header ? 8 : 4;
        ByteReader bytes(source, begin, encoding.is_big_endian);
        const std::uint64_t length = encoding.has_wide_header
                                         ? bytes.value<std::uint64_t>("array length")
                                         : bytes.value<std::uint32_t>("array length");
        if (length / size != count || length % size != 0) {
            bytes.fail(fmt::format("the array {} has {} bytes; {} items of {} bytes are announced",
                                   name, length, count, size));
        }
        begin += header;
    }
    ByteReader bytes(part, begin, encoding.is_big_endian);
    bytes.need(count, size, "items of the array");
    std::vector<typename Kind::Item> out(static_cast<std::size_t>(count));
    with_type(type, [&](auto item) {
        for (auto& v : out) v = Kind::template from_bytes<decltype(item)>(bytes);
    });
    return out;
}

// Reads one DataArray of `count` items.
template <class Kind>
std::vector<typename Kind::Item> read_array(const Source& source, const Layout& layout,
                                            const Tag& tag, const std::string& name,
                                            std::uint64_t count) {
    const std::string type = attribute(tag, "type", "");
    const std::string format = attribute(tag, "format", "ascii");
    const std::size_t size = item_size(type);
    if (size == 0) {
        source.fail_at_byte(tag.begin,
                            fmt::format("arrays of type {} cannot be read", quote(type)));
    }
    if (format != "ascii" && layout.encoding.is_compressed &&
        (layout.compressor != "vtkZLibDataCompressor" || !can_compress()))
        source.fail_at_byte(tag.begin,
                            fmt::format("arrays compressed by {}, which this program cannot "
                                        "expand; save the file uncompressed",
                                        quote(layout.compressor)));
    if (format == "appended") {
        const std::uint64_t offset = parse_count(source, tag, "offset");
        if (layout.appended == none) source.fail("the appended data are missing");
        if (offset > source.bytes.size() - layout.appended)
            source.fail_at_byte(
                tag.begin,
                fmt::format("offset {} is behind the end; the file is cut short", offset));
        return items_of<Kind>(source, layout, layout.appended + static_cast<std::size_t>(offset),
                              layout.encoding, type, name, count);
    }
    if (format == "binary") {
        ArrayEncoding encoding = layout.encoding;
        encoding.in_base64 = true;
        return items_of<Kind>(source, layout, tag.end, encoding, type, name, count);
    }
    if (format != "ascii") {
        source.fail_at_byte(tag.begin,
                            fmt::format("format {} of an array is not known", quote(format)));
    }
    const std::size_t end = source.bytes.find('<', tag.end);
    if (end == none) source.fail_at_byte(tag.end, "the array has no end; the file is cut short");
    if (count > (end - tag.end) / 2 + 1) {
        source.fail_at_byte(
            tag.end, fmt::format("{} values announced, but {} bytes follow", count, end - tag.end));
    }
    Source part = source;
    part.bytes = source.bytes.substr(0, end);
    std::size_t line = 1;
    for (const char c : source.bytes.substr(0, tag.end)) line += c == '\n' ? 1 : 0;
    LineReader lines(part, tag.end, line);
    std::vector<typename Kind::Item> out;
    out.reserve(static_cast<std::size_t>(count));
    while (lines.next_with_text('<')) {
        Fields fields(lines);
        std::string_view word;
        for (Fields ahead = fields; ahead.next(word);) {
            if (out.size() == count) lines.fail("more values than announced");
            out.push_back(Kind::from_text(fields));
        }
    }
    if (out.size() != count) {
        lines.fail(fmt::format("{} values; {} are announced", out.size(), count));
    }
    return out;
}

template <class Kind>
std::vector<typename Kind::Item> read_array(const Source& source, const Layout& layout,
                                            const char* name, std::uint64_t count) {
    const auto found = layout.arrays.find(name);
    if (found == layout.arrays.end()) {
        if (count == 0) return {};
        source.fail(fmt::format("the array {} is missing", name));
    }
    return read_array<Kind>(source, layout, found->second, name, count);
}

std::vector<Field> read_fields(const Source& source, const Layout& layout,
                               const ReadOptions& options) {
    std::vector<std::string> names;
    std::vector<Field> fields;
    for (const Tag& tag : layout.fields) {
        const std::size_t size = item_size(attribute(tag, "type", ""));
        const std::uint64_t components = tag.attributes.count("NumberOfComponents") != 0
                                             ? parse_count(source, tag, "NumberOfComponents")
                                             : 1;
        if (size == 0 || components == 0) continue;
        const std::string name = from_xml(attribute(tag, "Name", ""));
        names.push_back(name);
        if (!wants_field(options, name)) continue;
        if (layout.points == 0) continue;
        // Text has at least one byte per value.
        const bool is_text = attribute(tag, "format", "ascii") == "ascii";
        const std::uint64_t most = is_text ? source.bytes.size() : layout.bytes_left / size;
        if (components > most / layout.points) {
            source.fail_at_byte(tag.begin,
                                fmt::format("{} components at {} points: more than the file has",
                                            components, layout.points));
        }
        fields.push_back({name, static_cast<std::size_t>(components), {}});
        fields.back().values =
            read_array<Values>(source, layout, tag, quote(name), layout.points * components);
    }
    require_fields(source, options, names);
    return fields;
}

bool sniff(std::string_view bytes) {
    const std::string_view start = bytes.substr(0, 1024);
    return start.find("<VTKFile") != none;
}

// The vertices of all cells, of which the last one ends at offsets.back(). `bytes` is an upper
// bound on the number of bytes in the file.
std::vector<std::int64_t> read_vertices(const Source& source, const Layout& layout,
                                        const char* name, const std::vector<std::int64_t>& offsets,
                                        std::uint64_t bytes) {
    const std::int64_t length = offsets.empty() ? 0 : offsets.back();
    if (length < 0 || static_cast<std::uint64_t>(length) > bytes) {
        source.fail(fmt::format("the last cell's offset is {}", length));
    }
    return read_array<Indices>(source, layout, name, static_cast<std::uint64_t>(length));
}

// Reads the cells of one type of a surface as facets or segments.
void read_surface_cells(const Source& source, const Layout& layout, const std::string& section,
                        std::uint64_t count, std::int64_t type, std::uint64_t bytes,
                        FileFacets& facets) {
    const std::string offsets_name = section + " offsets",
                      vertices_name = section + " connectivity";
    const auto offsets = read_array<Indices>(source, layout, offsets_name.c_str(), count);
    const auto vertices = read_vertices(source, layout, vertices_name.c_str(), offsets, bytes);
    std::int64_t begin = 0;
    for (const std::int64_t end : offsets) {
        if (end < begin || end > static_cast<std::int64_t>(vertices.size()))
            source.fail(fmt::format("{}: offset {} after {}", section, end, begin));
        add_vtk_facet(type, vertices.data() + begin, static_cast<std::size_t>(end - begin), facets);
        begin = end;
    }
}

// Reads the first of some arrays of cell data that there is; empty if there is none.
template <std::size_t n>
std::vector<std::int32_t> read_markers(const Source& source, const Layout& layout,
                                       const char* const (&names)[n]) {
    for (const char* const name : names)
        for (const Tag& tag : layout.cell_data) {
            if (from_xml(attribute(tag, "Name", "")) != name ||
                attribute(tag, "NumberOfComponents", "1") != "1")
                continue;
            const auto values = read_array<Values>(source, layout, tag, name, layout.cells);
            return vtk_markers_of(values, [&](std::size_t cell, double value) {
                source.fail_at_byte(tag.begin, fmt::format("{} of cell {}: {} is no 32-bit integer",
                                                           name, cell, value));
            });
        }
    return {};
}

// Reads the tetrahedra and counts other cells, or reads them as facets.
void read_cells(const Source& source, const Layout& layout, std::uint64_t bytes, bool has_facets,
                const VtkCellMarkers& markers, Mesh& mesh) {
    const auto types = read_array<Indices>(source, layout, "types", layout.cells);
    const auto offsets = read_array<Indices>(source, layout, "offsets", layout.cells);
    const std::int64_t length = offsets.empty() ? 0 : offsets.back();
    const auto vertices = read_vertices(source, layout, "connectivity", offsets, bytes);
    mesh.has_tetrahedra = true;
    std::int64_t begin = 0;
    for (std::size_t i = 0; i < types.size(); ++i) {
        const std::int64_t end = offsets[i];
        if (end < begin || end > length) {
            source.fail(fmt::format("cell {}: offset {} after {}", i, end, begin));
        }
        const auto nodes = static_cast<std::size_t>(end - begin);
        if (!is_vtk_tetrahedron(types[i])) {
            ++mesh.other_cells;
            if (has_facets)
                add_vtk_facet(types[i], vertices.data() + begin, nodes, mesh.facets,
                              markers.facet(i));
        } else if (!may_have_nodes(types[i], nodes)) {
            source.fail(fmt::format("cell {}: a tetrahedron of type {} with {} vertices", i,
                                    types[i], nodes));
        } else {
            const std::int64_t* first = vertices.data() + begin;
            for (const std::int64_t* v = first; v < first + nodes; ++v) {
                if (*v >= 0 && static_cast<std::uint64_t>(*v) < layout.points) continue;
                source.fail(fmt::format("cell {}: vertex {}, but there are {} points", i, *v,
                                        layout.points));
            }
            add_vtk_tetrahedron(first, nodes, markers, i, mesh);
        }
        begin = end;
    }
}

Mesh read_vtu(const Source& source, const ReadOptions& options) {
    const Layout layout = parse_layout(source);
    const std::uint64_t bytes =
        source.bytes.size() * (layout.encoding.is_compressed ? most_expansion : 1);
    layout.bytes_left = bytes;
    if (layout.points > bytes || layout.cells > bytes) {
        source.fail(fmt::format("{} points and {} cells cannot be in {} bytes", layout.points,
                                layout.cells, source.bytes.size()));
    }
    Mesh mesh;
    mesh.detail = layout.is_surface ? "PolyData" : "UnstructuredGrid";
    mesh.points = read_array<Coordinates>(source, layout, "points", 3 * layout.points);
    if (options.has_fields) mesh.fields = read_fields(source, layout, options);
    if (layout.is_surface) {
        mesh.other_cells = layout.cells;
        if (options.has_facets) {
            constexpr std::int64_t poly_line = 4, strip = 6, polygon = 7;
            read_surface_cells(source, layout, "Lines", layout.lines, poly_line, bytes,
                               mesh.facets);
            read_surface_cells(source, layout, "Strips", layout.strips, strip, bytes, mesh.facets);
            read_surface_cells(source, layout, "Polys", layout.polygons, polygon, bytes,
                               mesh.facets);
        }
        return mesh;
    }
    VtkCellMarkers markers;
    if (options.has_markers) {
        markers.regions = read_markers(source, layout, vtk_region_arrays);
        markers.facets = read_markers(source, layout, vtk_facet_arrays);
    }
    read_cells(source, layout, bytes, options.has_facets || options.has_markers, markers, mesh);
    return mesh;
}

void write_mesh(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                const WriteOptions& options) {
    write_grid({mesh.points, &mesh.tetrahedra, 4, vtk_tetra, mesh.fields, nullptr, options.compress,
                mesh.regions.empty() ? nullptr : &mesh.regions,
                mesh.regions.empty() ? nullptr : &mesh.faces},
               outputs.open(path));
}

// ParaView does not show points without cells, so each point is a cell if there are no tetrahedra.
void write_fields(const Mesh& mesh, OutputFile& out, const WriteOptions& options) {
    if (mesh.tetrahedron_count() > 0) {
        write_grid(
            {mesh.points, &mesh.tetrahedra, 4, vtk_tetra, mesh.fields, nullptr, options.compress},
            out);
    } else {
        write_grid({mesh.points, nullptr, 1, vtk_vertex, mesh.fields, nullptr, options.compress},
                   out);
    }
}

void write_surface(const Surface& surface, OutputFile& out, const WriteOptions& options) {
    write_vtk_surface(surface, options.compress, out);
}

}  // namespace

const Format& vtu_format() {
    static const Format format = [] {
        Format f = {"vtu",       {".vtu"},   "VTK unstructured grid, for ParaView",
                    true,        sniff,      read_vtu,
                    nullptr,     write_mesh, nullptr,
                    write_fields};
        f.has_facets = true;
        return f;
    }();
    return format;
}

const Format& vtp_format() {
    static const Format format = [] {
        Format f = {"vtp",   {".vtp"}, "VTK's surfaces; points and facets are read",
                    true,    nullptr,  read_vtu,
                    nullptr, nullptr};
        f.write_surface = write_surface;
        f.has_facets = true;
        return f;
    }();
    return format;
}

}  // namespace mgdt::cli
