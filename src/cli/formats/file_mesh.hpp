// SPDX-License-Identifier: MIT
// What a file holds: points, tetrahedra where it has them, and fields where they are wanted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cli/file_identity.hpp"

namespace mgdt::cli {

// A number of a point or a tetrahedron, counted from 0, or -1. The library has fewer of each in a
// triangulation, and arrays of 64 bits would take more memory than it.
using MeshIndex = std::int32_t;
constexpr std::size_t most_in_mesh = std::numeric_limits<MeshIndex>::max();

// Values at the points, as many at each as there are components.
struct Field {
    std::string name;
    std::size_t components = 1;
    std::vector<double> values;
};

struct Mesh {
    std::vector<double> points;         // x y z of each
    std::vector<MeshIndex> tetrahedra;  // 4 vertices each
    std::vector<MeshIndex> neighbors;   // 4 each, opposite the vertices, -1 for none; or empty
    std::optional<int> first_number;    // of the points, where the format has it open: 0 or 1
    bool has_tetrahedra = false;        // the file says so, even if there are none
    std::size_t other_cells = 0;        // cells of other shapes, left out
    // The nodes of tetrahedra of higher order but their corners, in any order and with repeats,
    // until leave_out_mid_side_nodes() takes them out and counts them.
    std::vector<MeshIndex> mid_side;
    std::size_t mid_side_nodes = 0;
    std::vector<Field> fields;         // of the points
    std::string detail;                // version and encoding, for people
    std::vector<FileIdentity> inputs;  // the files that it was read from

    std::size_t point_count() const { return points.size() / 3; }
    std::size_t tetrahedron_count() const { return tetrahedra.size() / 4; }
    // Takes the k-th node of a tetrahedron; the corners come first. Readers refuse what is not a
    // point, and read_mesh() too many points.
    void add_node(std::size_t k, std::int64_t point) {
        (k < 4 ? tetrahedra : mid_side).push_back(static_cast<MeshIndex>(point));
    }
};

}  // namespace mgdt::cli
