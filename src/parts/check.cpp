// SPDX-License-Identifier: MIT
//
// That each part's triangulation is one of Delaunay, that the parts agree on the tetrahedra that
// they share, and that all together are a ball (docs/theory.md, "Parts").
#include "query/check.hpp"

#include <algorithm>
#include <functional>

#include "parts/parts.hpp"

namespace mgdt {
namespace {

// Edges whose least end, by coordinates, is the part's own.
std::uint64_t count_edges(const Part& part, Allocator& allocator) {
    Buffer<std::uint64_t> edges(allocator);
    part.each_tetrahedron([&](TetId, const std::uint32_t(&v)[4], unsigned, bool) {
        for (int i = 0; i < 4; ++i)
            for (int k = i + 1; k < 4; ++k) {
                const bool in_order = precedes(part.point(v[i]).x, part.point(v[k]).x);
                const std::uint32_t low = in_order ? v[i] : v[k], high = in_order ? v[k] : v[i];
                if (low < part.own_count()) edges.push_back(std::uint64_t{low} << 32 | high);
            }
    });
    std::sort(edges.begin(), edges.end());
    return static_cast<std::uint64_t>(std::unique(edges.begin(), edges.end()) - edges.begin());
}

std::uint64_t count_hull_facets(const Part& part, const PartTetrahedra& tetrahedra,
                                Allocator& allocator) {
    Buffer<std::int64_t> neighbors(allocator, 4 * tetrahedra.owned());
    tetrahedra.get_neighbors(part, neighbors.data());
    return static_cast<std::uint64_t>(std::count(neighbors.begin(), neighbors.end(), -1));
}

}  // namespace

void Parts::check(std::int32_t level) {
    collective_.each_local([&](PartId p) {
        const Triangulation& t = parts_[p].triangulation();
        Team team(t.threads_for(t.mesh().tetrahedra.size(), 65536));
        check_triangulation(team, t.check_input(), t.allocator(), level, 0);
    });
    // Fails where one of two parts has a tetrahedron that both must have.
    Objects<PartTetrahedra> again(allocator_, parts_.size(), std::ref(allocator_));
    Buffer<std::int64_t> first(allocator_);
    find_tetrahedra(collective_, homes_, parts_, again, first, allocator_);
    Buffer<std::uint64_t> counts(allocator_);
    counts.resize(4, 0);
    collective_.each_local([&](PartId p) {
        if (again[p].size() != tetrahedra_[p].size() || again[p].owned() != tetrahedra_[p].owned())
            fail(MGDT_ERR_CHECK_FAILED, "the tetrahedra are not those that were numbered");
        for (std::size_t i = 0; i < again[p].size(); ++i)
            if (again[p].number(i) != tetrahedra_[p].number(i))
                fail(MGDT_ERR_CHECK_FAILED, "tetrahedron %zu has number %lld and should have %lld",
                     i, static_cast<long long>(tetrahedra_[p].number(i)),
                     static_cast<long long>(again[p].number(i)));
        counts[0] += parts_[p].own_count();
        counts[1] += count_edges(parts_[p], allocator_);
        counts[2] += count_hull_facets(parts_[p], tetrahedra_[p], allocator_);
        counts[3] += tetrahedra_[p].owned();
    });
    collective_.sum(counts);
    // Each tetrahedron has four facets; two share each but those of the hull.
    const std::uint64_t facets = (4 * counts[3] + counts[2]) / 2;
    if (counts[3] > 0 && counts[0] + facets != counts[1] + counts[3] + 1)
        fail(MGDT_ERR_CHECK_FAILED,
             "%llu vertices, %llu edges, %llu facets and %llu tetrahedra are not those of a ball",
             static_cast<unsigned long long>(counts[0]), static_cast<unsigned long long>(counts[1]),
             static_cast<unsigned long long>(facets), static_cast<unsigned long long>(counts[3]));
}

}  // namespace mgdt
