// SPDX-License-Identifier: MIT
// POSCAR and CONTCAR files of VASP: a title, a scale, three vectors, perhaps the names of elements,
// how many atoms there are of each, perhaps "Selective dynamics", "Direct" or "Cartesian", and the
// atoms.
#include <fmt/core.h>

#include <cmath>

#include "cli/errors.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"
#include "cli/formats/number.hpp"

namespace mgdt::cli {
namespace {

class PoscarReader {
  public:
    explicit PoscarReader(const Source& source) : lines_(source) {}

    Mesh read() {
        Mesh mesh;
        next("a title");
        read_vectors();
        const std::int64_t count = read_counts();
        const bool is_direct = read_kind();
        mesh.detail = is_direct ? "fractional coordinates" : "Cartesian coordinates";
        if (static_cast<std::uint64_t>(count) > (lines_.bytes_left() + 1) / 6)
            lines_.fail(fmt::format("{} atoms are announced, but only {} bytes follow", count,
                                    lines_.bytes_left()));
        for (std::int64_t i = 0; i < count; ++i) {
            Fields fields = next("an atom");
            double s[3];
            for (double& x : s) x = fields.number("a coordinate");
            std::array<double, 3> x = box_.place(s);
            if (!is_direct)
                for (std::size_t c = 0; c < 3; ++c) x[c] = s[c] * scales_[c];
            for (std::size_t c = 0; c < 3; ++c)
                if (!std::isfinite(x[c])) lines_.fail("the coordinates of the atom are too large");
            mesh.points.insert(mesh.points.end(), x.begin(), x.end());
        }
        mesh.box = box_;
        return mesh;
    }

  private:
    Fields next(const char* what) {
        if (!lines_.next()) lines_.fail(fmt::format("the file ends where {} is to follow", what));
        return Fields(lines_);
    }
    void read_vectors() {
        Fields fields = next("the scale");
        scales_[0] = scales_[1] = scales_[2] = fields.number("the scale");
        double more[2];
        std::string_view word;
        std::size_t count = 0;
        while (count < 2 && fields.next(word) &&
               parse_number(word, more[count]) == NumberStatus::ok)
            ++count;
        if (count == 2) {
            scales_[1] = more[0];
            scales_[2] = more[1];
        }
        for (std::size_t k = 0; k < 3; ++k) {
            Fields row = next("a vector");
            for (std::size_t c = 0; c < 3; ++c) box_.vectors[3 * k + c] = row.number("a vector");
        }
        // A negative scale is the volume of the box.
        if (scales_[0] < 0) {
            const auto& v = box_.vectors;
            const double volume =
                std::fabs(v[0] * (v[4] * v[8] - v[5] * v[7]) - v[1] * (v[3] * v[8] - v[5] * v[6]) +
                          v[2] * (v[3] * v[7] - v[4] * v[6]));
            scales_[0] = scales_[1] = scales_[2] = std::cbrt(-scales_[0] / volume);
        }
        for (std::size_t i = 0; i < 9; ++i) {
            box_.vectors[i] *= scales_[i % 3];
            if (!std::isfinite(box_.vectors[i]))
                lines_.fail("the vectors have no volume, or one too large");
        }
    }
    // The number of all atoms.
    std::int64_t read_counts() {
        Fields fields = next("the numbers of atoms");
        std::string_view word;
        std::int64_t count = 0;
        // Since version 5 the names of the elements come first.
        if (Fields(fields).next(word) && !parse_integer(word, count))
            fields = next("the numbers of atoms");
        std::int64_t sum = 0;
        bool has_any = false;
        while (fields.next(word) && parse_integer(word, count)) {
            constexpr std::int64_t most = std::int64_t{1} << 40;
            if (count < 0 || count > most || sum > most)
                lines_.fail(fmt::format("{} is no number of atoms", quote(word)));
            sum += count;
            has_any = true;
        }
        if (!has_any) lines_.fail("the numbers of atoms are expected");
        return sum;
    }
    // Whether the coordinates are fractional.
    bool read_kind() {
        Fields fields = next("Direct or Cartesian");
        std::string_view word = fields.word("Direct or Cartesian");
        if (word[0] == 'S' || word[0] == 's')
            word = next("Direct or Cartesian").word("Direct or Cartesian");
        const char first = word[0];
        return first != 'C' && first != 'c' && first != 'K' && first != 'k';
    }

    LineReader lines_;
    FileBox box_;
    double scales_[3] = {};
};

Mesh read_poscar(const Source& source, const ReadOptions&) {
    return PoscarReader(source).read();
}

}  // namespace

const Format& poscar_format() {
    static const Format format = {"poscar",
                                  {".poscar", ".contcar", ".vasp"},
                                  "VASP, atoms in a box",
                                  false,
                                  nullptr,
                                  read_poscar,
                                  nullptr,
                                  nullptr};
    return format;
}

}  // namespace mgdt::cli
