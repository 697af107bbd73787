// SPDX-License-Identifier: MIT
// Random boundaries of domains.
#pragma once

#include <random>

#include "surfaces.hpp"

namespace mgdt {

inline bool is_valid(const DomainInput& input) {
    Allocator allocator;
    Team team;
    const Complex complex = make_complex(input, allocator);
    return complex.bad_facets.empty() &&
           offending_pairs(complex.boundary, team, allocator, Unwatched()).empty();
}

// Gives a domain random triangles and segments that do not cross, on small lattices, where nearly
// everything is degenerate, or in general position.
inline void give_random_complex(MeshedDomain& domain, unsigned seed) {
    std::mt19937 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const int n = 2 + below(5), points = 4 + below(30), tries = 1 + below(50), kind = below(3);
    domain.settings().takes_open_surfaces = true;
    DomainInput& input = domain.input();
    for (int i = 0; i < 3 * points; ++i)
        input.points.push_back(kind == 0   ? below(n)
                               : kind == 1 ? below(n) + (below(3) == 0 ? 1e-3 * below(1000) : 0)
                                           : 1e-5 * n * below(100000));
    input.facet_begin.push_back(0);
    for (int k = 0; k < tries; ++k) {
        const bool is_segment = below(6) == 0;
        std::uint32_t v[3];
        for (std::uint32_t& of : v) of = static_cast<std::uint32_t>(below(points));
        Buffer<std::uint32_t>& to = is_segment ? input.segments : input.corners;
        Buffer<std::int32_t>& markers = is_segment ? input.segment_markers : input.facet_markers;
        const std::size_t before = to.size();
        for (int i = 0; i < (is_segment ? 2 : 3); ++i) to.push_back(v[i]);
        markers.push_back(below(2));
        if (!is_segment) input.facet_begin.push_back(static_cast<std::uint32_t>(to.size()));
        if (is_valid(input)) continue;
        to.resize(before);
        markers.pop_back();
        if (!is_segment) input.facet_begin.pop_back();
    }
}

}  // namespace mgdt
