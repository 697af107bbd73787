// SPDX-License-Identifier: MIT
#include "cli/formats/pieces.hpp"

#include <fmt/core.h>

#include <utility>

#include "cli/formats/grid.hpp"
#include "cli/formats/number.hpp"
#include "cli/formats/xml.hpp"
#include "cli/input_file.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {
namespace {

constexpr std::string_view extension = ".pvtu";

}  // namespace

bool is_pieces_path(const std::string& path) {
    return path.size() > extension.size() &&
           path.compare(path.size() - extension.size(), extension.size(), extension) == 0;
}

std::vector<std::string> piece_paths(const std::string& path, int count) {
    const std::string stem = path.substr(0, path.size() - extension.size());
    std::vector<std::string> paths(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < paths.size(); ++i) paths[i] = fmt::format("{}_{}.vtu", stem, i);
    return paths;
}

std::vector<std::string> pieces_left_over(const std::string& path, std::size_t count) {
    std::vector<std::string> left;
    const auto status = system::status(path);
    constexpr std::size_t longest_index = std::size_t{1} << 26;
    if (!status || status->kind != system::FileKind::regular || status->size > longest_index)
        return left;
    const InputFile file(path);
    const std::string_view text = file.source().bytes;
    const std::string stem = path.substr(0, path.size() - extension.size());
    const std::string begin = stem.substr(system::last_separator(stem) + 1) + "_";
    constexpr std::string_view attribute = "<Piece Source=\"";
    for (std::size_t at = text.find(attribute); at != std::string_view::npos;
         at = text.find(attribute, at)) {
        at += attribute.size();
        const std::size_t end = text.find('"', at);
        if (end == std::string_view::npos) break;
        const std::string name = from_xml(text.substr(at, end - at));
        // Only names that piece_paths() gives.
        if (name.size() <= begin.size() + 4 || name.compare(0, begin.size(), begin) != 0) continue;
        const std::string number = name.substr(begin.size(), name.size() - begin.size() - 4);
        std::int64_t value = 0;
        if (!parse_integer(number, value) || value < static_cast<std::int64_t>(count)) continue;
        std::string piece = fmt::format("{}_{}.vtu", stem, value);
        if (piece.substr(system::last_separator(piece) + 1) == name)
            left.push_back(std::move(piece));
    }
    return left;
}

void remove_pieces(const std::vector<std::string>& pieces) noexcept {
    for (const std::string& piece : pieces) system::remove(piece.c_str());
}

void write_piece(const Piece& piece, bool compress, OutputFile& out) {
    write_grid({piece.points, &piece.corners, 4, vtk_tetra, {}, &piece.ids, compress}, out);
}

void write_index_of_pieces(const std::vector<std::string>& files, OutputFile& out) {
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n"
        "  <PUnstructuredGrid GhostLevel=\"0\">\n"
        "    <PPoints>\n"
        "      <PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n"
        "    </PPoints>\n"
        "    <PPointData>\n"
        "      <PDataArray type=\"Int64\" Name=\"point\"/>\n"
        "    </PPointData>\n";
    for (const std::string& file : files)
        text += fmt::format("    <Piece Source=\"{}\"/>\n",
                            to_xml(file.substr(system::last_separator(file) + 1)));
    text += "  </PUnstructuredGrid>\n</VTKFile>\n";
    out.write(text);
}

}  // namespace mgdt::cli
