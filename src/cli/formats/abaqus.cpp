// SPDX-License-Identifier: MIT
// Abaqus's input files, .inp, which CalculiX reads too: the nodes, and the elements of types such
// as C3D4 and C3D10, or such as S3 and M3D4 if facets are asked for. Points keep the order of the
// file; numbers of nodes may be any positive ones. Abaqus Analysis User's Manual, "Input syntax
// rules".
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "cli/errors.hpp"
#include "cli/formats/element_sets.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"
#include "cli/formats/node_numbers.hpp"
#include "cli/formats/number.hpp"
#include "cli/formats/table.hpp"
#include "cli/formats/text_rows.hpp"

namespace mgdt::cli {
namespace {

constexpr char node_keyword[] = "*NODE", element_keyword[] = "*ELEMENT";

// The text without blanks, in capitals; neither has a meaning in these files.
std::string canonical(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (is_blank(c)) continue;
        out += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    }
    return out;
}

// The keyword of a line, with parameters such as TYPE=C3D4.
struct Keyword {
    explicit Keyword(std::string_view line) : text(canonical(line) + ',') {}
    bool is(std::string_view name) const { return text.compare(0, text.find(','), name) == 0; }
    bool has(std::string_view parameter) const {
        return text.find(fmt::format(",{},", parameter)) != std::string::npos;
    }
    // The value of a parameter; empty if there is none.
    std::string value_of(std::string_view parameter) const {
        const std::size_t at = text.find(fmt::format(",{}=", parameter));
        if (at == std::string::npos) return "";
        const std::size_t begin = at + parameter.size() + 2;
        return text.substr(begin, text.find(',', begin) - begin);
    }
    std::string text;
};

// The number of nodes of a tetrahedral element type; 0 for other types. The name of a type is a
// family (solids: C; heat: DC; acoustics: AC; coupled: Q; fluids: F and FC; electromagnetics: EMC),
// 3D, the number of nodes, and letters for variants, as in C3D10MH. Membranes (M3D4) and similar
// types are not solids.
int nodes_of(std::string_view type) {
    const std::size_t at = type.find("3D");
    if (at == std::string_view::npos) return 0;
    const std::string_view family = type.substr(0, at);
    constexpr std::string_view families[] = {"C", "DC", "AC", "Q", "F", "FC", "EMC"};
    if (std::find(std::begin(families), std::end(families), family) == std::end(families)) return 0;
    std::string_view rest = type.substr(at + 2);
    const int nodes = rest.substr(0, 2) == "10" ? 10 : rest.substr(0, 1) == "4" ? 4 : 0;
    rest.remove_prefix(std::min<std::size_t>(rest.size(), nodes == 10 ? 2 : 1));
    const auto is_letter = [](char c) { return c >= 'A' && c <= 'Z'; };
    return std::all_of(rest.begin(), rest.end(), is_letter) ? nodes : 0;
}

// A shell, a membrane, a flat solid or a rigid facet, whose corners come first; 0 for other types.
struct FacetType {
    int nodes = 0, corners = 0;
};
FacetType facet_type(std::string_view type) {
    constexpr std::string_view families[] = {"STRI", "SFM3D", "M3D", "R3D", "CPS", "CPE",
                                             "CPEG", "CAX",   "DS",  "S",   "DC2D"};
    std::size_t digits = type.find_first_of("0123456789");
    // The name of a family may have a digit itself.
    for (const std::string_view family : families)
        if (type.substr(0, family.size()) == family && family.back() == 'D') digits = family.size();
    if (digits == std::string_view::npos || std::find(std::begin(families), std::end(families),
                                                      type.substr(0, digits)) == std::end(families))
        return {};
    const std::string_view number = type.substr(digits, type.substr(digits, 2) == "65" ? 2 : 1);
    if (number == "3") return {3, 3};
    if (number == "4") return {4, 4};
    if (number == "6" || number == "65") return {6, 3};
    if (number == "8") return {8, 4};
    return {};
}

bool sniff(std::string_view bytes) {
    const std::string start =
        canonical(bytes.substr(0, std::min<std::size_t>(bytes.find('\n'), 100)));
    return start.compare(0, 8, "*HEADING") == 0;
}

class Reader {
    auto fail() const {
        return [this](const std::string& message) { lines_.fail(message); };
    }

