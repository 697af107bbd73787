// SPDX-License-Identifier: MIT
// The sizes that are wanted at places: what a new vertex gets, apart from what its neighbours have.
#pragma once

#include <limits>

#include "refinement/size_tree.hpp"

namespace mgdt {

struct PlaceSizes {
    explicit PlaceSizes(Allocator& allocator) : of_regions(allocator), varying(allocator) {}

    double at(const double* x, std::uint32_t region) const noexcept {
        double size = everywhere;
        if (!of_regions.empty()) size = std::min(size, of_regions[region]);
        if (!varying.empty()) size = std::min(size, varying.at(x));
        return size;
    }

    double everywhere = std::numeric_limits<double>::infinity();
    Buffer<double> of_regions;  // empty, or one for each region, infinity for none
    SizeTree varying;           // empty, or what varies in space
};

}  // namespace mgdt
