// SPDX-License-Identifier: MIT
// INRIA's .meshb, the binary form of .mesh: numbered keywords, each with the position of the next
// one. Vertices and tetrahedra are read, and if they are asked for the references of tetrahedra,
// triangles and edges. L. Maréchal, libMeshb's
// description of the format, "The GMF library".
#include <fmt/core.h>

#include <array>
#include <limits>

#include "cli/formats/bytes.hpp"
#include "cli/formats/format.hpp"

namespace mgdt::cli {
namespace {

enum Keyword : std::int32_t {
    dimension_keyword = 3,
    vertices_keyword = 4,
    edges_keyword = 5,
    triangles_keyword = 6,
    quadrilaterals_keyword = 7,
    tetrahedra_keyword = 8,
    prisms_keyword = 9,
    hexahedra_keyword = 10,
    quadratic_tetrahedra_keyword = 30,
    pyramids_keyword = 49,
    end_keyword = 54
};

bool is_other_cell(std::int32_t keyword) {
    return (keyword >= edges_keyword && keyword <= hexahedra_keyword &&
            keyword != tetrahedra_keyword) ||
           keyword == pyramids_keyword;
}

// The first number of a file is 1, in the byte order of the machine that wrote it.
bool sniff(std::string_view bytes) {
    const std::string_view start = bytes.substr(0, 4);
    const std::string_view version = bytes.substr(std::min<std::size_t>(4, bytes.size()), 4);
    const auto is_small = [](std::string_view number, std::size_t at) {
        return number.size() == 4 && number[at] >= 1 && number[at] <= 4 && number[at ^ 3] == 0 &&
               number[1] == 0 && number[2] == 0;
    };
    return (start == std::string_view("\1\0\0\0", 4) && is_small(version, 0)) ||
           (start == std::string_view("\0\0\0\1", 4) && is_small(version, 3));
}

class Reader {
  public:
    Reader(const Source& source, bool has_markers)
        : source_(source), bytes_(source, 0, false), has_markers_(has_markers) {}

    Mesh read() {
        if (!sniff(source_.bytes)) source_.fail_at_byte(0, "not a binary mesh of INRIA's");
        bytes_ = ByteReader(source_, 4, source_.bytes[0] == 0);
        version_ = bytes_.value<std::int32_t>("the version");
        mesh_.detail = fmt::format("version {}, binary", version_);
        bool has_vertices = false;
        for (;;) {
            const auto keyword = bytes_.value<std::int32_t>("a keyword");
            if (keyword == end_keyword) break;
            const std::size_t before = bytes_.offset();
            const std::int64_t next = version_ < 3 ? bytes_.value<std::int32_t>("an offset")
                                                   : bytes_.value<std::int64_t>("an offset");
            if (keyword == dimension_keyword) {
                const auto dimension = bytes_.value<std::int32_t>("the dimension");
                if (dimension != 3)
                    bytes_.fail(fmt::format("dimension {}; 3 is needed", dimension));
            } else if (keyword == vertices_keyword) {
                if (has_vertices) bytes_.fail("the vertices come twice");
                has_vertices = true;
                read_vertices();
            } else if (keyword == tetrahedra_keyword) {
                read_tetrahedra(4, has_vertices);
            } else if (keyword == quadratic_tetrahedra_keyword) {
                read_tetrahedra(10, has_vertices);
            } else if (has_markers_ && has_vertices &&
                       (keyword == triangles_keyword || keyword == edges_keyword)) {
                read_facets(keyword == triangles_keyword ? 3 : 2);
            } else if (is_other_cell(keyword)) {
                mesh_.other_cells += count("cells", 2);
            }
            if (next == 0) break;  // which some programs write instead of the last keyword
            // Positions have to increase, so that reading ends and nothing is read twice.
            if (next < static_cast<std::int64_t>(bytes_.offset()) ||
                static_cast<std::uint64_t>(next) > source_.bytes.size())
                source_.fail_at_byte(before, fmt::format("the next keyword is at byte {}", next));
            bytes_.seek(static_cast<std::size_t>(next));
        }
        if (!has_vertices) source_.fail("has no vertices");
        return std::move(mesh_);
    }