  public:
    Reader(const Source& source, const ReadOptions& options)
        : source_(source),
          lines_(source),
          has_facets_(options.has_facets || options.has_markers),
          has_markers_(options.has_markers),
          generated_left_(static_cast<std::int64_t>(source.bytes.size())) {}

    Mesh read() {
        mesh_.detail = "text";
        enum { nothing, nodes, tetrahedra, facets, others, members } section = nothing;
        bool goes_on = false;  // whether the numbers of an ignored element continue
        while (next_line()) {
            if (text_[0] == '*') {
                const Keyword keyword(whole_keyword());
                section = nothing;
                goes_on = false;
                const bool is_node = keyword.is(node_keyword),
                           is_element = keyword.is(element_keyword);
                require_here(keyword, is_node, is_element);
                if (is_node) {
                    section = nodes;
                    has_nodes_ = true;
                }
                if (is_element) {
                    const std::string type = keyword.value_of("TYPE");
                    nodes_ = nodes_of(type);
                    section = nodes_ > 0 ? tetrahedra : others;
                    mesh_.has_tetrahedra |= nodes_ > 0;
                    facet_ = has_facets_ ? facet_type(type) : FacetType();
                    set_name_ = keyword.value_of("ELSET");
                    if (facet_.nodes > 0) {
                        section = facets;
                        set_ = number_of_set(set_name_);
                    }
                }
                if (has_markers_ && keyword.is("*ELSET")) {
                    section = members;
                    set_name_ = keyword.value_of("ELSET");
                    is_generated_ = keyword.has("GENERATE");
                }
                if (has_markers_ && keyword.is("*SOLIDSECTION"))
                    element_sets_.add_section(keyword.value_of("ELSET"));
                continue;
            }
            if (section == nodes) read_node();
            if (section == tetrahedra) read_tetrahedron();
            if (section == facets) read_facet();
            if (section == members) read_members();
            if (section == others) {
                mesh_.other_cells += goes_on ? 0 : 1;
                goes_on = ends_with_comma();
            }
        }
        if (!has_nodes_) source_.fail("has no *NODE");
        mesh_.regions = element_sets_.markers();
        return std::move(mesh_);
    }

