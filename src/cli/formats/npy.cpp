// SPDX-License-Identifier: MIT
// NumPy's .npy, versions 1.0 to 3.0 (numpy.lib.format): a magic string, the length of the header,
// the header (a Python dictionary with type, order and shape), and the bytes of the array.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "cli/errors.hpp"
#include "cli/formats/bytes.hpp"
#include "cli/formats/format.hpp"

namespace mgdt::cli {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

struct Header {
    std::string type;  // "<f8"
    bool fortran_order = false;
    std::vector<std::uint64_t> shape;
    std::size_t data = 0;  // the position of the array
    int version = 1;

    char order() const { return type[0]; }
    std::string kind() const { return type.substr(1); }
};

// Parses the header, whose grammar is a small part of Python's.
class HeaderParser {
  public:
    HeaderParser(const Source& source, std::size_t begin, std::size_t end)
        : source_(source), at_(begin), end_(end) {}

    Header parse() {
        Header header;
        bool type = false, order = false, shape = false;
        expect('{');
        while (!accept('}')) {
            const std::string key = string();
            expect(':');
            if (key == "descr") {
                if (peek() == '[') fail("a structured array; save a plain array of shape (n, 3)");
                header.type = string();
                type = true;
            } else if (key == "fortran_order") {
                header.fortran_order = boolean();
                order = true;
            } else if (key == "shape") {
                header.shape = tuple();
                shape = true;
            } else {
                fail(fmt::format("unknown key {}", quote(key)));
            }
            if (!accept(',')) {
                expect('}');
                break;
            }
        }
        if (!type || !order || !shape) fail("descr, fortran_order or shape is missing");
        return header;
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        source_.fail_at_byte(at_, "NumPy header: " + what);
    }
    char peek() {
        while (at_ < end_ && (source_.bytes[at_] == ' ' || source_.bytes[at_] == '\n')) ++at_;
        return at_ < end_ ? source_.bytes[at_] : '\0';
    }
    bool accept(char c) {
        if (peek() != c || at_ >= end_) return false;
        ++at_;
        return true;
    }
    void expect(char c) {
        if (!accept(c)) fail(fmt::format("'{}' expected", c));
    }
    std::string string() {
        const char q = peek();
        if (q != '\'' && q != '"') fail("a string expected");
        const std::size_t begin = ++at_;
        while (at_ < end_ && source_.bytes[at_] != q) ++at_;
        if (at_ >= end_) fail("a string without end");
        return std::string(source_.bytes.substr(begin, at_++ - begin));
    }
    bool boolean() {
        peek();
        for (const std::string_view word : {"True", "False"}) {
            if (source_.bytes.substr(at_, std::min(word.size(), end_ - at_)) == word) {
                at_ += word.size();
                return word == "True";
            }
        }
        fail("True or False expected");
    }
    std::vector<std::uint64_t> tuple() {
        std::vector<std::uint64_t> values;
        expect('(');
        while (!accept(')')) {
            char c = peek();
            if (c < '0' || c > '9') fail("a number expected");
            std::uint64_t value = 0;
            for (; at_ < end_; ++at_) {
                c = source_.bytes[at_];
                if (c < '0' || c > '9') break;
                const auto d = static_cast<std::uint64_t>(c - '0');
                if (value > (std::numeric_limits<std::uint64_t>::max() - d) / 10) {
                    fail("a dimension beyond 64 bits");
                }
                value = value * 10 + d;
            }
            values.push_back(value);
            if (values.size() > 32) fail("more than 32 dimensions");
            if (!accept(',')) {
                expect(')');
                break;
            }
        }
        return values;
    }