  private:
    std::int64_t integer(const char* what) {
        return version_ < 4 ? bytes_.value<std::int32_t>(what) : bytes_.value<std::int64_t>(what);
    }
    std::size_t integer_size() const { return version_ < 4 ? 4 : 8; }
    // Reads the number of rows that follow; a row has the size of `integers` integers.
    std::size_t count(const char* what, std::size_t integers) {
        const std::int64_t n = integer("a count");
        if (n < 0) bytes_.fail(fmt::format("{} {}", n, what));
        bytes_.need(static_cast<std::uint64_t>(n), integers * integer_size(), what);
        return static_cast<std::size_t>(n);
    }
    void read_vertices() {
        const std::size_t n = count("vertices", 4);
        mesh_.points.reserve(3 * n);
        for (std::size_t i = 0; i < n; ++i) {
            for (int k = 0; k < 3; ++k)
                mesh_.points.push_back(version_ == 1 ? bytes_.coordinate<float>()
                                                     : bytes_.coordinate<double>());
            integer("a vertex's reference");
        }
    }
    void read_tetrahedra(std::size_t nodes, bool has_vertices) {
        if (!has_vertices) bytes_.fail("tetrahedra before the vertices");
        if (nodes_read_[nodes]) bytes_.fail("the tetrahedra come twice");
        mesh_.has_tetrahedra = nodes_read_[nodes] = true;
        const std::size_t n = count("tetrahedra", nodes + 1);
        const auto last = static_cast<std::int64_t>(mesh_.point_count());
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k < nodes; ++k) mesh_.add_node(k, vertex(last));
            const std::int32_t marker = reference("a tetrahedron's reference");
            if (has_markers_) mesh_.regions.push_back(marker);
        }
    }
    std::int64_t vertex(std::int64_t last) {
        const std::int64_t v = integer("a vertex");
        if (v < 1 || v > last)
            bytes_.fail(fmt::format("vertex {}, but there are {} vertices", v, last));
        return v - 1;
    }
    // A reference, which has to fit 32 bits if it is used as a marker.
    std::int32_t reference(const char* what) {
        const std::int64_t value = integer(what);
        if (has_markers_ && value != static_cast<std::int32_t>(value))
            bytes_.fail(fmt::format("{}, {}, does not fit 32 bits", what, value));
        return static_cast<std::int32_t>(value);
    }
    void read_facets(std::size_t corners) {
        const std::size_t n = count("cells", corners + 1);
        const auto last = static_cast<std::int64_t>(mesh_.point_count());
        mesh_.other_cells += n;
        for (std::size_t i = 0; i < n; ++i) {
            std::int64_t corner[3];
            for (std::size_t k = 0; k < corners; ++k) corner[k] = vertex(last);
            const std::int32_t marker = reference("a reference");
            if (corners == 3)
                mesh_.facets.add_facet(corner, corners, marker);
            else
                mesh_.facets.add_segment(corner);
        }
    }

    const Source& source_;
    ByteReader bytes_;
    const bool has_markers_;
    Mesh mesh_;
    std::int32_t version_ = 0;
    // Whether tetrahedra with this number of nodes have been read.
    std::array<bool, 11> nodes_read_ = {};
};

Mesh read_medit_binary(const Source& source, const ReadOptions& options) {
    return Reader(source, options.has_markers).read();
}

// Writes keywords in sequence. Their positions follow from their sizes.
class Writer {
  public:
    // Positions have 32 bits in version 2, for files below 2 GiB, and 64 bits in version 3.
    Writer(OutputFile& out, std::uint64_t data_bytes)
        : out_(out),
          is_wide_(data_bytes + 1000 >
                   static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max())) {
        integer(1);
        integer(is_wide_ ? 3 : 2);
        begin(dimension_keyword, 4);
        integer(3);
    }
    void write_points(const std::vector<double>& points) {
        begin(vertices_keyword, 4 + (points.size() / 3) * 28);
        integer(static_cast<std::int64_t>(points.size() / 3));
        for (std::size_t i = 0; i < points.size(); i += 3) {
            out_.write_values(&points[i], 3);
            integer(0);
        }
    }
    // Writes cells of `size` vertices. Each is followed by its marker, or by 0 if there are no
    // markers.
    void write_cells(Keyword keyword, const std::vector<MeshIndex>& vertices, std::size_t size,
                     const std::vector<std::int32_t>& markers) {
        begin(keyword, 4 + vertices.size() / size * (size + 1) * 4);
        integer(static_cast<std::int64_t>(vertices.size() / size));
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            integer(vertices[i] + 1);
            if (i % size == size - 1) integer(markers.empty() ? 0 : markers[i / size]);
        }
    }
    void end() {
        integer(end_keyword);
        write_offset(0);
    }

  private:
    void integer(std::int64_t value) { out_.write_value(static_cast<std::int32_t>(value)); }
    void write_offset(std::uint64_t at) {
        if (is_wide_)
            out_.write_value(at);
        else
            integer(static_cast<std::int64_t>(at));
    }
    void begin(Keyword keyword, std::uint64_t bytes) {
        at_ += 4 + (is_wide_ ? 8 : 4) + bytes;
        integer(keyword);
        write_offset(at_);
    }

    OutputFile& out_;
    bool is_wide_;
    std::uint64_t at_ = 8;
};

void write_points(const std::vector<double>& points, OutputFile& out, const WriteOptions&) {
    Writer writer(out, points.size() / 3 * 28);
    writer.write_points(points);
    writer.end();
}

void write_mesh(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                const WriteOptions&) {
    Writer writer(outputs.open(path),
                  mesh.point_count() * 28 + mesh.tetrahedron_count() * 20 + mesh.faces.size() * 16);
    writer.write_points(mesh.points);
    if (mesh.faces.size() > 0)
        writer.write_cells(triangles_keyword, mesh.faces.corners, 3, mesh.faces.markers);
    writer.write_cells(tetrahedra_keyword, mesh.tetrahedra, 4, mesh.regions);
    writer.end();
}

}  // namespace

const Format& medit_binary_format() {
    static const Format format = {
        "meshb",      {".meshb"}, "INRIA's mesh, binary, for Medit and Mmg",
        true,         sniff,      read_medit_binary,
        write_points, write_mesh};
    return format;
}

}  // namespace mgdt::cli
