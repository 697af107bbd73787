// SPDX-License-Identifier: MIT
// Gmsh's .msh, versions 2.2 and 4.1, text and binary: the nodes and the tetrahedra and, if facets
// are asked for, triangles, quadrangles and lines. Points keep
// the order of the file; node tags may be any positive numbers.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "cli/errors.hpp"
#include "cli/formats/bytes.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/gmsh_output.hpp"
#include "cli/formats/lines.hpp"
#include "cli/formats/node_numbers.hpp"

namespace mgdt::cli {
namespace {

constexpr std::int64_t tetrahedron_type = 4;
constexpr std::int64_t most = std::int64_t{1} << 62;

// The number of nodes of each element type, from the Gmsh reference manual, "MSH file format"; 0
// for unknown types.
int nodes_of(std::int64_t type) {
    static constexpr std::array<int, 32> nodes = {0,  2,  3,  4,  4, 8, 6,  5,  3,  6, 9,
                                                  10, 27, 18, 14, 1, 8, 20, 15, 13, 9, 10,
                                                  12, 15, 15, 21, 4, 5, 6,  20, 35, 56};
    if (type == 92) return 64;
    if (type == 93) return 125;
    return type > 0 && type < 32 ? nodes[static_cast<std::size_t>(type)] : 0;
}

// Reads the file as a sequence of numbers, in text or binary.
class Reader {
  public:
    explicit Reader(const Source& source)
        : source_(source), lines_(source), bytes_(source, 0, false) {}

    // Reads $MeshFormat, which defines how the rest is stored.
    void read_format(Mesh& mesh) {
        if (!lines_.next_with_text(no_comment) || lines_.text() != "$MeshFormat") {
            source_.fail_at_line(1, "not a Gmsh file: it does not begin with $MeshFormat");
        }
        if (!lines_.next()) lines_.fail("the file is cut short");
        Fields fields(lines_);
        const std::string_view version = fields.word("the version");
        if (version == "2.2") {
            version_ = 2;
        } else if (version == "4.1") {
            version_ = 4;
        } else {
            lines_.fail(
                fmt::format("version {}; 2.2 and 4.1 can be read; convert it with gmsh -0 "
                            "-format msh41",
                            quote(version)));
        }
        binary_ = fields.integer("the file type", 0, 1) == 1;
        if (fields.integer("the data size") != 8) lines_.fail("the data size must be 8");
        if (binary_) {
            bool big = false;
            ByteReader probe(source_, lines_.offset(), false);
            const auto one = probe.value<std::int32_t>("byte order mark");
            if (one == 0x01000000) {
                big = true;
            } else if (one != 1) {
                source_.fail_at_byte(lines_.offset(), "the byte order mark is neither 1 nor 2^24");
            }
            bytes_ = ByteReader(source_, probe.offset(), big);
        }
        mesh.detail = fmt::format("version {}, {}", version, binary_ ? "binary" : "ascii");
        leave("MeshFormat");
    }

    // Goes to the next section. Returns false at the end of the file.
    bool enter(std::string& name) {
        if (!lines_.next_with_text(no_comment)) return false;
        const std::string_view text = lines_.text();
        if (text[0] != '$')
            lines_.fail(fmt::format("{} where a section ($...) begins", quote(text)));
        name = std::string(text.substr(1, text.find_last_not_of(" \t")));
        bytes_.seek(lines_.offset());
        row_.reset();
        return true;
    }

    // Leaves a section that has been read to its end.
    void leave(const std::string& name) {
        row_.reset();
        const std::string end = "$End" + name;
        if (binary_) {
            const std::size_t at = source_.bytes.find_first_not_of("\r\n", bytes_.offset());
            if (at == std::string_view::npos || source_.bytes.substr(at, end.size()) != end) {
                bytes_.fail(end + " expected; a count is wrong or the file is cut short");
            }
            restart(at);
        }
        if (!lines_.next_with_text(no_comment) || lines_.text().substr(0, end.size()) != end) {
            lines_.fail(end + " expected; a count is wrong or the file is cut short");
        }
    }