  private:
    // Goes to the next line that is no comment, and removes the blanks around its text.
    bool next_line() {
        do {
            if (!lines_.next_with_text(no_comment)) return false;
            text_ = lines_.text();
            text_.remove_prefix(text_.find_first_not_of(" \t\f\v"));
            text_ = text_.substr(0, text_.find_last_not_of(" \t\f\v") + 1);
        } while (text_.substr(0, 2) == "**");
        return true;
    }
    bool ends_with_comma() const { return text_.back() == ','; }
    // Reads a keyword with its parameters. They continue in the next line if the line ends with a
    // comma.
    std::string whole_keyword() {
        std::string whole(text_);
        while (ends_with_comma()) {
            if (!next_line()) lines_.fail("the file is cut short");
            whole += text_;
        }
        return whole;
    }
    // Refuses data in other files or in other kinds of coordinates, which would be missed.
    void require_here(const Keyword& keyword, bool is_node, bool is_element) const {
        if (keyword.is("*INCLUDE")) lines_.fail("*INCLUDE; name the file that it includes");
        if (!is_node && !is_element) return;
        if (keyword.text.find(",INPUT=") != std::string::npos)
            lines_.fail("INPUT=; put the lines of that file here");
        if (keyword.text.find(",SYSTEM=") != std::string::npos && !keyword.has("SYSTEM=R"))
            lines_.fail("SYSTEM=; only rectangular coordinates can be read");
    }
    // The next number of a line or of an element. The numbers of an element continue in the next
    // line if the line ends with a comma.
    std::string_view word(const char* what) {
        while (at_ == words_.size()) {
            if (!may_go_on_ || !ends_with_comma())
                lines_.fail(fmt::format("the line ends where {} is to follow", what));
            if (!next_line()) lines_.fail("the file is cut short");
            split_line();
        }
        const std::string_view found = words_[at_++];
        if (found.empty()) lines_.fail(fmt::format("{} is missing", what));
        return found;
    }
    void split_line() {
        words_ = split(text_, ',');
        while (!words_.empty() && words_.back().empty()) words_.pop_back();
        at_ = 0;
    }
    std::int64_t integer(const char* what) {
        const std::string_view text = word(what);
        std::int64_t value = 0;
        if (!parse_integer(text, value) || value < 1)
            lines_.fail(fmt::format("{}: {} is no positive integer", what, quote(text)));
        return value;
    }
    void read_node() {
        may_go_on_ = false;
        split_line();
        const std::int64_t tag = integer("the node's number");
        numbers_.add(tag, fail());
        for (int k = 0; k < 3; ++k) {
            const std::string_view text = word("coordinate");
            double x = 0;
            const NumberStatus status = parse_number(text, x);
            if (status != NumberStatus::ok)
                lines_.fail(fmt::format("coordinate: {} {}", quote(text), describe(status)));
            mesh_.points.push_back(x);
        }
    }
    void read_tetrahedron() {
        may_go_on_ = true;
        split_line();
        const std::int64_t number = integer("the element's number");
        if (has_markers_) element_sets_.add_tetrahedron(number, set_name_, fail());
        for (int k = 0; k < nodes_; ++k) {
            const std::int64_t tag = integer("node");
            mesh_.add_node(static_cast<std::size_t>(k), numbers_.find(tag, fail()));
        }
    }

    void read_facet() {
        may_go_on_ = true;
        ++mesh_.other_cells;
        split_line();
        integer("the element's number");
        for (int k = 0; k < facet_.nodes; ++k) {
            const std::int64_t tag = integer("node");
            if (k < facet_.corners) mesh_.facets.corners.push_back(numbers_.find(tag, fail()));
        }
        mesh_.facets.end_facet(set_);
    }
    // Elements of a set; those from the first to the second number in steps of the third, if the
    // set is generated. Names of other sets are passed over.
    void read_members() {
        may_go_on_ = false;
        split_line();
        if (is_generated_) {
            const std::int64_t first = integer("the first element"),
                               last = integer("the last element"),
                               step = at_ < words_.size() ? integer("the step") : 1;
            // Generated sets have no more elements than the file has bytes: otherwise a small file
            // could fill the memory.
            if (last < first || (last - first) / step >= generated_left_)
                lines_.fail(fmt::format("{} to {}: too many elements", first, last));
            generated_left_ -= (last - first) / step + 1;
            for (std::int64_t number = first; number <= last; number += step)
                element_sets_.add_member(set_name_, number);
            return;
        }
        for (const std::string_view word : words_) {
            std::int64_t number = 0;
            if (parse_integer(word, number)) element_sets_.add_member(set_name_, number);
        }
    }
    // Sets are numbered from 1 in the order of their appearance; 0 stands for no set.
    std::int32_t number_of_set(const std::string& name) {
        if (name.empty()) return 0;
        const auto found = std::find(sets_.begin(), sets_.end(), name);
        if (found == sets_.end()) {
            sets_.push_back(name);
            const auto number = static_cast<std::int32_t>(sets_.size());
            mesh_.facets.names[number] = name;
            return number;
        }
        return static_cast<std::int32_t>(found - sets_.begin()) + 1;
    }

