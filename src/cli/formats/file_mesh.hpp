// SPDX-License-Identifier: MIT
// The contents of a file: points, tetrahedra if it has them, and fields if they are asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cli/file_identity.hpp"
#include "cli/formats/file_box.hpp"
#include "cli/formats/file_facets.hpp"
#include "cli/formats/marked_faces.hpp"

namespace mgdt::cli {

// The number of a point or a tetrahedron, from 0, or -1. 32 bits are enough for one triangulation,
// and arrays of 64 bits would take more memory than the triangulation.
using MeshIndex = std::int32_t;
constexpr std::size_t most_in_mesh = std::numeric_limits<MeshIndex>::max();

// Values at the points, `components` numbers at each.
struct Field {
    std::string name;
    std::size_t components = 1;
    std::vector<double> values;
};

struct Mesh {
    std::vector<double> points;         // x y z of each point
    std::vector<MeshIndex> tetrahedra;  // 4 vertices per tetrahedron
    std::vector<MeshIndex> neighbors;   // 4 each, opposite the vertices; -1 for none; or empty
    std::optional<int> first_number;    // 0 or 1, if the format leaves it open
    bool has_tetrahedra = false;        // whether the file has tetrahedra, perhaps none
    std::size_t other_cells = 0;        // the number of other cells, which are left out
    // The nodes of higher-order tetrahedra other than their corners, in any order and with repeats.
    // leave_out_mid_side_nodes() removes and counts them.
    std::vector<MeshIndex> mid_side;
    std::size_t mid_side_nodes = 0;
    std::vector<Field> fields;          // values at the points
    FileFacets facets;                  // if they are asked for
    std::vector<std::int32_t> regions;  // the marker of each tetrahedron; or empty
    MarkedFaces faces;                  // those that are parts of facets; or none
    std::optional<FileBox> box;         // if the file has one
    std::string detail;                 // version and encoding, for people
    std::vector<FileIdentity> inputs;   // the files that were read

    std::size_t point_count() const { return points.size() / 3; }
    std::size_t tetrahedron_count() const { return tetrahedra.size() / 4; }
    // Adds the k-th node of a tetrahedron; corners come first. Readers check that the node exists,
    // and read_mesh() that there are not too many.
    void add_node(std::size_t k, std::int64_t point) {
        (k < 4 ? tetrahedra : mid_side).push_back(static_cast<MeshIndex>(point));
    }
};

}  // namespace mgdt::cli
