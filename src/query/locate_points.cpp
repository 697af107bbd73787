// SPDX-License-Identifier: MIT
#include "query/locate_points.hpp"

#include "query/export.hpp"

namespace mgdt {

template <class Int>
void locate_points(const MeshView& view, const Locator& where, const PointSet& places,
                   const StageProgress& progress, Int* tetrahedra, double* weights) {
    const auto write = [&](std::size_t i, TetId found, TetId) {
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
        export_positions(view, view.mesh.tetrahedra[found], of_stored);
        for (int k = 0; k < 4; ++k) out[k] = stored[of_stored[k]];
    };
    locate_each(view, where, places, true, progress, [&](unsigned) { return write; });
}
template void locate_points(const MeshView&, const Locator&, const PointSet&, const StageProgress&,
                            std::int64_t*, double*);
template void locate_points(const MeshView&, const Locator&, const PointSet&, const StageProgress&,
                            std::int32_t*, double*);

template <class Int>
void nearest_vertices(const MeshView& view, const Locator& where, const PointSet& places,
                      const StageProgress& progress, Int* vertices) {
    const auto write = [&](std::size_t i, TetId, TetId near) {
        const VertexId found = where.nearest_vertex(places.axis[0] + 3 * i, near, view.allocator);
        vertices[i] = static_cast<Int>(
            (found == infinite_vertex ? -1 : std::int64_t{view.mesh.vertices[found].index}) +
            view.base);
    };
    locate_each(view, where, places, false, progress, [&](unsigned) { return write; });
}
template void nearest_vertices(const MeshView&, const Locator&, const PointSet&,
                               const StageProgress&, std::int64_t*);
template void nearest_vertices(const MeshView&, const Locator&, const PointSet&,
                               const StageProgress&, std::int32_t*);

}  // namespace mgdt
