// SPDX-License-Identifier: MIT
#include "cli/formats/pieces.hpp"

#include <fmt/format.h>

#include "cli/formats/xml.hpp"

namespace mgdt::cli {
namespace {

constexpr std::string_view extension = ".pvtu";
constexpr std::uint8_t vtk_tetra = 10;

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

// Numbers of a piece's points have 32 bits, which halves the file.
void write_piece(const Piece& piece, OutputFile& out) {
    const std::uint64_t cells = piece.corners.size() / 4;
    std::uint64_t offset = 0;
    const auto array = [&offset](const char* type, const char* rest, std::uint64_t bytes) {
        const std::uint64_t begin = offset;
        offset += 8 + bytes;
        return fmt::format(
            "        <DataArray type=\"{}\" {} format=\"appended\" offset=\"{}\"/>\n", type, rest,
            begin);
    };
    std::string head = fmt::format(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n"
        "  <UnstructuredGrid>\n"
        "    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n"
        "      <Points>\n",
        piece.ids.size(), cells);
    head += array("Float64", "Name=\"Points\" NumberOfComponents=\"3\"", 8 * piece.points.size());
    head += "      </Points>\n      <Cells>\n";
    head += array("Int32", "Name=\"connectivity\"", 16 * cells);
    head += array("Int64", "Name=\"offsets\"", 8 * cells);
    head += array("UInt8", "Name=\"types\"", cells);
    head += "      </Cells>\n      <PointData>\n";
    head += array("Int64", "Name=\"point\"", 8 * piece.ids.size());
    head +=
        "      </PointData>\n    </Piece>\n  </UnstructuredGrid>\n"
        "  <AppendedData encoding=\"raw\">\n_";
    out.write(head);
    out.write_value(static_cast<std::uint64_t>(8 * piece.points.size()));
    out.write_values(piece.points.data(), piece.points.size());
    out.write_value(16 * cells);
    for (const std::int64_t corner : piece.corners)
        out.write_value(static_cast<std::int32_t>(corner));
    out.write_value(8 * cells);
    for (std::uint64_t i = 1; i <= cells; ++i) out.write_value(static_cast<std::int64_t>(4 * i));
    out.write_value(cells);
    for (std::uint64_t i = 0; i < cells; ++i) out.write_value(vtk_tetra);
    out.write_value(static_cast<std::uint64_t>(8 * piece.ids.size()));
    out.write_values(piece.ids.data(), piece.ids.size());
    out.write("\n  </AppendedData>\n</VTKFile>\n");
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
                            to_xml(file.substr(file.find_last_of('/') + 1)));
    text += "  </PUnstructuredGrid>\n</VTKFile>\n";
    out.write(text);
}

}  // namespace mgdt::cli