    // Skips a section.
    void skip(const std::string& name) {
        const std::string end = "$End" + name;
        const std::size_t at = source_.bytes.find(end, lines_.offset());
        if (at == std::string_view::npos) lines_.fail(fmt::format("no {} follows", quote(end)));
        restart(at);
        lines_.next();
    }

    int version() const { return version_; }
    bool binary() const { return binary_; }
    std::size_t bytes_left() const { return binary_ ? bytes_.left() : lines_.bytes_left(); }

    [[noreturn]] void fail(const std::string& what) const {
        if (binary_) bytes_.fail(what);
        lines_.fail(what);
    }

    // Checks the count of items that follow. Each takes `least_binary` bytes, or in text a digit
    // and a separator for each of `least_words` words.
    void check_count(std::int64_t count, const char* what, std::size_t least_binary,
                     std::size_t least_words) const {
        const std::size_t least = binary_ ? least_binary : 2 * least_words;
        if (static_cast<std::uint64_t>(count) <= (bytes_left() + 1) / least) return;
        fail(
            fmt::format("{} {} announced, but only {} bytes follow; the file is cut short or the "
                        "count is wrong",
                        count, what, bytes_left()));
    }

    // Begins a row: the next line in text, nothing in binary.
    void row() {
        if (binary_) return;
        if (!lines_.next_with_text(no_comment)) lines_.fail("the file is cut short");
        row_.emplace(lines_);
    }
    // A size_t in version 4.1, an int in 2.2.
    std::int64_t size(const char* what, std::int64_t low = 0) {
        if (!binary_) return row_->integer(what, low, most);
        return in_range(
            what,
            version_ == 4 ? bytes_.value<std::int64_t>(what) : bytes_.value<std::int32_t>(what),
            low);
    }
    std::int64_t integer(const char* what) {  // int
        return binary_ ? bytes_.value<std::int32_t>(what) : row_->integer(what);
    }
    double coordinate() {
        return binary_ ? bytes_.coordinate<double>() : row_->number("coordinate");
    }
    void skip_words(std::int64_t count, std::size_t size, const char* what) {
        if (binary_) bytes_.skip(static_cast<std::uint64_t>(count), size, what);
    }
    // In version 2.2, counts are on a line of text even in binary files.
    std::int64_t line_count(const char* what) {
        if (!lines_.next()) lines_.fail("the file is cut short");
        const std::int64_t count = Fields(lines_).integer(what, 0, most);
        bytes_.seek(lines_.offset());
        return count;
    }

    // The names of physical groups of surfaces. They are text in binary files, too.
    void read_names(MarkerNames& names) {
        const std::int64_t count = line_count("the number of physical names");
        for (std::int64_t i = 0; i < count; ++i) {
            if (!lines_.next()) lines_.fail("the file is cut short");
            Fields fields(lines_);
            const std::int64_t dimension =
                                   fields.integer("the dimension of a physical group", 0, 3),
                               group = fields.integer("physical group");
            const std::string_view text = lines_.text();
            const std::size_t begin = text.find('"'), end = text.rfind('"');
            if (begin == end) lines_.fail("a name in quotes is to follow");
            if (dimension == 2 && group == static_cast<std::int32_t>(group))
                names[static_cast<std::int32_t>(group)] = text.substr(begin + 1, end - begin - 1);
        }
        bytes_.seek(lines_.offset());
    }

  private:
    std::int64_t in_range(const char* what, std::int64_t value, std::int64_t low) const {
        if (value < low || value > most) fail(fmt::format("{} is {}", what, value));
        return value;
    }
    // Continues with lines at a byte offset; lines are numbered from the last line that was read.
    void restart(std::size_t offset) { lines_ = LineReader(source_, offset, lines_.number() + 1); }

