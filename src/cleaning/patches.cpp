// SPDX-License-Identifier: MIT
#include "cleaning/patches.hpp"

#include <algorithm>

#include "boundary/boundary_edges.hpp"

namespace mgdt {
namespace {

// Links the triangles at each edge that exactly two triangles have, and no segment.
template <class MayJoin>
Buffer<std::uint32_t> links(const SurfacePieces& pieces, Allocator& allocator, MayJoin may_join) {
    const Buffer<BoundaryEdge> edges = sorted_edges(pieces.boundary, allocator);
    Buffer<std::uint32_t> result(allocator);
    result.resize(pieces.boundary.triangles.size(), no_index);
    for_each_edge(edges, [&](std::size_t i, std::size_t end) {
        if (end - i == 2 && !edges[i + 1].is_segment() &&
            may_join(edges[i].side / 3, edges[i + 1].side / 3)) {
            result[edges[i].side] = edges[i + 1].side;
            result[edges[i + 1].side] = edges[i].side;
        }
    });
    return result;
}

class PatchSearch {
  public:
    PatchSearch(SurfacePieces& pieces, const Buffer<std::int32_t>& markers, const Nearness& near,
                Allocator& allocator)
        : pieces_(pieces),
          markers_(markers),
          near_(near),
          allocator_(allocator),
          links_(links(pieces, allocator,
                       [&](std::uint32_t t, std::uint32_t s) { return marker(t) == marker(s); })) {}

    Buffer<Projection> run() {
        Buffer<Seed> seeds(allocator_);
        for (std::uint32_t t = 0; t < pieces_.triangle_count(); ++t)
            seeds.push_back({length(normal(t)), t});
        std::sort(seeds.begin(), seeds.end());
        pieces_.patch_of_triangle.resize(0);
        pieces_.patch_of_triangle.resize(pieces_.triangle_count(), no_index);
        Buffer<Projection> patches(allocator_);
        for (const Seed& seed : seeds) {
            if (pieces_.patch_of_triangle[seed.triangle] != no_index) continue;
            patches.push_back(Projection(normal(seed.triangle)));
            grow(seed.triangle, static_cast<std::uint32_t>(patches.size() - 1), patches.back());
        }
        return patches;
    }

  private:
    struct Seed {
        double area;
        std::uint32_t triangle;
        friend bool operator<(const Seed& a, const Seed& b) {
            return a.area != b.area ? a.area > b.area : a.triangle < b.triangle;
        }
    };

    std::int32_t marker(std::uint32_t t) const { return markers_[pieces_.facet_of_triangle[t]]; }
    const double* corner(std::uint32_t t, std::uint32_t k) const {
        return pieces_.point(pieces_.triangle(t)[k % 3]);
    }
    Vector<double> normal(std::uint32_t t) const {
        return near_.normal(corner(t, 0), corner(t, 1), corner(t, 2));
    }

    void grow(std::uint32_t seed, std::uint32_t patch, const Projection& projection) {
        Buffer<std::uint32_t> stack(allocator_);
        pieces_.patch_of_triangle[seed] = patch;
        if (projection.turn(corner(seed, 0), corner(seed, 1), corner(seed, 2)) == 0) return;
        stack.push_back(seed);
        while (!stack.empty()) {
            const std::uint32_t t = stack.back();
            stack.pop_back();
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t other = links_[3 * t + k];
                if (other == no_index || pieces_.patch_of_triangle[other / 3] != no_index) continue;
                const double *const a = corner(t, k + 1), *const b = corner(t, k + 2),
                                    *const beyond = corner(other / 3, other % 3);
                if (projection.turn(a, b, corner(t, k)) * projection.turn(a, b, beyond) >= 0 ||
                    !near_.is_in_plane(corner(seed, 0), corner(seed, 1), corner(seed, 2), beyond))
                    continue;
                pieces_.patch_of_triangle[other / 3] = patch;
                stack.push_back(other / 3);
            }
        }
    }

    SurfacePieces& pieces_;
    const Buffer<std::int32_t>& markers_;
    const Nearness& near_;
    Allocator& allocator_;
    Buffer<std::uint32_t> links_;
};

}  // namespace

Buffer<Projection> find_patches(SurfacePieces& pieces, const Buffer<std::int32_t>& facet_markers,
                                const Nearness& near, Allocator& allocator) {
    return PatchSearch(pieces, facet_markers, near, allocator).run();
}

Buffer<std::uint32_t> links_in_patches(const SurfacePieces& pieces, Allocator& allocator) {
    return links(pieces, allocator, [&](std::uint32_t t, std::uint32_t s) {
        return pieces.patch_of_triangle[t] == pieces.patch_of_triangle[s];
    });
}

}  // namespace mgdt