    const Source& source_;
    std::size_t at_, end_;
};

bool sniff(std::string_view bytes) {
    return bytes.substr(0, magic.size()) == magic;
}

Header read_header(const Source& source) {
    if (!sniff(source.bytes)) {
        source.fail_at_byte(0, "not a NumPy file: it does not begin with \\x93NUMPY");
    }
    ByteReader bytes(source, magic.size(), false);
    const int major = bytes.value<std::uint8_t>("version");
    const int minor = bytes.value<std::uint8_t>("version");
    if (major < 1 || major > 3 || minor != 0) {
        source.fail_at_byte(magic.size(),
                            fmt::format("NumPy format version {}.{}; 1.0 to 3.0 can be read; save "
                                        "it again with numpy.save",
                                        major, minor));
    }
    const std::uint64_t length = major == 1 ? bytes.value<std::uint16_t>("header length")
                                            : bytes.value<std::uint32_t>("header length");
    const std::size_t begin = bytes.offset();
    bytes.skip(length, 1, "bytes of header");
    Header header = HeaderParser(source, begin, bytes.offset()).parse();
    header.data = bytes.offset();
    header.version = major;
    if (header.type.size() < 2) source.fail(fmt::format("NumPy type {}", quote(header.type)));
    return header;
}

std::string shape_text(const Header& header) {
    return fmt::format("({}{})", fmt::join(header.shape, ", "),
                       header.shape.size() == 1 ? "," : "");
}

// The number of rows. Checks the size of the array against that of the file.
std::size_t rows(const Source& source, const Header& header, std::uint64_t columns,
                 std::size_t item, std::size_t file_size) {
    const std::uint64_t n = header.shape[0];
    const std::size_t bytes = file_size - header.data;
    const bool fits = n == 0 || (columns <= bytes / item && n <= bytes / (columns * item));
    if (!fits || n * columns * item != bytes) {
        source.fail_at_byte(
            header.data, fmt::format("the header announces {} rows of {} items of {} bytes, but {} "
                                     "bytes follow; the file is cut short or damaged",
                                     n, columns, item, bytes));
    }
    return static_cast<std::size_t>(n);
}

void require_columns(const Source& source, const Header& header, std::size_t columns) {
    if (header.shape.size() == 2 && header.shape[1] == columns) return;
    source.fail(fmt::format("the array's shape is {}; (n, {}) is needed; reshape it in NumPy",
                            shape_text(header), columns));
}

bool big_endian(const Header& header) {
    return header.order() == '>';
}

bool known_order(const Header& header) {
    return header.order() == '<' || header.order() == '>';
}

bool has_doubles(const Header& header) {
    return known_order(header) && (header.kind() == "f8" || header.kind() == "f4");
}

// Calls put(row, column, position) for each item, in the order of the file.
template <class Put>
void each_item(const Source& source, const Header& header, std::size_t n, std::size_t columns,
               const Put& put) {
    ByteReader bytes(source, header.data, big_endian(header));
    const bool by_columns = header.fortran_order;
    for (std::size_t i = 0; i < (by_columns ? columns : n); ++i) {
        for (std::size_t j = 0; j < (by_columns ? n : columns); ++j) {
            put(by_columns ? j : i, by_columns ? i : j, bytes);
        }
    }
}

// The name of the values in a column after x, y and z, for messages and --fields.
std::string column_name(std::size_t column) {
    return fmt::format("column{}", column + 1);
}

void require_doubles(const Source& source, const Header& header) {
    if (header.kind()[0] == 'i' && header.shape.size() == 2 && header.shape[1] == 4) {
        source.fail(
            fmt::format("an array of {} of the shape {}: tetrahedra, without their points; "
                        "give the file of the points, or the mesh in one file, such as .vtu",
                        quote(header.type), shape_text(header)));
    }
    if (!has_doubles(header)) {
        source.fail(
            fmt::format("the array's type is {}; save it as float64: "
                        "numpy.save(name, a.astype('<f8'))",
                        quote(header.type)));
    }
}

Mesh read_npy(const Source& source, const ReadOptions& options) {
    const Header header = read_header(source);
    require_doubles(source, header);
    const bool wide = header.kind() == "f8";
    const bool has_more = header.shape.size() == 2 && header.shape[1] > 3;
    if (!options.has_fields || !has_more) require_columns(source, header, 3);
    const std::uint64_t all_columns = header.shape[1];
    const std::size_t n = rows(source, header, all_columns, wide ? 8 : 4, source.bytes.size());
    // Without rows, the header may give any number of columns.
    const std::size_t columns = n > 0 ? static_cast<std::size_t>(all_columns) : 3;

    Mesh mesh;
    mesh.detail = fmt::format("version {}.0, {}{}", header.version, header.type,
                              header.fortran_order ? ", Fortran order" : "");
    mesh.points.resize(3 * n);
    std::vector<std::string> names;
    std::vector<double*> values(columns, nullptr);
    for (std::size_t c = 3; c < columns; ++c) names.push_back(column_name(c));
    if (options.has_fields) require_fields(source, options, names);
    mesh.fields.reserve(names.size());
    for (std::size_t c = 3; c < columns; ++c) {
        const std::string& name = names[c - 3];
        if (!wants_field(options, name)) continue;
        mesh.fields.push_back({name, 1, std::vector<double>(n)});
        values[c] = mesh.fields.back().values.data();
    }
    each_item(source, header, n, columns, [&](std::size_t row, std::size_t c, ByteReader& bytes) {
        if (c < 3) {
            mesh.points[3 * row + c] =
                wide ? bytes.coordinate<double>() : bytes.coordinate<float>();
        } else {
            const double value = wide ? bytes.value<double>("value") : bytes.value<float>("value");
            if (values[c] != nullptr) values[c][row] = value;
        }
    });
    return mesh;
}

std::optional<RowLayout> npy_rows(const Source& beginning, std::size_t file_size) {
    Header header;
    try {
        header = read_header(beginning);
    } catch (const Error&) {
        return std::nullopt;  // too long or wrong; read() reports it
    }
    require_doubles(beginning, header);
    require_columns(beginning, header, 3);
    const bool wide = header.kind() == "f8";
    const std::size_t n = rows(beginning, header, 3, wide ? 8 : 4, file_size);
    if (header.fortran_order) return std::nullopt;
    return RowLayout{header.data, n, 3 * (wide ? std::size_t{8} : std::size_t{4}), wide,
                     big_endian(header)};
}

void write_header(const char* type, const std::string& shape, OutputFile& out) {
    std::string header =
        fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, shape);
    // NumPy aligns arrays to 64 bytes for memory maps.
    const std::size_t before = magic.size() + 4;
    header.append(64 - (before + header.size() + 1) % 64, ' ');
    header += '\n';
    out.write(magic);
    out.write_value<std::uint8_t>(1);
    out.write_value<std::uint8_t>(0);
    out.write_value(static_cast<std::uint16_t>(header.size()));
    out.write(header);
}

