// SPDX-License-Identifier: MIT
// Triangulations as the program makes and asks them: with the settings of its options, cancelled by
// Ctrl-C, their failures thrown as Error.
#pragma once

#include <cstdint>
#include <mgdt/mgdt.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/formats/file_mesh.hpp"

namespace mgdt::cli {

struct TriangulationOptions {
    std::string scheme = "auto";
    int threads = 1;
    std::uint64_t seed = 0;
    std::uint64_t memory_limit = 0;  // bytes, 0 for none
    bool compact = false;
    bool canonical = false;
    bool quiet = false;
    // Of the order schemes; those left out keep the library's defaults.
    std::optional<double> points_per_cell, threshold, separation, round_ratio;
};

// Names of the order schemes that the library knows.
std::vector<std::string> scheme_names();

// Throws the failure of the library that is being handled as an Error. Its message says what was
// done, and has the last one of the handle where memory was refused.
[[noreturn]] void rethrow_failure(const std::string& doing, const std::string& last_error);

// An empty triangulation with these settings.
Triangulation make_triangulation(const TriangulationOptions& options);

// Inserts the points, with a progress bar unless it is quiet. `name` is the file's, for messages.
void insert(Triangulation& t, const std::vector<double>& points, const std::string& name,
            bool quiet);

// Why there are no tetrahedra, where there are none.
const char* shape(const Triangulation& t);

// One behind the other, as the program's meshes have them.
std::vector<MeshIndex> tetrahedra(const Triangulation& t);
std::vector<MeshIndex> neighbors(const Triangulation& t);

// What the check finds wrong; empty if it passes.
std::string find_defect(const Triangulation& t, int level);

// Values at places, from n_fields at each point; see mgdt_interpolate().
std::vector<double> interpolate(const Triangulation& t, Method method, Outside outside,
                                std::size_t n_fields, const std::vector<double>& values,
                                const std::vector<double>& places, bool quiet);

}  // namespace mgdt::cli
