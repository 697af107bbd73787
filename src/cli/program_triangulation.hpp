// SPDX-License-Identifier: MIT
// An mgdt handle as the program uses it: closed by its scope, its failures thrown as Error, and
// cancelled by Ctrl-C.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/formats/file_mesh.hpp"
#include "mgdt/mgdt.h"

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

// Throws the Error of a call that failed; `what` says where and why.
[[noreturn]] void throw_status(mgdt_status status, const std::string& what);

class Triangulation {
  public:
    explicit Triangulation(const TriangulationOptions& options);
    ~Triangulation();
    Triangulation(const Triangulation&) = delete;
    Triangulation& operator=(const Triangulation&) = delete;

    // Inserts the points, with a progress bar. `name` is the file's, for messages.
    void insert(const std::vector<double>& points, const std::string& name);
    // The same with progress reported to another callback.
    void insert(const std::vector<double>& points, const std::string& name,
                mgdt_progress_fn progress, void* user);

    // Why there are no tetrahedra, where there are none.
    const char* shape() const;

    std::vector<MeshIndex> tetrahedra() const;
    std::vector<MeshIndex> neighbors() const;
    std::vector<MeshIndex> point_map() const;
    // Empty if the check passes, else what is wrong.
    std::string check(int level) const;
    // The tetrahedron of each place, -1 outside the hull.
    std::vector<MeshIndex> locate(const std::vector<double>& places) const;
    // Values at places, from n_fields at each point; see mgdt_interpolate().
    void interpolate(std::int32_t method, std::int32_t outside, std::size_t n_fields,
                     const std::vector<double>& values, const std::vector<double>& places,
                     std::vector<double>& out) const;

    const mgdt_triangulation* get() const { return handle_; }
    mgdt_triangulation* get() { return handle_; }

  private:
    // What the handle says of a call that failed, or else what the status means.
    std::string message(mgdt_status status) const;
    void require(mgdt_status status, const std::string& doing) const;

    mgdt_triangulation* handle_ = nullptr;
    bool quiet_;
};

}  // namespace mgdt::cli
