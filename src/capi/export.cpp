// SPDX-License-Identifier: MIT
#include "query/export.hpp"

#include "capi/counts.hpp"
#include "capi/handle.hpp"

using namespace mgdt;

namespace {

// Elements that a thread pays for.
constexpr std::size_t min_items_per_thread = 262144;

// How many elements an export writes, and the bound that their values, counted from 0, are below.
struct Extent {
    std::int64_t count, end;
};

// One export: `extent` measures it, `body` writes it.
template <class Int, class Measure, class Body>
mgdt_status run_export(const mgdt_triangulation* t, bool numbers, std::int64_t capacity, Int* v,
                       Measure extent, Body body, const char* name) {
    return guard(
        t,
        [&] {
            const auto [count, end] = extent(t->core);
            if (count > 0) require_pointer(v, "the output array");
            require_capacity(capacity, static_cast<std::size_t>(count), "the output array");
            require_range<Int>(static_cast<std::uint64_t>(end), t);
            if (count == 0) return;
            Team team(t->core.threads_for(static_cast<std::size_t>(count), min_items_per_thread));
            body(view_of(team, t, numbers));
        },
        name);
}

template <class Int>
mgdt_status tetrahedra(const mgdt_triangulation* t, int64_t capacity, Int* v, const char* name) {
    return run_export(
        t, true, capacity, v,
        [](const Triangulation& core) {
            return Extent{4 * tetrahedron_count(core), point_count(core)};
        },
        [&](const ExportView& view) { export_tetrahedra(view, v); }, name);
}

template <class Int>
mgdt_status neighbors(const mgdt_triangulation* t, int64_t capacity, Int* v, const char* name) {
    return run_export(
        t, true, capacity, v,
        [](const Triangulation& core) {
            return Extent{4 * tetrahedron_count(core), tetrahedron_count(core)};
        },
        [&](const ExportView& view) { export_neighbors(view, v); }, name);
}

template <class Int>
mgdt_status hull_facets(const mgdt_triangulation* t, int64_t capacity, Int* v, const char* name) {
    return run_export(
        t, false, capacity, v,
        [](const Triangulation& core) {
            return Extent{3 * hull_facet_count(core), point_count(core)};
        },
        [&](const ExportView& view) { export_hull_facets(view, v); }, name);
}

template <class Int>
mgdt_status edges(const mgdt_triangulation* t, int64_t capacity, Int* v, const char* name) {
    return run_export(
        t, false, capacity, v,
        [](const Triangulation& core) {
            return Extent{2 * edge_count(core), point_count(core)};
        },
        [&](const ExportView& view) { export_edges(view, v); }, name);
}

template <class Int>
mgdt_status point_map(const mgdt_triangulation* t, int64_t capacity, Int* v, const char* name) {
    return run_export(
        t, false, capacity, v,
        [](const Triangulation& core) {
            return Extent{point_count(core), point_count(core)};
        },
        [&](const ExportView& view) { export_point_map(view, t->core.point_map(), v); }, name);
}

template <class Int>
mgdt_status vertex_tetrahedra(const mgdt_triangulation* t, int64_t offset_capacity, Int* offsets,
                              int64_t capacity, Int* list, const char* name) {
    return guard(
        t,
        [&] {
            const std::size_t points = t->core.point_map().size();
            const std::size_t count = static_cast<std::size_t>(4 * tetrahedron_count(t->core));
            require_pointer(offsets, "offsets");
            if (count > 0) require_pointer(list, "list");
            require_capacity(offset_capacity, points + 1, "offsets");
            require_capacity(capacity, count, "list");
            require_range<Int>(count + 1, t);  // the last offset is past the end
            Team team(t->core.threads_for(count, min_items_per_thread));
            export_vertex_tetrahedra(view_of(team, t, true), points, offsets, list);
        },
        name);
}

}  // namespace

#define MGDT_EXPORT(name)                                                                       \
    extern "C" mgdt_status mgdt_get_##name(const mgdt_triangulation* t, int64_t capacity,       \
                                           int64_t* v) {                                        \
        return name(t, capacity, v, __func__);                                                  \
    }                                                                                           \
    extern "C" mgdt_status mgdt_get_##name##_i32(const mgdt_triangulation* t, int64_t capacity, \
                                                 int32_t* v) {                                  \
        return name(t, capacity, v, __func__);                                                  \
    }
MGDT_EXPORT(tetrahedra)
MGDT_EXPORT(neighbors)
MGDT_EXPORT(hull_facets)
MGDT_EXPORT(edges)
MGDT_EXPORT(point_map)

extern "C" mgdt_status mgdt_get_vertex_tetrahedra(const mgdt_triangulation* t,
                                                  int64_t offset_capacity, int64_t* offsets,
                                                  int64_t capacity, int64_t* list) {
    return vertex_tetrahedra(t, offset_capacity, offsets, capacity, list, __func__);
}

extern "C" mgdt_status mgdt_get_vertex_tetrahedra_i32(const mgdt_triangulation* t,
                                                      int64_t offset_capacity, int32_t* offsets,
                                                      int64_t capacity, int32_t* list) {
    return vertex_tetrahedra(t, offset_capacity, offsets, capacity, list, __func__);
}