void write_header(const char* type, std::size_t n, std::size_t columns, OutputFile& out) {
    write_header(type, fmt::format("{}, {}", n, columns), out);
}

void write_points(const std::vector<double>& points, OutputFile& out, const WriteOptions&) {
    write_header("<f8", points.size() / 3, 3, out);
    out.write_values(points.data(), points.size());
}

// Writes rows of x, y, z and the values.
void write_fields(const Mesh& mesh, OutputFile& out, const WriteOptions&) {
    std::size_t columns = 3;
    for (const Field& f : mesh.fields) columns += f.components;
    write_header("<f8", mesh.point_count(), columns, out);
    for (std::size_t i = 0; i < mesh.point_count(); ++i) {
        out.write_values(mesh.points.data() + 3 * i, 3);
        for (const Field& f : mesh.fields) {
            out.write_values(f.values.data() + f.components * i, f.components);
        }
    }
}

void write_mesh(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                const WriteOptions& options) {
    write_npy_rows_of_4(mesh.tetrahedra, options.index_base, outputs.open(path));
}

}  // namespace

void write_npy_rows_of_4(const std::vector<MeshIndex>& values, std::int64_t add, OutputFile& out) {
    write_header("<i8", values.size() / 4, 4, out);
    for (const MeshIndex v : values) out.write_value(v + add);
}

void write_npy_integers(const std::vector<MeshIndex>& values, std::int64_t add, OutputFile& out) {
    write_header("<i8", fmt::format("{},", values.size()), out);
    for (const MeshIndex v : values) out.write_value(v < 0 ? std::int64_t{-1} : v + add);
}

std::vector<MeshIndex> read_npy_tetrahedra(const Source& source, int base, std::size_t points,
                                           const std::string& points_name) {
    const Header header = read_header(source);
    const std::string kind = header.kind();
    if (!known_order(header) || (kind != "i8" && kind != "i4")) {
        source.fail(
            fmt::format("the array's type is {}; tetrahedra need int64 or int32: "
                        "numpy.save(name, a.astype('<i8'))",
                        quote(header.type)));
    }
    const bool wide = kind == "i8";
    require_columns(source, header, 4);
    const std::size_t n = rows(source, header, 4, wide ? 8 : 4, source.bytes.size());
    const auto last = static_cast<std::int64_t>(std::min(points, most_in_mesh)) + base - 1;
    std::vector<MeshIndex> values(4 * n);
    each_item(source, header, n, 4, [&](std::size_t row, std::size_t c, ByteReader& bytes) {
        const std::int64_t v =
            wide ? bytes.value<std::int64_t>("index") : bytes.value<std::int32_t>("index");
        if (v < base || v > last)
            source.fail(fmt::format("row {}: vertex {}, but {} has {} points", row, v,
                                    printable(points_name), points));
        values[4 * row + c] = static_cast<MeshIndex>(v - base);
    });
    return values;
}

Field read_npy_values(const Source& source) {
    const Header header = read_header(source);
    const std::string kind = header.kind();
    const bool wide = kind == "f8" || kind == "i8";
    if (!has_doubles(header) && !(known_order(header) && (kind == "i8" || kind == "i4"))) {
        source.fail(
            fmt::format("the array's type is {}; save it as float64: "
                        "numpy.save(name, a.astype('<f8'))",
                        quote(header.type)));
    }
    if (header.shape.size() != 1 && header.shape.size() != 2) {
        source.fail(fmt::format("the array's shape is {}; (n,) or (n, m) is needed for values",
                                shape_text(header)));
    }
    const std::uint64_t columns = header.shape.size() == 1 ? 1 : header.shape[1];
    if (columns == 0) source.fail("an array of no columns");
    const std::size_t n = rows(source, header, columns, wide ? 8 : 4, source.bytes.size());
    Field field;
    field.name = "values";
    field.components = n > 0 ? static_cast<std::size_t>(columns) : 1;
    field.values.resize(n * field.components);
    each_item(source, header, n, field.components,
              [&](std::size_t row, std::size_t c, ByteReader& bytes) {
                  double& value = field.values[row * field.components + c];
                  if (kind == "f8") value = bytes.value<double>("value");
                  if (kind == "f4") value = bytes.value<float>("value");
                  if (kind == "i8") value = static_cast<double>(bytes.value<std::int64_t>("value"));
                  if (kind == "i4") value = bytes.value<std::int32_t>("value");
              });
    return field;
}

const Format& npy_format() {
    static const Format format = {"npy",   {".npy"},     "NumPy array", true,
                                  sniff,   read_npy,     write_points,  write_mesh,
                                  nullptr, write_fields, npy_rows};
    return format;
}

}  // namespace mgdt::cli
