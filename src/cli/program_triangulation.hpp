// SPDX-License-Identifier: MIT
// Functions of the program for triangulations: they are made from its options, cancelled by Ctrl-C,
// and their failures are thrown as Error.
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
    // Parameters of the order schemes. Without a value the library's default is used.
    std::optional<double> points_per_cell, threshold, separation, round_ratio;
};

// Names of the order schemes that the library knows.
std::vector<std::string> scheme_names();

// Throws the library's failure that is being handled as an Error. `doing` begins the message, and
// `last_error` is the message of the handle if memory was refused.
[[noreturn]] void rethrow_failure(const std::string& doing, const std::string& last_error);

// An empty triangulation with these settings.
Triangulation make_triangulation(const TriangulationOptions& options);

// Inserts the points, with a progress bar unless it is quiet. `name` is the file's, for messages.
void insert(Triangulation& t, const std::vector<double>& points, const std::string& name,
            bool quiet);

// Says why there are no tetrahedra.
const char* shape(const Triangulation& t);

// Tetrahedra and neighbours, in the form of the program's meshes.
std::vector<MeshIndex> tetrahedra(const Triangulation& t);
std::vector<MeshIndex> neighbors(const Triangulation& t);

// Checks the triangulation. Returns the defect, or an empty text if there is none.
std::string find_defect(const Triangulation& t, int level);

// Interpolates values at places from n_fields values at each point; see mgdt_interpolate().
std::vector<double> interpolate(const Triangulation& t, Method method, Outside outside,
                                std::size_t n_fields, const std::vector<double>& values,
                                const std::vector<double>& places, bool quiet);

}  // namespace mgdt::cli
