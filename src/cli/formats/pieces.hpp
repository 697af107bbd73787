// SPDX-License-Identifier: MIT
// A mesh in pieces, as ParaView reads them: a .pvtu file that names a .vtu file for each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/formats/file_mesh.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli {

struct Piece {
    std::vector<double> points;      // x y z of each
    std::vector<std::int64_t> ids;   // of each, its place among the points that were read
    std::vector<MeshIndex> corners;  // 4 places in `points` for each tetrahedron
};

bool is_pieces_path(const std::string& path);
// The files of so many pieces, beside the one that names them.
std::vector<std::string> piece_paths(const std::string& path, int count);

void write_piece(const Piece& piece, bool compress, OutputFile& out);
void write_index_of_pieces(const std::vector<std::string>& files, OutputFile& out);

// The pieces beyond the first `count` that the file at the path names, if it is an index of pieces
// of before: nothing names them once another index has its place.
std::vector<std::string> pieces_left_over(const std::string& path, std::size_t count);
void remove_pieces(const std::vector<std::string>& pieces) noexcept;

}  // namespace mgdt::cli
