// SPDX-License-Identifier: MIT
// VTK's XML unstructured grid (.vtu), as ParaView reads it. Written with appended raw arrays
// (a 64-bit length before each); read in the same form, or with arrays as text.
#include <fmt/format.h>

#include <limits>
#include <map>

#include "cli/errors.hpp"
#include "cli/formats/bytes.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"
#include "cli/formats/number.hpp"

namespace mgdt::cli {
namespace {

constexpr std::uint8_t vtk_tetra = 10;
constexpr std::size_t none = std::string_view::npos;

using Attributes = std::map<std::string, std::string, std::less<>>;

struct Tag {
    std::string_view name;
    Attributes attributes;
    std::size_t begin = none;  // of the '<'
    std::size_t end = none;    // after the '>'
};

// Just enough XML: start tags and their attributes, end tags by name. Comments are passed over.
class TagReader {
  public:
    explicit TagReader(const Source& source) : source_(source) {}

    // The next start or end tag ("/Name"); false at the end of the file.
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

// What the file says of itself before its data.
struct Layout {
    std::uint64_t points = 0, cells = 0;
    bool big_endian = false;
    bool wide_header = false;
    std::map<std::string, Tag> arrays;  // "points", "connectivity", "offsets", "types"
    std::size_t appended = none;        // the first byte after '_'
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
            if (type != "UnstructuredGrid") {
                source.fail_at_byte(
                    tag.begin, fmt::format("type {}; UnstructuredGrid is needed", quote(type)));
            }
            if (tag.attributes.count("compressor") != 0) {
                source.fail_at_byte(tag.begin, "compressed arrays; save the file uncompressed");
            }
            layout.big_endian = attribute(tag, "byte_order", "LittleEndian") == "BigEndian";
            layout.wide_header = attribute(tag, "header_type", "UInt32") == "UInt64";
            grid = true;
        } else if (tag.name == "Piece") {
            if (++pieces > 1)
                source.fail_at_byte(tag.begin, "more than one Piece; merge them first");
            layout.points = parse_count(source, tag, "NumberOfPoints");
            layout.cells = parse_count(source, tag, "NumberOfCells");
        } else if (tag.name == "Points" || tag.name == "Cells") {
            section = tag.name;
        } else if (tag.name == "/Points" || tag.name == "/Cells") {
            section = "";
        } else if (tag.name == "DataArray" && section == "Points") {
            layout.arrays.emplace("points", tag);
        } else if (tag.name == "DataArray" && section == "Cells") {
            layout.arrays.emplace(attribute(tag, "Name", ""), tag);
        } else if (tag.name == "AppendedData") {
            if (attribute(tag, "encoding", "") != "raw") {
                source.fail_at_byte(tag.begin,
                                    "appended data in base64; save the file with raw encoding");
            }
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

template <class T>
void read_values(ByteReader& bytes, std::vector<double>& out) {
    for (double& v : out) v = bytes.coordinate<T>();
}

template <class T>
void read_values(ByteReader& bytes, std::vector<std::int64_t>& out) {
    for (std::int64_t& v : out) v = static_cast<std::int64_t>(bytes.value<T>("index"));
}

std::size_t item_size(const Source& source, const Tag& tag, const std::string& type) {
    if (type == "Float64" || type == "Int64" || type == "UInt64") return 8;
    if (type == "Float32" || type == "Int32" || type == "UInt32") return 4;
    if (type == "UInt8" || type == "Int8") return 1;
    source.fail_at_byte(tag.begin, fmt::format("arrays of type {} cannot be read", quote(type)));
}

void read_any(ByteReader& bytes, const std::string& type, std::vector<double>& out) {
    if (type == "Float64") {
        read_values<double>(bytes, out);
    } else if (type == "Float32") {
        read_values<float>(bytes, out);
    } else {
        bytes.fail(
            fmt::format("coordinates of type {}; Float64 or Float32 is needed", quote(type)));
    }
}

void read_any(ByteReader& bytes, const std::string& type, std::vector<std::int64_t>& out) {
    if (type == "Int64" || type == "UInt64") {
        read_values<std::int64_t>(bytes, out);
    } else if (type == "Int32") {
        read_values<std::int32_t>(bytes, out);
    } else if (type == "UInt32") {
        read_values<std::uint32_t>(bytes, out);
    } else if (type == "UInt8" || type == "Int8") {
        read_values<std::uint8_t>(bytes, out);
    } else {
        bytes.fail(fmt::format("indices of type {}; an integer type is needed", quote(type)));
    }
}

void read_word(Fields& fields, double& out) {
    out = fields.number("coordinate");
}
void read_word(Fields& fields, std::int64_t& out) {
    out = fields.integer("index");
}

// One DataArray of `count` values.
template <class T>
std::vector<T> read_array(const Source& source, const Layout& layout, const char* name,
                          std::uint64_t count) {
    const auto found = layout.arrays.find(name);
    if (found == layout.arrays.end()) source.fail(fmt::format("the array {} is missing", name));
    const Tag& tag = found->second;
    const std::string type = attribute(tag, "type", "");
    const std::string format = attribute(tag, "format", "ascii");
    const std::size_t size = item_size(source, tag, type);
    std::vector<T> out;
    if (format == "appended") {
        const std::uint64_t offset = parse_count(source, tag, "offset");
        if (layout.appended == none) source.fail("the appended data are missing");
        ByteReader bytes(source, layout.appended, layout.big_endian);
        bytes.skip(offset, 1, "bytes before the array");
        const std::uint64_t length = layout.wide_header
                                         ? bytes.value<std::uint64_t>("array length")
                                         : bytes.value<std::uint32_t>("array length");
        if (length / size != count || length % size != 0) {
            bytes.fail(fmt::format("the array {} has {} bytes; {} items of {} bytes are announced",
                                   name, length, count, size));
        }
        bytes.need(count, size, "items of the array");
        out.resize(static_cast<std::size_t>(count));
        read_any(bytes, type, out);
        return out;
    }
    if (format != "ascii") {
        source.fail_at_byte(tag.begin, fmt::format("format {}; save the file with appended raw or "
                                                   "ascii arrays",
                                                   quote(format)));
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
    out.reserve(static_cast<std::size_t>(count));
    while (lines.next_with_text('<')) {
        Fields fields(lines);
        std::string_view word;
        for (Fields ahead = fields; ahead.next(word);) {
            if (out.size() == count) lines.fail("more values than announced");
            read_word(fields, out.emplace_back());
        }
    }
    if (out.size() != count) {
        lines.fail(fmt::format("{} values; {} are announced", out.size(), count));
    }
    return out;
}

bool sniff(std::string_view bytes) {
    const std::string_view start = bytes.substr(0, 1024);
    return start.find("<VTKFile") != none;
}

Mesh read_vtu(const Source& source, const ReadOptions&) {
    const Layout layout = parse_layout(source);
    const std::uint64_t bytes = source.bytes.size();
    if (layout.points > bytes || layout.cells > bytes) {
        source.fail(fmt::format("{} points and {} cells cannot be in {} bytes", layout.points,
                                layout.cells, bytes));
    }
    Mesh mesh;
    mesh.detail = "UnstructuredGrid";
    mesh.points = read_array<double>(source, layout, "points", 3 * layout.points);
    const auto types = read_array<std::int64_t>(source, layout, "types", layout.cells);
    const auto offsets = read_array<std::int64_t>(source, layout, "offsets", layout.cells);
    const std::int64_t length = offsets.empty() ? 0 : offsets.back();
    if (length < 0 || static_cast<std::uint64_t>(length) > bytes) {
        source.fail(fmt::format("the last cell's offset is {}", length));
    }
    const auto vertices = read_array<std::int64_t>(source, layout, "connectivity",
                                                   static_cast<std::uint64_t>(length));
    mesh.has_tetrahedra = true;
    std::int64_t begin = 0;
    for (std::size_t i = 0; i < types.size(); ++i) {
        const std::int64_t end = offsets[i];
        if (end < begin || end > length) {
            source.fail(fmt::format("cell {}: offset {} after {}", i, end, begin));
        }
        if (types[i] != vtk_tetra) {
            ++mesh.other_cells;
        } else {
            if (end - begin != 4) {
                source.fail(fmt::format("cell {}: a tetrahedron of {} vertices", i, end - begin));
            }
            for (std::int64_t k = begin; k < end; ++k) {
                const std::int64_t v = vertices[static_cast<std::size_t>(k)];
                if (v < 0 || static_cast<std::uint64_t>(v) >= layout.points) {
                    source.fail(fmt::format("cell {}: vertex {}, but there are {} points", i, v,
                                            layout.points));
                }
                mesh.tetrahedra.push_back(v);
            }
        }
        begin = end;
    }
    return mesh;
}

void write_mesh(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                const WriteOptions&) {
    OutputFile& out = outputs.open(path);
    const std::uint64_t points = mesh.points.size() * 8;
    const std::uint64_t vertices = mesh.tetrahedra.size() * 8;
    const std::uint64_t cells = mesh.tetrahedron_count();
    const auto array = [](const char* type, const char* rest, std::uint64_t offset) {
        return fmt::format(
            "        <DataArray type=\"{}\" {} format=\"appended\" offset=\"{}\"/>\n", type, rest,
            offset);
    };
    std::uint64_t offset = 0;
    std::string head = fmt::format(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n"
        "  <UnstructuredGrid>\n"
        "    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n"
        "      <Points>\n",
        mesh.point_count(), cells);
    head += array("Float64", "Name=\"Points\" NumberOfComponents=\"3\"", offset);
    offset += 8 + points;
    head += "      </Points>\n      <Cells>\n";
    head += array("Int64", "Name=\"connectivity\"", offset);
    offset += 8 + vertices;
    head += array("Int64", "Name=\"offsets\"", offset);
    offset += 8 + 8 * cells;
    head += array("UInt8", "Name=\"types\"", offset);
    head +=
        "      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n"
        "  <AppendedData encoding=\"raw\">\n_";
    out.write(head);
    out.write_value(points);
    out.write_values(mesh.points.data(), mesh.points.size());
    out.write_value(vertices);
    out.write_values(mesh.tetrahedra.data(), mesh.tetrahedra.size());
    out.write_value(8 * cells);
    for (std::uint64_t i = 1; i <= cells; ++i) out.write_value(static_cast<std::int64_t>(4 * i));
    out.write_value(cells);
    for (std::uint64_t i = 0; i < cells; ++i) out.write_value(vtk_tetra);
    out.write("\n  </AppendedData>\n</VTKFile>\n");
}

}  // namespace

const Format& vtu_format() {
    static const Format format = {"vtu",   {".vtu"},  "VTK unstructured grid, for ParaView",
                                  true,    sniff,     read_vtu,
                                  nullptr, write_mesh};
    return format;
}

}  // namespace mgdt::cli
