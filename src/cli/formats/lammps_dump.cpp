// SPDX-License-Identifier: MIT
// Dumps of LAMMPS in text, with one frame: ITEM: lines, each with what it announces.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/errors.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"

namespace mgdt::cli {
namespace {

constexpr std::string_view item = "ITEM:";

class DumpReader {
  public:
    explicit DumpReader(const Source& source) : lines_(source) {}

    Mesh read() {
        Mesh mesh;
        mesh.detail = "one frame";
        std::int64_t atoms = -1;
        while (lines_.next_with_text(no_comment)) {
            Fields fields(lines_);
            if (fields.word("ITEM:") != item) lines_.fail("an ITEM: is expected");
            const std::string_view what = fields.word("the name of an item");
            if (what == "TIMESTEP") {
                if (has_step_) lines_.fail("the file has more than one frame; split it");
                has_step_ = true;
                skip(1);
            } else if (what == "NUMBER") {
                if (!lines_.next()) lines_.fail("the number of atoms is missing");
                atoms = Fields(lines_).integer("the number of atoms", 0, std::int64_t{1} << 40);
            } else if (what == "BOX") {
                read_box(fields);
            } else if (what == "ATOMS") {
                if (atoms < 0) lines_.fail("the number of atoms has to come first");
                read_atoms(fields, atoms, mesh);
            } else {
                skip(1);  // UNITS and TIME have one line
            }
        }
        if (!has_atoms_) lines_.source().fail("has no ITEM: ATOMS");
        if (has_box_) mesh.box = box_;
        return mesh;
    }

  private:
    void skip(int count) {
        while (count-- > 0)
            if (!lines_.next()) lines_.fail("the file is cut short");
    }
    // BOX BOUNDS, the tilts "xy xz yz" or "abc origin" if there are any, and what the boundaries
    // are.
    void read_box(Fields& fields) {
        std::vector<std::string_view> words;
        std::string_view word;
        while (fields.next(word)) words.push_back(word);
        const auto has = [&](std::string_view w) {
            return std::find(words.begin(), words.end(), w) != words.end();
        };
        const bool is_general = has("abc"), is_tilted = has("xy");
        for (std::size_t k = 0; k < 3 && words.size() >= 3; ++k) {
            const std::string_view boundary = words[words.size() - 3 + k];
            if (boundary.size() == 2) box_.repeats[k] = boundary == "pp";
        }
        double rows[3][4] = {};
        for (auto& row : rows) {
            if (!lines_.next()) lines_.fail("the box is cut short");
            Fields numbers(lines_);
            const std::size_t columns = is_general ? 4 : is_tilted ? 3 : 2;
            for (std::size_t c = 0; c < columns; ++c) row[c] = numbers.number("a bound of the box");
        }
        has_box_ = true;
        if (is_general) {
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t c = 0; c < 3; ++c) box_.vectors[3 * k + c] = rows[k][c];
                origin_[k] = rows[k][3];
            }
            return;
        }
        // The bounds are those of the tilted box.
        const double xy = rows[0][2], xz = rows[1][2], yz = rows[2][2];
        rows[0][0] -= std::min({0.0, xy, xz, xy + xz});
        rows[0][1] -= std::max({0.0, xy, xz, xy + xz});
        rows[1][0] -= std::min(0.0, yz);
        rows[1][1] -= std::max(0.0, yz);
        const std::array<bool, 3> repeats = box_.repeats;
        box_ =
            tilted_box({rows[0][1] - rows[0][0], rows[1][1] - rows[1][0], rows[2][1] - rows[2][0]},
                       {xy, xz, yz});
        box_.repeats = repeats;
        for (std::size_t k = 0; k < 3; ++k) origin_[k] = rows[k][0];
    }
    void read_atoms(Fields& fields, std::int64_t atoms, Mesh& mesh) {
        std::vector<std::string_view> names;
        std::string_view word;
        while (fields.next(word)) names.push_back(word);
        // Unwrapped and scaled coordinates too.
        constexpr std::array<std::string_view, 3> known[] = {
            {"x", "y", "z"}, {"xu", "yu", "zu"}, {"xs", "ys", "zs"}, {"xsu", "ysu", "zsu"}};
        std::array<std::size_t, 3> columns = {};
        bool is_scaled = false, is_found = false;
        for (std::size_t i = 0; i < 4 && !is_found; ++i) {
            is_found = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto at = std::find(names.begin(), names.end(), known[i][k]);
                is_found = is_found && at != names.end();
                columns[k] = static_cast<std::size_t>(at - names.begin());
            }
            is_scaled = i >= 2;
        }
        if (!is_found)
            lines_.fail("the atoms have no columns x y z, xu yu zu, xs ys zs or xsu ysu zsu");
        if (is_scaled && !has_box_) lines_.fail("scaled coordinates need the box before them");
        if (has_atoms_) lines_.fail("the file has more than one frame; split it");
        has_atoms_ = true;
        if (static_cast<std::uint64_t>(atoms) > (lines_.bytes_left() + 1) / 6)
            lines_.fail(fmt::format("{} atoms are announced, but only {} bytes follow", atoms,
                                    lines_.bytes_left()));
        for (std::int64_t i = 0; i < atoms; ++i) {
            if (!lines_.next())
                lines_.fail(fmt::format("{} atoms are announced, and {} follow", atoms, i));
            Fields row(lines_);
            double s[3] = {};
            for (std::size_t c = 0; c < names.size(); ++c) {
                const auto k = std::find(columns.begin(), columns.end(), c);
                if (k == columns.end())
                    row.word("a value");
                else
                    s[k - columns.begin()] = row.number("a coordinate");
            }
            std::array<double, 3> x = {s[0], s[1], s[2]};
            if (is_scaled) {
                x = box_.place(s);
                for (std::size_t k = 0; k < 3; ++k) x[k] += origin_[k];
            }
            for (const double c : x)
                if (!std::isfinite(c)) lines_.fail("the coordinates of the atom are too large");
            mesh.points.insert(mesh.points.end(), x.begin(), x.end());
        }
    }

    LineReader lines_;
    FileBox box_;
    double origin_[3] = {};
    bool has_step_ = false, has_box_ = false, has_atoms_ = false;
};

bool is_dump(std::string_view bytes) {
    return bytes.substr(0, item.size()) == item;
}

Mesh read_dump(const Source& source, const ReadOptions&) {
    return DumpReader(source).read();
}

}  // namespace

const Format& lammps_dump_format() {
    static const Format format = {"dump",
                                  {".dump", ".lammpstrj"},
                                  "LAMMPS dump, one frame",
                                  false,
                                  is_dump,
                                  read_dump,
                                  nullptr,
                                  nullptr};
    return format;
}

}  // namespace mgdt::cli