    const Source& source_;
    LineReader lines_;
    ByteReader bytes_;
    std::optional<Fields> row_;
    int version_ = 0;
    bool binary_ = false;
};

// Maps node tags to positions in the file.
class Tags {
    auto fail() const {
        return [this](const std::string& message) { reader_.fail(message); };
    }

  public:
    explicit Tags(Reader& reader) : reader_(reader) {}
    void add(std::int64_t tag) { numbers_.add(tag, fail()); }
    std::int64_t find(std::int64_t tag) const { return numbers_.find(tag, fail()); }

  private:
    Reader& reader_;
    NodeNumbers numbers_;
};

void read_point(Reader& reader, Mesh& mesh) {
    double xyz[3];
    for (double& x : xyz) x = reader.coordinate();
    mesh.points.insert(mesh.points.end(), xyz, xyz + 3);
}

void read_nodes_2(Reader& reader, Mesh& mesh, Tags& tags) {
    const std::int64_t count = reader.line_count("the number of nodes");
    reader.check_count(count, "nodes", 28, 4);
    for (std::int64_t i = 0; i < count; ++i) {
        reader.row();
        tags.add(reader.size("node tag", 1));
        read_point(reader, mesh);
    }
}

void read_nodes_4(Reader& reader, Mesh& mesh, Tags& tags) {
    reader.row();
    const std::int64_t blocks = reader.size("the number of blocks");
    const std::int64_t total = reader.size("the number of nodes");
    reader.size("the least tag");
    reader.size("the greatest tag");
    reader.check_count(blocks, "blocks of nodes", 20, 4);
    reader.check_count(total, "nodes", 32, 4);
    std::int64_t seen = 0;
    for (std::int64_t b = 0; b < blocks; ++b) {
        reader.row();
        const std::int64_t dimension = reader.integer("the entity's dimension");
        reader.integer("the entity's tag");
        const std::int64_t parametric = reader.integer("parametric");
        const std::int64_t count = reader.size("the number of nodes in the block");
        if (dimension < 0 || dimension > 3) reader.fail(fmt::format("dimension {}", dimension));
        if (count > total - seen) reader.fail("more nodes than announced");
        reader.check_count(count, "nodes", 32, 4);
        seen += count;
        for (std::int64_t i = 0; i < count; ++i) {
            reader.row();
            tags.add(reader.size("node tag", 1));
        }
        for (std::int64_t i = 0; i < count; ++i) {
            reader.row();
            read_point(reader, mesh);
            if (parametric != 0) reader.skip_words(dimension, 8, "parametric coordinates");
        }
    }
    if (seen != total) reader.fail(fmt::format("{} nodes; {} are announced", seen, total));
}

// Whether the type is a tetrahedron, of order 1 to 5. Its corners come first.
bool is_tetrahedron(std::int64_t type) {
    return type == tetrahedron_type || type == 11 || (type >= 29 && type <= 31);
}

// The corners of a line, triangle or quadrangle of any order, which come first; 0 for other types.
int corners_of(std::int64_t type) {
    switch (type) {
        case 1:
        case 8:
        case 26:
        case 27:
        case 28:
            return 2;
        case 2:
        case 9:
        case 20:
        case 21:
        case 22:
        case 23:
        case 24:
        case 25:
            return 3;
        case 3:
        case 10:
        case 16:
            return 4;
        default:
            return 0;
    }
}

// Reads the nodes of one element, after its tag. `facets` receives those of facets, if it is not
// null.
void read_element(Reader& reader, std::int64_t type, int nodes, const Tags& tags,
                  std::int32_t marker, FileFacets* facets, Mesh& mesh) {
    const int corners = facets ? corners_of(type) : 0;
    if (!is_tetrahedron(type)) {
        ++mesh.other_cells;
        std::int64_t corner[4];
        for (int k = 0; k < corners; ++k) corner[k] = tags.find(reader.size("node tag"));
        reader.skip_words(nodes - corners, reader.version() == 4 ? 8 : 4, "nodes");
        if (corners == 2)
            facets->add_segment(corner);
        else if (corners > 2)
            facets->add_facet(corner, static_cast<std::size_t>(corners), marker);
        return;
    }
    for (int k = 0; k < nodes; ++k)
        mesh.add_node(static_cast<std::size_t>(k), tags.find(reader.size("node tag")));
    if (facets) mesh.regions.push_back(marker);
}

int known_nodes(Reader& reader, std::int64_t type) {
    const int nodes = nodes_of(type);
    // In text, elements of any type end with the line.
    if (nodes == 0 && reader.binary()) {
        reader.fail(
            fmt::format("element type {} is not known; convert the file to text with gmsh", type));
    }
    return nodes;
}

std::int32_t marker_of(Reader& reader, std::int64_t group) {
    if (group < std::numeric_limits<std::int32_t>::min() ||
        group > std::numeric_limits<std::int32_t>::max())
        reader.fail(fmt::format("the physical group {} does not fit 32 bits", group));
    return static_cast<std::int32_t>(group);
}

// The first physical group of each entity of version 4.1, by its dimension and tag.
using Groups = std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t>;

Groups read_entities(Reader& reader) {
    reader.row();
    std::int64_t counts[4];
    for (std::int64_t& count : counts) count = reader.size("the number of entities");
    Groups groups;
    for (std::int64_t dimension = 0; dimension < 4; ++dimension) {
        reader.check_count(counts[dimension], "entities", 20, 4);
        for (std::int64_t i = 0; i < counts[dimension]; ++i) {
            reader.row();
            const std::int64_t tag = reader.integer("the entity's tag");
            // A point has its place, any other entity a box.
            for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) reader.coordinate();
            const std::int64_t n = reader.size("the number of physical groups");
            reader.check_count(n, "physical groups", 4, 1);
            for (std::int64_t k = 0; k < n; ++k) {
                const std::int64_t group = reader.integer("physical group");
                if (k == 0) groups.emplace(std::pair(dimension, tag), group);
            }
            if (dimension == 0) continue;
            const std::int64_t bounds = reader.size("the number of bounding entities");
            reader.check_count(bounds, "bounding entities", 4, 1);
            for (std::int64_t k = 0; k < bounds; ++k) reader.integer("bounding entity");
        }
    }
    return groups;
}

void read_elements_2(Reader& reader, const Tags& tags, FileFacets* facets, Mesh& mesh) {
    const std::int64_t count = reader.line_count("the number of elements");
    reader.check_count(count, "elements", 8, 4);
    std::int64_t seen = 0;
    while (seen < count) {
        reader.row();
        std::int64_t type = 0, follow = 1, attributes = 0;
        if (reader.binary()) {
            type = reader.integer("element type");
            follow = reader.size("the number of elements that follow", 1);
            attributes = reader.size("the number of tags");
        } else {
            reader.size("element number");
            type = reader.integer("element type");
            attributes = reader.size("the number of tags");
        }
        const int nodes = known_nodes(reader, type);
        if (follow > count - seen) reader.fail("more elements than announced");
        for (std::int64_t i = 0; i < follow; ++i) {
            // The first attribute is the physical group. In text, each is one word of the line, and
            // the loop ends if there are too few.
            std::int64_t group = 0;
            if (reader.binary()) {
                reader.skip_words(1, 4, "the element's tag");
                if (attributes > 0) group = reader.integer("tag");
                reader.skip_words(std::max<std::int64_t>(attributes - 1, 0), 4, "tags");
            } else {
                for (std::int64_t k = 0; k < attributes; ++k) {
                    const std::int64_t tag = reader.integer("tag");
                    if (k == 0) group = tag;
                }
            }
            read_element(reader, type, nodes, tags, marker_of(reader, group), facets, mesh);
        }
        seen += follow;
    }
}

void read_elements_4(Reader& reader, const Tags& tags, const Groups& groups, FileFacets* facets,
                     Mesh& mesh) {
    reader.row();
    const std::int64_t blocks = reader.size("the number of blocks");
    const std::int64_t total = reader.size("the number of elements");
    reader.size("the least tag");
    reader.size("the greatest tag");
    reader.check_count(blocks, "blocks of elements", 20, 4);
    reader.check_count(total, "elements", 16, 2);
    std::int64_t seen = 0;
    for (std::int64_t b = 0; b < blocks; ++b) {
        reader.row();
        const std::int64_t dimension = reader.integer("the entity's dimension"),
                           entity = reader.integer("the entity's tag");
        const auto group = groups.find({dimension, entity});
        const std::int32_t marker = group == groups.end() ? 0 : marker_of(reader, group->second);
        const std::int64_t type = reader.integer("element type");
        const std::int64_t count = reader.size("the number of elements in the block");
        const int nodes = known_nodes(reader, type);
        if (count > total - seen) reader.fail("more elements than announced");
        reader.check_count(count, "elements", 16, 2);
        seen += count;
        for (std::int64_t i = 0; i < count; ++i) {
            reader.row();
            reader.size("element tag");
            read_element(reader, type, nodes, tags, marker, facets, mesh);
        }
    }
    if (seen != total) reader.fail(fmt::format("{} elements; {} are announced", seen, total));
}

bool sniff(std::string_view bytes) {
    const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
    return begin != std::string_view::npos && bytes.substr(begin, 11) == "$MeshFormat";
}

Mesh read_gmsh(const Source& source, const ReadOptions& options) {
    Mesh mesh;
    Reader reader(source);
    reader.read_format(mesh);
    Tags tags(reader);
    FileFacets* const facets = options.has_facets || options.has_markers ? &mesh.facets : nullptr;
    Groups groups;
    bool nodes = false, elements = false;
    std::string section;
    while (reader.enter(section)) {
        if (section == "Nodes" && !nodes) {
            nodes = true;
            reader.version() == 4 ? read_nodes_4(reader, mesh, tags)
                                  : read_nodes_2(reader, mesh, tags);
            reader.leave(section);
        } else if (section == "Elements" && nodes && !elements) {
            elements = true;
            reader.version() == 4 ? read_elements_4(reader, tags, groups, facets, mesh)
                                  : read_elements_2(reader, tags, facets, mesh);
            reader.leave(section);
        } else if (section == "Entities" && facets && reader.version() == 4 && groups.empty()) {
            groups = read_entities(reader);
            reader.leave(section);
        } else if (section == "PhysicalNames" && facets && facets->names.empty()) {
            reader.read_names(facets->names);
            reader.leave(section);
        } else if (section == "Nodes" || section == "Elements") {
            reader.fail(fmt::format("${} comes twice or out of order", section));
        } else {
            reader.skip(section);
        }
    }
    if (!nodes) source.fail("the file has no $Nodes");
    mesh.has_tetrahedra = !mesh.tetrahedra.empty() || (elements && mesh.other_cells == 0);
    return mesh;
}

}  // namespace

const Format& gmsh_format() {
    static const Format format = [] {
        Format f = {"gmsh",  {".msh"},    "Gmsh 4.1 binary (reads 2.2 and 4.1)",
                    true,    sniff,       read_gmsh,
                    nullptr, write_gmsh_4};
        f.has_facets = true;
        return f;
    }();
    return format;
}

const Format& gmsh2_format() {
    static const Format format = [] {
        Format f = {"gmsh2", {}, "Gmsh 2.2 text", false, nullptr, read_gmsh, nullptr, write_gmsh_2};
        f.has_facets = true;
        return f;
    }();
    return format;
}

}  // namespace mgdt::cli
