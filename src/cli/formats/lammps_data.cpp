// SPDX-License-Identifier: MIT
// Data files of LAMMPS: a title, a header with the number of atoms and the box, and sections, of
// which Atoms is read.
#include <fmt/core.h>

#include <vector>

#include "cli/errors.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"
#include "cli/formats/number.hpp"

namespace mgdt::cli {
namespace {

// Styles of atoms, and the column of x from 1. docs.lammps.org/read_data.html has them.
struct Style {
    std::string_view name;
    int column;
};
constexpr Style styles[] = {{"atomic", 3}, {"angle", 4},     {"bond", 4},     {"molecular", 4},
                            {"charge", 4}, {"full", 5},      {"dpd", 4},      {"sphere", 5},
                            {"mdpd", 4},   {"ellipsoid", 5}, {"line", 6},     {"tri", 6},
                            {"body", 5},   {"dipole", 4},    {"electron", 6}, {"peri", 5},
                            {"edpd", 5},   {"spin", 3},      {"template", 6}};

class DataReader {
  public:
    DataReader(const Source& source, const ReadOptions& options)
        : lines_(source), options_(options) {}

    Mesh read() {
        Mesh mesh;
        lines_.next();  // the title
        bool has_atoms = false;
        while (lines_.next_with_text()) {
            const std::vector<std::string_view> words = split(lines_.text());
            if (words[0] == "Atoms") {
                read_atoms(mesh);
                has_atoms = true;
                break;
            }
            read_header(words);
        }
        if (!has_atoms) lines_.source().fail("has no section Atoms");
        const bool has_box = has_[0] && has_[1] && has_[2];
        if (is_general_) mesh.box = general_;
        if (!is_general_ && has_box) mesh.box = tilted_box(lengths_, tilts_);
        return mesh;
    }

  private:
    static std::vector<std::string_view> split(std::string_view text) {
        std::vector<std::string_view> words;
        std::size_t at = 0;
        while (true) {
            while (at < text.size() && is_blank(text[at])) ++at;
            if (at == text.size()) return words;
            const std::size_t begin = at;
            while (at < text.size() && !is_blank(text[at])) ++at;
            words.push_back(text.substr(begin, at - begin));
        }
    }
    bool ends_with(const std::vector<std::string_view>& words, std::string_view a,
                   std::string_view b) const {
        return words.size() >= 2 && words[words.size() - 2] == a && words.back() == b;
    }
    // A line of the header has numbers and what they are. Other lines are counts that do not
    // matter.
    void read_header(const std::vector<std::string_view>& words) {
        Fields fields(lines_);
        constexpr std::string_view ends[3][2] = {{"xlo", "xhi"}, {"ylo", "yhi"}, {"zlo", "zhi"}};
        for (std::size_t k = 0; k < 3; ++k)
            if (ends_with(words, ends[k][0], ends[k][1])) {
                const double low = fields.number("a bound of the box");
                lengths_[k] = fields.number("a bound of the box") - low;
                has_[k] = true;
            }
        if (ends_with(words, "xz", "yz"))
            for (double& tilt : tilts_) tilt = fields.number("a tilt of the box");
        constexpr std::string_view vectors[3] = {"avec", "bvec", "cvec"};
        for (std::size_t k = 0; k < 3; ++k)
            if (words.back() == vectors[k]) {
                for (std::size_t c = 0; c < 3; ++c)
                    general_.vectors[3 * k + c] = fields.number("a vector of the box");
                is_general_ = true;
            }
        if (words.size() == 2 && words[1] == "atoms")
            announced_ = fields.integer("the number of atoms", 0, std::int64_t{1} << 40);
    }
    // The column of x: that of the style which the comment names, or which the number of columns
    // leaves open no other.
    int column_of_x(std::string_view style, std::size_t columns) const {
        if (options_.columns) return 0;
        for (const Style& known : styles)
            if (style == known.name) return known.column;
        // With or without the three numbers of images.
        if (style.empty() && (columns == 5 || columns == 8)) return 3;
        lines_.fail(
            fmt::format("the section Atoms has {}; say which columns are x, y and z, with {}",
                        style.empty() ? "no style" : fmt::format("the style {}", quote(style)),
                        options_.columns_option));
    }
    void read_atoms(Mesh& mesh) {
        // The comment behind the title names the style.
        const std::string_view line = whole_line();
        const std::size_t mark = line.find('#');
        const std::vector<std::string_view> comment =
            split(mark == std::string_view::npos ? "" : line.substr(mark + 1));
        const std::string_view style = comment.empty() ? std::string_view() : comment[0];
        mesh.detail = style.empty() ? "atoms" : fmt::format("atoms, {}", printable(style));
        if (announced_ < 0) lines_.fail("the number of atoms has to come before the section Atoms");
        if (static_cast<std::uint64_t>(announced_) > (lines_.bytes_left() + 1) / 8)
            lines_.fail(fmt::format("{} atoms are announced, but only {} bytes follow", announced_,
                                    lines_.bytes_left()));
        std::array<int, 3> columns = {};
        for (std::int64_t i = 0; i < announced_; ++i) {
            if (!lines_.next_with_text())
                lines_.fail(fmt::format("{} atoms are announced, and {} follow", announced_, i));
            const std::vector<std::string_view> words = split(lines_.text());
            if (i == 0) {
                const int x = column_of_x(style, words.size());
                columns = options_.columns.value_or(std::array<int, 3>{x, x + 1, x + 2});
            }
            for (const int c : columns) {
                double value = 0;
                const auto at = static_cast<std::size_t>(c - 1);
                if (at >= words.size())
                    lines_.fail(
                        fmt::format("{} columns, but column {} is needed", words.size(), c));
                const NumberStatus status = parse_number(words[at], value);
                if (status != NumberStatus::ok)
                    lines_.fail(
                        fmt::format("column {}: {} {}", c, quote(words[at]), describe(status)));
                mesh.points.push_back(value);
            }
        }
    }
    // The line with its comment.
    std::string_view whole_line() const {
        const std::string_view bytes = lines_.source().bytes;
        const auto begin = static_cast<std::size_t>(lines_.text().data() - bytes.data());
        const std::size_t end = bytes.find_first_of("\r\n", begin);
        return bytes.substr(begin, end == std::string_view::npos ? end : end - begin);
    }

    LineReader lines_;
    const ReadOptions& options_;
    std::int64_t announced_ = -1;
    std::array<double, 3> lengths_ = {}, tilts_ = {};
    bool has_[3] = {};
    FileBox general_;
    bool is_general_ = false;
};

Mesh read_data(const Source& source, const ReadOptions& options) {
    return DataReader(source, options).read();
}

}  // namespace

const Format& lammps_data_format() {
    static const Format format = {"lammps",
                                  {".lmp", ".lammps", ".data"},
                                  "LAMMPS data, atoms in a box",
                                  false,
                                  nullptr,
                                  read_data,
                                  nullptr,
                                  nullptr};
    return format;
}

}  // namespace mgdt::cli
