// SPDX-License-Identifier: MIT
// The sets of points on which the library is tried: every distribution, degenerate and hostile
// sets, extreme scales.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <ostream>
#include <vector>

#include "cli/point_sets/distributions.hpp"

namespace property {

struct Row {
    const char* name;  // as the test is called
    const char* kind;
    double scale;
    std::size_t most;  // at most that many points: sets of quadratic size, or few distinct points
};

inline constexpr std::size_t any = std::numeric_limits<std::size_t>::max();

// Every row of the table of distributions, and every hostile set but NaN and infinity, which are
// refused (see tests/api/test_arguments.c).
inline constexpr Row rows[] = {
    {"Uniform", "uniform", 1, any},
    {"Line", "line", 1, any},
    {"Diagonal", "diagonal", 1, any},
    {"Ellipse", "ellipse", 1, any},
    {"Sphere", "sphere", 1, any},
    {"Spiral", "spiral", 1, any},
    {"Cluster", "cluster", 1, any},
    {"Galaxy", "galaxy", 1, any},
    {"Mixdiag", "mixdiag", 1, any},
    {"Mixsphere", "mixsphere", 1, any},
    {"Mixspiral", "mixspiral", 1, any},
    {"Machine", "machine", 1, any},
    {"Church", "church", 1, any},
    {"Lattice", "lattice", 1, any},
    {"IntegerSphere", "integer-sphere", 1, any},
    {"MomentCurve", "moment-curve", 1, 300},
    {"TwoLines", "two-lines", 1, 600},
    {"Rounded", "rounded", 1, any},
    {"LatticeRepeats", "lattice-repeats", 1, any},
    {"Coplanar", "coplanar", 1, any},
    {"Collinear", "collinear", 1, any},
    {"OnePoint", "one-point", 1, any},
    {"Anisotropic", "anisotropic", 1, any},
    {"Uniform1e60", "uniform", 1e60, any},
    {"Uniform1e300", "uniform", 1e300, any},
    {"UniformNearTheLargest", "uniform", 0x1.fp1023, any},
    {"Uniform1em300", "uniform", 1e-300, any},
    {"UniformSubnormal", "uniform", 0x1p-1040, any},
    {"Lattice1e60", "lattice", 1e60, any},
    {"Lattice1e300", "lattice", 1e300, any},
    {"Lattice1em300", "lattice", 1e-300, any},
    {"LatticeSubnormal", "lattice", 0x1p-1070, any},
    {"Galaxy1e300", "galaxy", 1e300, any},
    {"GalaxySubnormal", "galaxy", 0x1p-1050, any},
    {"IntegerSphereSubnormal", "integer-sphere", 0x1p-1074, any},
};

inline std::ostream& operator<<(std::ostream& out, const Row& row) {
    return out << row.name;
}

// At most n points of a row. At extreme scales every decision is exact and slow, so they are few.
inline std::vector<double> points(const Row& row, std::size_t n) {
    mgdt::cli::GenerateOptions options;
    options.scale = row.scale;
    options.data_directory = MGDT_TEST_DATA_DIRECTORY;
    if (row.scale < 1e-100 || row.scale > 1e100) n = std::min<std::size_t>(n, 400 + n / 20);
    std::vector<double> xyz = mgdt::cli::generate(row.kind, std::min(n, row.most), options);
    EXPECT_FALSE(xyz.empty());
    return xyz;
}

}  // namespace property
