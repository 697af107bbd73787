// SPDX-License-Identifier: MIT
#include "cleaning/equal_triangles.hpp"

#include <algorithm>

namespace mgdt {

bool remove_equal_triangles(SurfacePieces& pieces, const Buffer<double>& facet_areas,
                            Buffer<CoveredFacet>& covered, Buffer<std::uint8_t>& is_changed,
                            Allocator& allocator) {
    struct Corners {
        std::uint32_t v[3], triangle;
    };
    Buffer<Corners> sorted(allocator, pieces.triangle_count());
    for (std::uint32_t t = 0; t < sorted.size(); ++t) {
        std::copy_n(pieces.triangle(t), 3, sorted[t].v);
        std::sort(sorted[t].v, sorted[t].v + 3);
        sorted[t].triangle = t;
    }
    // Areas that differ by rounding alone are equal.
    const auto is_preferred = [&](std::uint32_t t, std::uint32_t to) {
        const std::uint32_t f = pieces.facet_of_triangle[t], g = pieces.facet_of_triangle[to];
        constexpr double tolerance = 1e-6;
        const double a = facet_areas[f], b = facet_areas[g];
        if (std::abs(a - b) > tolerance * std::max(a, b)) return a < b;
        return f != g ? f < g : t < to;
    };
    std::sort(sorted.begin(), sorted.end(), [&](const Corners& a, const Corners& b) {
        for (int k = 0; k < 3; ++k)
            if (a.v[k] != b.v[k]) return a.v[k] < b.v[k];
        return a.triangle < b.triangle;
    });
    Buffer<std::uint8_t> is_removed(allocator);
    is_removed.resize(sorted.size(), std::uint8_t{0});
    bool found = false;
    for (std::size_t i = 0; i < sorted.size();) {
        std::size_t end = i + 1, best = i;
        for (; end < sorted.size() && std::equal(sorted[i].v, sorted[i].v + 3, sorted[end].v);
             ++end)
            if (is_preferred(sorted[end].triangle, sorted[best].triangle)) best = end;
        const std::uint32_t stays = pieces.facet_of_triangle[sorted[best].triangle];
        for (std::size_t k = i; k < end; ++k) {
            if (k == best) continue;
            const std::uint32_t t = sorted[k].triangle, facet = pieces.facet_of_triangle[t];
            is_removed[t] = is_changed[facet] = 1;
            found = true;
            if (facet != stays) covered.push_back({facet, stays});
        }
        i = end;
    }
    if (!found) return false;
    SurfacePieces left(allocator);
    for (std::uint32_t t = 0; t < sorted.size(); ++t) {
        if (is_removed[t] != 0) continue;
        const std::uint32_t* const v = pieces.triangle(t);
        left.add_triangle(v[0], v[1], v[2], pieces.facet_of_triangle[t], pieces.is_new[t]);
        left.patch_of_triangle.back() = pieces.patch_of_triangle[t];
    }
    std::swap(pieces.boundary.triangles, left.boundary.triangles);
    std::swap(pieces.facet_of_triangle, left.facet_of_triangle);
    std::swap(pieces.patch_of_triangle, left.patch_of_triangle);
    std::swap(pieces.is_new, left.is_new);
    return true;
}

}  // namespace mgdt
