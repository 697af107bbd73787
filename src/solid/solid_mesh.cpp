// SPDX-License-Identifier: MIT
#include "solid/solid_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/tetrahedron.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

void SolidMesh::place_on_segment(const double* a, const double* b, double t, const double* on_grid,
                                 const RoundingGrid& grid, double* x) noexcept {
    bool is_exact = true;
    for (int k = 0; k < 3; ++k)
        for (const double c : {a[k], b[k]}) is_exact = is_exact && grid.unround(grid.round(c)) == c;
    for (int k = 0; k < 3; ++k) {
        x[k] = grid.unround(on_grid[k]);
        // The difference of two large doubles may overflow.
        const double difference = b[k] - a[k];
        if (!is_exact && std::isfinite(difference)) x[k] = a[k] + t * difference;
    }
}

int SolidMesh::side(const Buffer<double>& coordinates, std::uint32_t t,
                    const double* x) const noexcept {
    const auto corner = [&](unsigned i) {
        return coordinates.begin() + 3 * std::size_t{tetrahedra[4 * std::size_t{t} + i]};
    };
    int least = 1;
    for (unsigned i = 0; i < 4 && least >= 0; ++i) {
        const unsigned char* const f = outer_face[i];
        least = std::min(least, -orientation(x, corner(f[0]), corner(f[1]), corner(f[2])));
    }
    return least;
}

}  // namespace mgdt
