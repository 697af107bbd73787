// SPDX-License-Identifier: MIT
// A mesh in pieces for ParaView: a .pvtu file that names one .vtu file per piece.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/formats/file_mesh.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli {

struct Piece {
    std::vector<double> points;      // x y z of each point
    std::vector<std::int64_t> ids;   // the position of each point in the input
    std::vector<MeshIndex> corners;  // 4 positions in `points` per tetrahedron
};

bool is_pieces_path(const std::string& path);
// The paths of `count` pieces, in the folder of the file that names them.
std::vector<std::string> piece_paths(const std::string& path, int count);

void write_piece(const Piece& piece, bool compress, OutputFile& out);
void write_index_of_pieces(const std::vector<std::string>& files, OutputFile& out);

// The pieces from number `count` on that an existing index at this path names. They are obsolete
// when a new index replaces it.
std::vector<std::string> pieces_left_over(const std::string& path, std::size_t count);
void remove_pieces(const std::vector<std::string>& pieces) noexcept;

}  // namespace mgdt::cli
