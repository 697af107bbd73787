// SPDX-License-Identifier: MIT
#include "query/locate_points.hpp"

#include <algorithm>

#include "order/curve_sort.hpp"

namespace mgdt {
namespace {

// Calls found(i, tetrahedron, near) for each place i, see Locator::locate_sequence().
template <class Found>
void locate_each(const ExportView& view, const Locator& where, const PointSet& places,
                 bool may_end_outside, Found found) {
    const double* const xyz = places.axis[0];
    if (places.size == 1) {
        TetId near = no_tetrahedron;
        const TetId found_in = where.locate(xyz, near, may_end_outside);
        found(0, found_in, near);
        return;
    }
    // Along a curve each is near the one before. Blocks bound the memory that sorting takes.
    constexpr std::size_t most = std::size_t{1} << 20;
    for (std::size_t begin = 0; begin < places.size; begin += most) {
        PointSet block = places;
        block.size = std::min(most, places.size - begin);
        for (const double*& axis : block.axis) axis += 3 * begin;
        const CurveOrder order = sort_along_curve(view.team, block, view.allocator);
        const auto place = [&](std::size_t k) { return begin + order.index(k); };
        view.team.split(
            block.size, places_per_thread, [&](std::size_t first, std::size_t last, unsigned) {
                where.locate_sequence(
                    last - first, may_end_outside,
                    [&](std::size_t k) { return xyz + 3 * place(first + k); },
                    [&](std::size_t k, TetId t, TetId near) { found(place(first + k), t, near); });
            });
    }
}

}  // namespace

template <class Int>
void locate_points(const ExportView& view, const Locator& where, const PointSet& places,
                   Int* tetrahedra, double* weights) {
    locate_each(view, where, places, true, [&](std::size_t i, TetId found, TetId) {
        const bool is_inside = found != no_tetrahedron;
        const std::int32_t number = is_inside ? view.numbering->number(found) : -1;
        tetrahedra[i] = static_cast<Int>(number) + static_cast<Int>(view.base);
        if (!weights) return;
        double* const out = weights + 4 * i;
        std::fill(out, out + 4, 0.0);
        if (!is_inside) return;
        double stored[4];
        unsigned of_stored[4];
        where.weights(found, places.axis[0] + 3 * i, stored);
        export_places(view, view.mesh.tetrahedra[found], of_stored);
        for (int k = 0; k < 4; ++k) out[k] = stored[of_stored[k]];
    });
}
template void locate_points(const ExportView&, const Locator&, const PointSet&, std::int64_t*,
                            double*);
template void locate_points(const ExportView&, const Locator&, const PointSet&, std::int32_t*,
                            double*);

template <class Int>
void nearest_vertices(const ExportView& view, const Locator& where, const PointSet& places,
                      Int* vertices) {
    locate_each(view, where, places, false, [&](std::size_t i, TetId, TetId near) {
        const VertexId found = where.nearest_vertex(places.axis[0] + 3 * i, near, view.allocator);
        vertices[i] = static_cast<Int>(
            (found == infinite_vertex ? -1 : std::int64_t{view.mesh.vertices[found].index}) +
            view.base);
    });
}
template void nearest_vertices(const ExportView&, const Locator&, const PointSet&, std::int64_t*);
template void nearest_vertices(const ExportView&, const Locator&, const PointSet&, std::int32_t*);

}  // namespace mgdt
