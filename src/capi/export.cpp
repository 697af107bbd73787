// SPDX-License-Identifier: MIT
#include "query/export.hpp"

#include <limits>

#include "capi/handle.hpp"

using namespace mgdt;

namespace {

// Elements that a thread pays for.
constexpr std::size_t share = 262144;

// Refuses an export whose values, counted from 0, are below `end` but do not fit Int.
template <class Int>
void require_range(std::uint64_t end, const mgdt_triangulation* t) {
    if (end == 0) return;
    const std::uint64_t largest =
        end - 1 + static_cast<std::uint64_t>(t->core.settings().index_base);
    if (largest > static_cast<std::uint64_t>(std::numeric_limits<Int>::max()))
        fail(MGDT_ERR_INDEX_RANGE, "indices up to %llu do not fit a 32-bit integer",
             static_cast<unsigned long long>(largest));
}

// One export: `count` elements with values below `end`, written by `body`.
template <class Int, class Body>
mgdt_status run(const mgdt_triangulation* t, bool numbers, std::int64_t capacity, Int* v,
                int64_t count, int64_t end, Body body) noexcept {
    return guard(t, [&] {
        if (count > 0) require_pointer(v, "the output array");
        require_capacity(capacity, static_cast<std::size_t>(count), "the output array");
        require_range<Int>(static_cast<std::uint64_t>(end), t);
        if (count == 0) return;
        Team team(t->core.threads_for(static_cast<std::size_t>(count), share));
        body(view_of(team, t, numbers));
    });
}

template <class Int>
mgdt_status tetrahedra(const mgdt_triangulation* t, int64_t capacity, Int* v) {
    return run(t, true, capacity, v, 4 * mgdt_tetrahedron_count(t), mgdt_point_count(t),
               [&](const ExportView& view) { export_tetrahedra(view, v); });
}

template <class Int>
mgdt_status neighbors(const mgdt_triangulation* t, int64_t capacity, Int* v) {
    return run(t, true, capacity, v, 4 * mgdt_tetrahedron_count(t), mgdt_tetrahedron_count(t),
               [&](const ExportView& view) { export_neighbors(view, v); });
}

template <class Int>
mgdt_status hull_facets(const mgdt_triangulation* t, int64_t capacity, Int* v) {
    return run(t, false, capacity, v, 3 * mgdt_hull_facet_count(t), mgdt_point_count(t),
               [&](const ExportView& view) { export_hull_facets(view, v); });
}

template <class Int>
mgdt_status edges(const mgdt_triangulation* t, int64_t capacity, Int* v) {
    return run(t, false, capacity, v, 2 * mgdt_edge_count(t), mgdt_point_count(t),
               [&](const ExportView& view) { export_edges(view, v); });
}

template <class Int>
mgdt_status point_map(const mgdt_triangulation* t, int64_t capacity, Int* v) {
    return run(t, false, capacity, v, mgdt_point_count(t), mgdt_point_count(t),
               [&](const ExportView& view) { export_point_map(view, t->core.point_map(), v); });
}

template <class Int>
mgdt_status vertex_tetrahedra(const mgdt_triangulation* t, int64_t offset_capacity, Int* offsets,
                              int64_t capacity, Int* list) {
    return guard(t, [&] {
        const std::size_t points = t->core.point_map().size();
        const std::size_t count = static_cast<std::size_t>(mgdt_vertex_tetrahedra_count(t));
        require_pointer(offsets, "offsets");
        if (count > 0) require_pointer(list, "list");
        require_capacity(offset_capacity, points + 1, "offsets");
        require_capacity(capacity, count, "list");
        require_range<Int>(count + 1, t);  // the last offset is past the end
        Team team(t->core.threads_for(count, share));
        export_vertex_tetrahedra(view_of(team, t, true), points, offsets, list);
    });
}

}  // namespace

#define MGDT_EXPORT(name)                                                                       \
    extern "C" mgdt_status mgdt_get_##name(const mgdt_triangulation* t, int64_t capacity,       \
                                           int64_t* v) {                                        \
        return name(t, capacity, v);                                                            \
    }                                                                                           \
    extern "C" mgdt_status mgdt_get_##name##_i32(const mgdt_triangulation* t, int64_t capacity, \
                                                 int32_t* v) {                                  \
        return name(t, capacity, v);                                                            \
    }
MGDT_EXPORT(tetrahedra)
MGDT_EXPORT(neighbors)
MGDT_EXPORT(hull_facets)
MGDT_EXPORT(edges)
MGDT_EXPORT(point_map)

extern "C" mgdt_status mgdt_get_vertex_tetrahedra(const mgdt_triangulation* t,
                                                  int64_t offset_capacity, int64_t* offsets,
                                                  int64_t capacity, int64_t* list) {
    return vertex_tetrahedra(t, offset_capacity, offsets, capacity, list);
}

extern "C" mgdt_status mgdt_get_vertex_tetrahedra_i32(const mgdt_triangulation* t,
                                                      int64_t offset_capacity, int32_t* offsets,
                                                      int64_t capacity, int32_t* list) {
    return vertex_tetrahedra(t, offset_capacity, offsets, capacity, list);
}
