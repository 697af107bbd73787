// SPDX-License-Identifier: MIT
#include "cli/formats/pieces.hpp"

#include <fmt/core.h>

#include "cli/formats/grid.hpp"
#include "cli/formats/xml.hpp"
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

void write_piece(const Piece& piece, bool compress, OutputFile& out) {
    write_grid({piece.points, piece.corners, 4, vtk_tetra, {}, &piece.ids, compress}, out);
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
