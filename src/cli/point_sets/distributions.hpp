// SPDX-License-Identifier: MIT
//
// Points to try a triangulation on: the distributions of S.H. Lo (Finite Elements in Analysis and
// Design 90 (2014) 113-130), the nodes of refined finite-element meshes, and sets made to be hard.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mgdt::cli {

struct Distribution {
    const char* name;
    const char* description;
    const char* data_file = nullptr;  // the mesh that it uses, if any
};

// All kinds, in the order for lists.
const std::vector<Distribution>& distributions();

struct GenerateOptions {
    std::uint64_t seed = 1;
    double width = 0;            // of the spread about a curve or surface; 0 for the kind's own
    double power = 0;            // of the crowding in clusters; 0 for the kind's own
    double scale = 1;            // a factor of all coordinates
    std::string data_directory;  // the folder of machine.msh and church.msh
};

// The path of the mesh that a kind uses; empty if it uses none.
std::string data_path(const std::string& kind, const std::string& data_directory);

// The coordinates x y z of n points, one point after the other. integer-sphere has 6630 points at
// most. Throws std::invalid_argument for an unknown kind and std::runtime_error for an unusable
// data file.
std::vector<double> generate(const std::string& kind, std::size_t n,
                             const GenerateOptions& options);

}  // namespace mgdt::cli