    const Source& source_;
    LineReader lines_;
    const bool has_facets_, has_markers_;
    std::int64_t generated_left_;  // how many elements may still be generated
    Mesh mesh_;
    FacetType facet_;
    std::vector<std::string> sets_;
    std::int32_t set_ = 0;  // the set of the facets in this section
    std::string set_name_;
    ElementSets element_sets_;
    NodeNumbers numbers_;
    std::vector<std::string_view> words_;
    std::size_t at_ = 0;
    std::string_view text_;  // the rest of the line
    int nodes_ = 0;          // of each tetrahedron in this section
    bool has_nodes_ = false, may_go_on_ = false, is_generated_ = false;
};

Mesh read_abaqus(const Source& source, const ReadOptions& options) {
    return Reader(source, options).read();
}

constexpr RowStyle numbered_from_one = {1, ", ", ", ", "\n"};

void write_nodes(const std::vector<double>& points, OutputFile& out, const WriteOptions&) {
    out.write("*HEADING\nmgdt\n*NODE\n");
    write_points(points, numbered_from_one, out);
}

// The label of a set: the name of its marker, if it has one, or the marker. Labels begin with a
// letter.
std::string label(const char* what, std::int32_t marker, const MarkerNames& names) {
    const auto found = names.find(marker);
    if (found != names.end()) {
        const std::string& name = found->second;
        const auto is_letter = [](char c) {
            return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
        };
        if (!name.empty() && name.size() <= 80 && is_letter(name[0]) &&
            std::all_of(name.begin(), name.end(),
                        [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; }))
            return name;
    }
    return fmt::format("{}_{}{}", what, marker < 0 ? "M" : "", std::abs(std::int64_t{marker}));
}

// Sets of elements, at most 16 in a line.
void write_regions(const std::vector<std::int32_t>& regions, OutputFile& out) {
    for (const MarkerGroup& group : groups_of(regions)) {
        out.write(fmt::format("*ELSET, ELSET={}\n", label("REGION", group.marker, {})));
        for (std::size_t i = 0; i < group.members.size(); ++i) {
            out.write_integer(static_cast<std::int64_t>(group.members[i]) + 1);
            out.write(i % 16 == 15 || i + 1 == group.members.size() ? "\n" : ", ");
        }
    }
}

// Surfaces of faces of elements. S1 has the corners 1, 2 and 3, S2 1, 4, 2, S3 2, 4, 3 and S4 3,
// 4, 1.
void write_surfaces(const MarkedFaces& faces, OutputFile& out) {
    constexpr int opposite_corner[4] = {3, 4, 2, 1};
    for (const MarkerGroup& group : groups_of(faces.markers)) {
        out.write(fmt::format("*SURFACE, TYPE=ELEMENT, NAME={}\n",
                              label("FACETS", group.marker, faces.names)));
        for (const std::size_t f : group.members)
            out.write(fmt::format("{}, S{}\n", faces.sides[f] / 4 + 1,
                                  opposite_corner[faces.sides[f] % 4]));
    }
}

void write_mesh(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                const WriteOptions& options) {
    OutputFile& out = outputs.open(path);
    write_nodes(mesh.points, out, options);
    out.write("*ELEMENT, TYPE=C3D4, ELSET=ALL\n");
    write_rows_of_4(mesh.tetrahedra, 1, numbered_from_one, out);
    if (has_marker(mesh.regions)) write_regions(mesh.regions, out);
    write_surfaces(mesh.faces, out);
}

}  // namespace

const Format& abaqus_format() {
    static const Format format = [] {
        Format f = {"abaqus",    {".inp"},  "input of Abaqus and CalculiX, C3D4",
                    false,       sniff,     read_abaqus,
                    write_nodes, write_mesh};
        f.has_facets = true;
        return f;
    }();
    return format;
}

}  // namespace mgdt::cli
