// SPDX-License-Identifier: MIT
// The periodic box that a file has beside its points.
#pragma once

#include <array>
#include <string_view>

#include "cli/formats/lines.hpp"

namespace mgdt::cli {

struct FileBox {
    std::array<double, 9> vectors = {};                // three vectors
    std::array<bool, 3> repeats = {true, true, true};  // which of them repeat

    // The place with these coordinates along the vectors, from 0 to 1 in the box.
    std::array<double, 3> place(const double (&s)[3]) const {
        std::array<double, 3> x = {};
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t c = 0; c < 3; ++c) x[c] += s[k] * vectors[3 * k + c];
        return x;
    }
};

// A box along the axes, or tilted as LAMMPS does it: its lengths, and the tilts xy, xz and yz.
inline FileBox tilted_box(const std::array<double, 3>& lengths,
                          const std::array<double, 3>& tilts) {
    FileBox box;
    box.vectors = {lengths[0], 0, 0, tilts[0], lengths[1], 0, tilts[1], tilts[2], lengths[2]};
    return box;
}

}  // namespace mgdt::cli
