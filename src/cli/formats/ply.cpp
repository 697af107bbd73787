// SPDX-License-Identifier: MIT
// PLY, the Stanford polygon format: reads x, y and z of the element "vertex", in any scalar type,
// in text or binary of either byte order, and the lists of vertices of the element "face" if facets
// are asked for. Other properties and elements are skipped.
#include <fmt/core.h>

#include <array>

#include "cli/errors.hpp"
#include "cli/formats/bytes.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"

namespace mgdt::cli {
namespace {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

std::size_t size_of(Type type) {
    constexpr std::array<std::size_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

struct Property {
    bool list = false;
    Type count = Type::u8;  // the type of the length, if this is a list
    Type type = Type::f32;
    int axis = -1;         // 0, 1 or 2 for x, y or z of the vertices
    bool corners = false;  // the list of a face's vertices
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
    bool vertices = false;
    bool faces = false;

    std::size_t least_bytes() const {
        std::size_t sum = 0;
        for (const Property& p : properties) sum += size_of(p.list ? p.count : p.type);
        return sum;
    }
    bool has_lists() const {
        for (const Property& p : properties) {
            if (p.list) return true;
        }
        return false;
    }
};

enum class Encoding { ascii, little, big };

struct Header {
    Encoding encoding = Encoding::ascii;
    std::vector<Element> elements;
};

bool sniff(std::string_view bytes) {
    return bytes.substr(0, 4) == "ply\n" || bytes.substr(0, 4) == "ply\r";
}

Type parse_type(const LineReader& lines, std::string_view word) {
    struct Name {
        std::string_view name;
        Type type;
    };
    static constexpr Name names[] = {
        {"char", Type::i8},    {"int8", Type::i8},     {"uchar", Type::u8},
        {"uint8", Type::u8},   {"short", Type::i16},   {"int16", Type::i16},
        {"ushort", Type::u16}, {"uint16", Type::u16},  {"int", Type::i32},
        {"int32", Type::i32},  {"uint", Type::u32},    {"uint32", Type::u32},
        {"float", Type::f32},  {"float32", Type::f32}, {"double", Type::f64},
        {"float64", Type::f64}};
    for (const Name& n : names) {
        if (n.name == word) return n.type;
    }
    lines.fail(fmt::format("unknown type {}", quote(word)));
}

void parse_property(const LineReader& lines, Fields& fields, Element& element) {
    Property property;
    std::string_view word = fields.word("the property's type");
    if (word == "list") {
        property.list = true;
        property.count = parse_type(lines, fields.word("the type of the list's length"));
        if (property.count == Type::f32 || property.count == Type::f64) {
            lines.fail("the length of a list must be an integer");
        }
        word = fields.word("the type of the list's items");
    }
    property.type = parse_type(lines, word);
    const std::string_view name = fields.word("the property's name");
    if (element.vertices && name.size() == 1 && name[0] >= 'x' && name[0] <= 'z') {
        property.axis = name[0] - 'x';
        if (property.list) lines.fail(fmt::format("{} is a list; a number is needed", quote(name)));
        for (const Property& other : element.properties) {
            if (other.axis == property.axis) lines.fail(fmt::format("{} comes twice", quote(name)));
        }
    }
    property.corners =
        element.faces && property.list && (name == "vertex_indices" || name == "vertex_index");
    element.properties.push_back(property);
    if (element.properties.size() > 4096) lines.fail("more than 4096 properties");
}

Header parse_header(LineReader& lines) {
    if (!lines.next() || lines.text() != "ply") {
        lines.source().fail_at_line(1, "not a PLY file: it does not begin with \"ply\"");
    }
    Header header;
    bool format = false;
    int vertex_elements = 0;
    for (;;) {
        if (!lines.next()) lines.fail("the header has no end_header; the file is cut short");
        Fields fields(lines);
        std::string_view word;
        if (!fields.next(word) || word == "comment" || word == "obj_info") continue;
        if (word == "end_header") break;
        if (word == "format") {
            const std::string_view name = fields.word("the encoding");
            const std::string_view version = fields.word("the version");
            if (name == "ascii") {
                header.encoding = Encoding::ascii;
            } else if (name == "binary_little_endian") {
                header.encoding = Encoding::little;
            } else if (name == "binary_big_endian") {
                header.encoding = Encoding::big;
            } else {
                lines.fail(fmt::format("unknown encoding {}", quote(name)));
            }
            if (version != "1.0")
                lines.fail(fmt::format("version {}; 1.0 is known", quote(version)));
            format = true;
        } else if (word == "element") {
            Element element;
            element.name = std::string(fields.word("the element's name"));
            element.count = static_cast<std::uint64_t>(
                fields.integer("the element's count", 0, std::int64_t{1} << 62));
            element.vertices = element.name == "vertex";
            element.faces = element.name == "face";
            if (element.vertices) ++vertex_elements;
            header.elements.push_back(std::move(element));
            if (header.elements.size() > 4096) lines.fail("more than 4096 elements");
        } else if (word == "property") {
            if (header.elements.empty()) lines.fail("a property before the first element");
            parse_property(lines, fields, header.elements.back());
        } else {
            lines.fail(fmt::format("unknown keyword {}", quote(word)));
        }
    }
    if (!format) lines.fail("the header has no format line");
    if (vertex_elements != 1) {
        lines.fail(fmt::format("{} elements named vertex; 1 is needed", vertex_elements));
    }
    for (const Element& e : header.elements) {
        int axes = 0;
        for (const Property& p : e.properties) axes += p.axis >= 0 ? 1 : 0;
        if (e.vertices && axes != 3) lines.fail("the vertices have no x, y and z");
    }
    return header;
}

void read_ascii(LineReader& lines, const Element& element, bool has_facets, Mesh& mesh) {
    std::vector<double>& points = mesh.points;
    const bool is_read = element.vertices || (element.faces && has_facets);
    // Each property takes at least a digit and a separator.
    if (element.properties.empty()) return;
    if (element.count > lines.bytes_left() / (2 * element.properties.size()) + 1) {
        lines.fail(
            fmt::format("element {} announces {} entries, but only {} bytes follow; the "
                        "file is cut short or its header is wrong",
                        quote(element.name), element.count, lines.bytes_left()));
    }
    if (element.vertices) points.reserve(3 * static_cast<std::size_t>(element.count));
    for (std::uint64_t i = 0; i < element.count; ++i) {
        if (!lines.next_with_text(no_comment)) {
            lines.fail(fmt::format("the file ends after {} of {} entries of element {}", i,
                                   element.count, quote(element.name)));
        }
        if (!is_read) continue;
        Fields fields(lines);
        double xyz[3] = {};
        for (const Property& p : element.properties) {
            if (p.list) {
                const std::int64_t n = fields.integer("the length of a list", 0, 0x7FFFFFFF);
                for (std::int64_t k = 0; k < n; ++k) {
                    if (p.corners)
                        mesh.facets.corners.push_back(fields.integer("a corner of a face"));
                    else
                        fields.word("an item of a list");
                }
                if (p.corners) mesh.facets.end_facet();
            } else if (p.axis >= 0) {
                xyz[p.axis] = fields.number("coordinate");
            } else {
                fields.word("a property");
            }
        }
        if (element.vertices) points.insert(points.end(), xyz, xyz + 3);
    }
}

double read_scalar(ByteReader& bytes, Type type) {
    switch (type) {
        case Type::i8:
            return bytes.coordinate<std::int8_t>();
        case Type::u8:
            return bytes.coordinate<std::uint8_t>();
        case Type::i16:
            return bytes.coordinate<std::int16_t>();
        case Type::u16:
            return bytes.coordinate<std::uint16_t>();
        case Type::i32:
            return bytes.coordinate<std::int32_t>();
        case Type::u32:
            return bytes.coordinate<std::uint32_t>();
        case Type::f32:
            return bytes.coordinate<float>();
        case Type::f64:
            return bytes.coordinate<double>();
    }
    return 0;
}

// A corner of a face; -1, which is no point, for a number that cannot be one.
std::int64_t corner_of(double x) {
    return x >= 0 && x <= static_cast<double>(most_in_mesh) ? static_cast<std::int64_t>(x) : -1;
}

void read_binary(ByteReader& bytes, const Element& element, bool has_facets, Mesh& mesh) {
    std::vector<double>& points = mesh.points;
    const std::size_t least = element.least_bytes();
    if (least == 0) return;
    const std::string what = fmt::format("entries of element {}", quote(element.name));
    bytes.need(element.count, least, what.c_str());
    if (!element.vertices && !element.has_lists()) {
        bytes.skip(element.count, least, what.c_str());
        return;
    }
    if (element.vertices) points.reserve(3 * static_cast<std::size_t>(element.count));
    for (std::uint64_t i = 0; i < element.count; ++i) {
        double xyz[3] = {};
        for (const Property& p : element.properties) {
            if (p.list) {
                const double n = read_scalar(bytes, p.count);
                if (n < 0) bytes.fail(fmt::format("a list of length {}", n));
                if (!p.corners || !has_facets) {
                    bytes.skip(static_cast<std::uint64_t>(n), size_of(p.type), "items of a list");
                    continue;
                }
                bytes.need(static_cast<std::uint64_t>(n), size_of(p.type), "corners of a face");
                for (double k = 0; k < n; ++k)
                    mesh.facets.corners.push_back(corner_of(read_scalar(bytes, p.type)));
                mesh.facets.end_facet();
            } else if (p.axis >= 0) {
                xyz[p.axis] = read_scalar(bytes, p.type);
            } else {
                bytes.skip(1, size_of(p.type), "properties");
            }
        }
        if (element.vertices) points.insert(points.end(), xyz, xyz + 3);
    }
}

Mesh read_ply(const Source& source, const ReadOptions& options) {
    LineReader lines(source);
    const Header header = parse_header(lines);
    Mesh mesh;
    if (header.encoding == Encoding::ascii) {
        mesh.detail = "ascii";
        for (const Element& e : header.elements) read_ascii(lines, e, options.has_facets, mesh);
        if (lines.next_with_text(no_comment))
            lines.fail("text after the last element; correct the counts");
    } else {
        const bool big = header.encoding == Encoding::big;
        mesh.detail = big ? "binary, big endian" : "binary, little endian";
        ByteReader bytes(source, lines.offset(), big);
        for (const Element& e : header.elements) read_binary(bytes, e, options.has_facets, mesh);
        if (bytes.left() > 0) {
            bytes.fail(
                fmt::format("{} bytes after the last element; correct the counts", bytes.left()));
        }
    }
    return mesh;
}

void write_ply_points(const std::vector<double>& points, OutputFile& out, const WriteOptions&) {
    out.write(
        fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
                    "property double x\nproperty double y\nproperty double z\nend_header\n",
                    points.size() / 3));
    out.write_values(points.data(), points.size());
}

void write_surface(const Surface& surface, OutputFile& out, const WriteOptions&) {
    out.write(
        fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
                    "property double x\nproperty double y\nproperty double z\n"
                    "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                    surface.point_count(), surface.triangle_count()));
    out.write_values(surface.points.data(), surface.points.size());
    for (std::size_t i = 0; i < surface.triangles.size(); i += 3) {
        out.write_value<std::uint8_t>(3);
        out.write_values(surface.triangles.data() + i, 3);
    }
}

}  // namespace

const Format& ply_format() {
    static const Format format = [] {
        Format f = {"ply",
                    {".ply"},
                    "PLY; vertices and facets are read",
                    true,
                    sniff,
                    read_ply,
                    write_ply_points,
                    nullptr};
        f.write_surface = write_surface;
        f.has_facets = true;
        return f;
    }();
    return format;
}

}  // namespace mgdt::cli
