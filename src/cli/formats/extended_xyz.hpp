// SPDX-License-Identifier: MIT
// The second line of extended .xyz files, which has names with values: Lattice="ax ay az bx by bz
// cx cy cz", pbc="T T F", Properties=species:S:1:pos:R:3.
#pragma once

#include <optional>

#include "cli/formats/file_box.hpp"

namespace mgdt::cli {

struct XyzTitle {
    std::optional<FileBox> box;
    std::optional<int> first_column;  // of the positions, from 1
};

// What the current line says. A line without such names says nothing.
XyzTitle read_xyz_title(const LineReader& line);

}  // namespace mgdt::cli
