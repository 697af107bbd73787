// SPDX-License-Identifier: MIT
//
// Checks that the triangulation of each part is Delaunay, that parts agree on the tetrahedra that
// they share, and that all tetrahedra together form a ball (docs/theory.md, "Parts").
#include "query/check.hpp"

#include <algorithm>
#include <functional>

#include "parts/parts.hpp"

namespace mgdt {
namespace {

// Counts the edges whose lexicographically lesser end is one of the part's own points.
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

void Parts::check(std::int32_t level, StageProgress& progress) {
    const StageProgress of_all = progress.within(0, 0.8);
    collective_.each_local([&](PartId p) {
        StageProgress of_part = of_all.within_items(p, p + 1, collective_.local_parts());
        const Triangulation& t = parts_[p].triangulation();
        Team team(t.threads_for(t.mesh().tetrahedra.size(), 65536));
        check_triangulation(team, t.check_input(), t.allocator(), level, 0, of_part);
    });
    // Finds the tetrahedra again. Fails if a part lacks a tetrahedron that two parts must have.
    Objects<PartTetrahedra> again(allocator_, parts_.size(), std::ref(allocator_));
    Buffer<std::int64_t> first(allocator_);
    find_tetrahedra(collective_, homes_, parts_, again, first, allocator_);
    Buffer<std::uint64_t> counts(allocator_);
    counts.resize(4, 0);
    collective_.each_local([&](PartId p) {
        if (!again[p].is_like(tetrahedra_[p]))
            fail(MGDT_ERR_CHECK_FAILED, "the tetrahedra are not those that were numbered");
        for (std::size_t i = 0; i < parts_[p].own_count(); ++i)
            if (homes_.of(parts_[p].points()[i].x) != collective_.first_local() + p)
                fail(MGDT_ERR_CHECK_FAILED, "own point %zu is not at home here", i);
        counts[0] += parts_[p].own_count();
        counts[1] += count_edges(parts_[p], allocator_);
        counts[2] += count_hull_facets(parts_[p], again[p], allocator_);
        counts[3] += again[p].owned();
    });
    collective_.sum(counts);
    collective_.name_no_part();
    if (first.size() != first_tetrahedron_.size() ||
        !std::equal(first.begin(), first.end(), first_tetrahedron_.begin()))
        fail(MGDT_ERR_CHECK_FAILED, "the tetrahedra are not as many as were numbered");
    // Each tetrahedron has four facets, and two tetrahedra share each facet that is not on the
    // hull.
    if ((4 * counts[3] + counts[2]) % 2 != 0) fail(MGDT_ERR_CHECK_FAILED, "a facet has one side");
    const std::uint64_t facets = (4 * counts[3] + counts[2]) / 2;
    if (counts[3] > 0 && counts[0] + facets != counts[1] + counts[3] + 1)
        fail(MGDT_ERR_CHECK_FAILED,
             "%llu vertices, %llu edges, %llu facets and %llu tetrahedra are not those of a ball",
             static_cast<unsigned long long>(counts[0]), static_cast<unsigned long long>(counts[1]),
             static_cast<unsigned long long>(facets), static_cast<unsigned long long>(counts[3]));
}

}  // namespace mgdt
