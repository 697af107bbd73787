// SPDX-License-Identifier: MIT
#include "periodic/vertex_neighbors.hpp"

#include <algorithm>

namespace mgdt {
namespace {

bool is_same(const Image& a, const Image& b) {
    return !is_before(a, b) && !is_before(b, a);
}

}  // namespace

VertexNeighbors::VertexNeighbors(Allocator& allocator, const PeriodicTetrahedra& tetrahedra,
                                 std::size_t points)
    : begin(allocator), images(allocator) {
    // The tetrahedra at each point: four times the number, plus the corner.
    Buffer<std::uint64_t> first(allocator), corners(allocator);
    first.resize(points + 1, std::uint64_t{0});
    const auto each_corner = [&](const auto& f) {
        tetrahedra.each_tetrahedron([&](std::size_t i, const PeriodicTetrahedra::Tetrahedron& t) {
            for (unsigned k = 0; k < 4; ++k) f(t.corners[k].point, 4 * i + k);
        });
    };
    each_corner([&](std::uint32_t point, std::size_t) { ++first[point + std::size_t{1}]; });
    for (std::size_t p = 0; p < points; ++p) first[p + 1] += first[p];
    corners.resize(static_cast<std::size_t>(first[points]));
    each_corner([&](std::uint32_t point, std::size_t corner) { corners[first[point]++] = corner; });
    begin.resize(points + 1, std::uint64_t{0});
    Buffer<Image> found(allocator);
    std::uint64_t from = 0;
    for (std::size_t p = 0; p < points; ++p) {
        found.clear();
        for (std::uint64_t i = from; i < first[p]; ++i) {
            const PeriodicTetrahedra::Tetrahedron t =
                tetrahedra[static_cast<std::size_t>(corners[i] / 4)];
            const Image* const of = t.corners;
            const auto own = static_cast<unsigned>(corners[i] % 4);
            for (unsigned k = 0; k < 4; ++k)
                if (k != own)
                    found.push_back(image_of(of[k].point, of[k].multiples() - of[own].multiples()));
        }
        from = first[p];
        std::sort(found.begin(), found.end(), is_before);
        const Image* const end = std::unique(found.begin(), found.end(), is_same);
        for (const Image* image = found.begin(); image != end; ++image) images.push_back(*image);
        begin[p + 1] = images.size();
    }
}

}  // namespace mgdt
