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
    const char* data_file = nullptr;  // Name of the mesh that it is made from, if it is.
};

// All kinds, in the order in which they are best listed.
const std::vector<Distribution>& distributions();

struct GenerateOptions {
    std::uint64_t seed = 1;
    double width = 0;            // Of the spread about a curve or surface; 0: the kind's own.
    double power = 0;            // Of the crowding in clusters; 0: the kind's own.
    double scale = 1;            // Every coordinate is multiplied by it.
    std::string data_directory;  // Where machine.msh and church.msh are.
};

// Path of the mesh that points of a kind are made from; empty if they are made from none.
std::string data_path(const std::string& kind, const std::string& data_directory);

// The coordinates of n points, x y z of each in turn. integer-sphere has 6630 points and gives no
// more. Throws std::invalid_argument for an unknown kind, std::runtime_error for a data file that
// cannot be used.
std::vector<double> generate(const std::string& kind, std::size_t n,
                             const GenerateOptions& options);

}  // namespace mgdt::cli
