// SPDX-License-Identifier: MIT
// Sets of points for measurements: the distributions and their mild variants. A set is made once
// and shared by all runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mgdt::cli::bench {

struct PointSetName {
    std::string distribution;
    std::size_t points;  // the number of points that is asked for
    std::uint64_t seed;
};

// The names of all sets: the kinds of `mgdt generate`, and mild-KIND for those with a mild form in
// the paper, which has a width of 1% or a power of 3.
std::vector<std::string> distribution_names();

// Throws Error if a data file that the distribution is made from cannot be read.
void check_data(const std::string& distribution, const std::string& data_directory);

// Points in a file without a name: the coordinates x y z of each point, as doubles.
class PointSet {
  public:
    // Makes the points in a child process, so that this process stays small. `waiting` is called
    // meanwhile.
    PointSet(const PointSetName& name, const std::string& data_directory,
             const std::function<void()>& waiting);
    ~PointSet();
    PointSet(const PointSet&) = delete;
    PointSet& operator=(const PointSet&) = delete;

    // "ok", or a word that says why there are no points.
    const std::string& status() const { return status_; }
    std::size_t points() const;
    // The file, positioned at the first point.
    int file() const;
    std::vector<double> read() const;

  private:
    std::string status_;
    int fd_ = -1;
};

}  // namespace mgdt::cli::bench
