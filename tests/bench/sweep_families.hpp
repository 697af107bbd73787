// SPDX-License-Identifier: MIT
// Families of point sets over which sweep_cgal.cpp and sweep_calls.cpp look for the sets that suit
// mgdt least.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace bench {

struct Family {
    std::string name;
    /// About n points, x y z of each in turn, the same ones each time.
    std::function<std::vector<double>(std::size_t n)> points;
    /// The size at which one set stays small: sets with a quadratic number of tetrahedra have
    /// fewer points.
    std::size_t most;
};

/// Point distributions of the program, hard sets of the tests, and those made for this purpose.
std::vector<Family> sweep_families();

}  // namespace bench
