// SPDX-License-Identifier: MIT
// Arrays of a triangulation: tetrahedra, neighbours, hull facets, edges, circumcentres, measures.
#include "query/export.hpp"

#include <algorithm>

#include "capi/counts.hpp"
#include "capi/measure.hpp"
#include "capi/triangulation_handle.hpp"

using namespace mgdt;

namespace {

// The least number of elements per thread.
constexpr std::size_t min_items_per_thread = 262144;

// The number of elements that an export writes, and an upper bound on their values, counted from 0.
struct Extent {
    std::int64_t count, end;
};

// Runs an export: `extent` returns its Extent, `body` writes the output.
template <class Int, class Measure, class Body>
mgdt_status run_export(const mgdt_triangulation* t, bool numbers, std::int64_t capacity, Int* v,
                       Measure extent, Body body, const char* name) {
    return guard(
        t,
        [&] {
            const auto [count, end] = extent(t->object);
            if (count > 0) require_pointer(v, "the output array");
            require_capacity(capacity, static_cast<std::size_t>(count), "the output array");
            require_range<Int>(static_cast<std::uint64_t>(end), t);
            if (count == 0) return;
            Team team(t->object.threads_for(static_cast<std::size_t>(count), min_items_per_thread));
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
        [&](const MeshView& view) { export_tetrahedra(view, v); }, name);
}

template <class Int>
mgdt_status neighbors(const mgdt_triangulation* t, int64_t capacity, Int* v, const char* name) {
    return run_export(
        t, true, capacity, v,
        [](const Triangulation& core) {
            return Extent{4 * tetrahedron_count(core), tetrahedron_count(core)};
        },
        [&](const MeshView& view) { export_neighbors(view, v); }, name);
}

template <class Int>
mgdt_status hull_facets(const mgdt_triangulation* t, int64_t capacity, Int* v, const char* name) {
    return run_export(
        t, false, capacity, v,
        [](const Triangulation& core) {
            return Extent{3 * hull_facet_count(core), point_count(core)};
        },
        [&](const MeshView& view) { export_hull_facets(view, v); }, name);
}

template <class Int>
mgdt_status edges(const mgdt_triangulation* t, int64_t capacity, Int* v, const char* name) {
    return run_export(
        t, false, capacity, v,
        [](const Triangulation& core) {
            return Extent{2 * edge_count(core), point_count(core)};
        },
        [&](const MeshView& view) { export_edges(view, v); }, name);
}

template <class Int>
mgdt_status point_map(const mgdt_triangulation* t, int64_t capacity, Int* v, const char* name) {
    return run_export(
        t, false, capacity, v,
        [](const Triangulation& core) {
            return Extent{point_count(core), point_count(core)};
        },
        [&](const MeshView& view) { export_point_map(view, t->object.point_map(), v); }, name);
}

// The shape of a compressed list by points.
struct ListShape {
    bool numbers;       // whether the list needs numbers of tetrahedra
    std::size_t count;  // the number of elements in the list
    std::size_t end;    // an upper bound on its elements, counted from 0
};

template <class Int, class Measure, class Body>
mgdt_status run_list_export(const mgdt_triangulation* t, std::int64_t offset_capacity, Int* offsets,
                            std::int64_t capacity, Int* list, Measure shape, Body body,
                            const char* name) {
    return guard(
        t,
        [&] {
            const std::size_t points = t->object.point_map().size();
            const auto [numbers, count, end] = shape(t->object);
            require_pointer(offsets, "offsets");
            if (count > 0) require_pointer(list, "list");
            require_capacity(offset_capacity, points + 1, "offsets");
            require_capacity(capacity, count, "list");
            // The last offset, which is `count`, has to fit too.
            require_range<Int>(std::max<std::uint64_t>(count + 1, end), t);
            Team team(t->object.threads_for(count, min_items_per_thread));
            body(view_of(team, t, numbers), points);
        },
        name);
}

template <class Int>
mgdt_status vertex_tetrahedra(const mgdt_triangulation* t, int64_t offset_capacity, Int* offsets,
                              int64_t capacity, Int* list, const char* name) {
    return run_list_export(
        t, offset_capacity, offsets, capacity, list,
        [](const Triangulation& core) {
            return ListShape{true, static_cast<std::size_t>(4 * tetrahedron_count(core)), 0};
        },
        [&](const MeshView& view, std::size_t points) {
            export_vertex_tetrahedra(view, points, offsets, list);
        },
        name);
}

template <class Int>
mgdt_status vertex_neighbors(const mgdt_triangulation* t, int64_t offset_capacity, Int* offsets,
                             int64_t capacity, Int* list, const char* name) {
    return run_list_export(
        t, offset_capacity, offsets, capacity, list,
        [](const Triangulation& core) {
            return ListShape{false, static_cast<std::size_t>(2 * edge_count(core)),
                             core.point_map().size()};
        },
        [&](const MeshView& view, std::size_t points) {
            export_vertex_neighbors(view, points, offsets, list);
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

#define MGDT_LIST_EXPORT(name)                                                                   \
    extern "C" mgdt_status mgdt_get_##name(const mgdt_triangulation* t, int64_t offset_capacity, \
                                           int64_t* offsets, int64_t capacity, int64_t* list) {  \
        return name(t, offset_capacity, offsets, capacity, list, __func__);                      \
    }                                                                                            \
    extern "C" mgdt_status mgdt_get_##name##_i32(const mgdt_triangulation* t,                    \
                                                 int64_t offset_capacity, int32_t* offsets,      \
                                                 int64_t capacity, int32_t* list) {              \
        return name(t, offset_capacity, offsets, capacity, list, __func__);                      \
    }
MGDT_LIST_EXPORT(vertex_tetrahedra)
MGDT_LIST_EXPORT(vertex_neighbors)

extern "C" mgdt_status mgdt_get_tetrahedron_measures(const mgdt_triangulation* t, int32_t measure,
                                                     int64_t capacity, double* x) {
    return guard_long(t, [&](StageProgress& progress) {
        const TetrahedronMeasure m = tetrahedron_measure_of(measure);
        const auto count = static_cast<std::size_t>(tetrahedron_count(t->object));
        if (count > 0) require_pointer(x, "the output array");
        require_capacity(capacity, count, "the output array");
        if (count == 0) return;
        constexpr std::size_t tetrahedra_per_thread = 4096;
        Team team(t->object.threads_for(count, tetrahedra_per_thread));
        export_tetrahedron_measures(view_of(team, t, true), m, progress, x);
    });
}

extern "C" mgdt_status mgdt_get_circumcenters(const mgdt_triangulation* t, int64_t capacity,
                                              double* xyz, double* radius2) {
    return guard_long(t, [&](StageProgress& progress) {
        const auto count = static_cast<std::size_t>(tetrahedron_count(t->object));
        if (count > 0) require_pointer(xyz, "xyz");
        if (capacity < 0 || static_cast<std::uint64_t>(capacity) < count)
            fail(capacity < 0 ? MGDT_ERR_INVALID_ARGUMENT : MGDT_ERR_BUFFER_TOO_SMALL,
                 "the arrays have room for %lld tetrahedra; %zu are needed",
                 static_cast<long long>(capacity), count);
        if (count == 0) return;
        constexpr std::size_t tetrahedra_per_thread = 4096;
        Team team(t->object.threads_for(count, tetrahedra_per_thread));
        export_circumcenters(view_of(team, t, true), progress, xyz, radius2);
    });
}
