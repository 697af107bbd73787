// SPDX-License-Identifier: MIT
// The functions of a mesh.
#include "capi/arrays.hpp"
#include "capi/measure.hpp"
#include "capi/mesh_handle.hpp"
#include "capi/options.hpp"
#include "capi/statistics.hpp"
#include "domain/mesh_check.hpp"
#include "domain/mesh_measures.hpp"
#include "parallel/thread_count.hpp"

using namespace mgdt;

namespace {

namespace of_mesh {

using Object = Result<DomainMesh>;

constexpr IntegerStatistic<Object> statistics[] = {
    {MGDT_MESH_STAT_POINTS, [](const Object& m) { return m.value.points.size() / 3; }},
    {MGDT_MESH_STAT_STEINER_POINTS,
     [](const Object& m) { return m.value.steiner_parameters.size(); }},
    {MGDT_MESH_STAT_TETRAHEDRA, [](const Object& m) { return m.value.tetrahedron_count(); }},
    {MGDT_MESH_STAT_REGIONS, [](const Object& m) { return m.value.region_markers.size(); }},
    {MGDT_MESH_STAT_FACES, [](const Object& m) { return m.value.face_facets.size(); }},
    {MGDT_MESH_STAT_EDGES, [](const Object& m) { return m.value.edge_segments.size(); }},
    {MGDT_MESH_STAT_MEMORY_BYTES, [](const Object& m) { return m.allocator().bytes(); }},
    {MGDT_MESH_STAT_IS_ROUNDED,
     [](const Object& m) { return std::size_t{m.value.is_rounded ? 1u : 0u}; }},
    {MGDT_MESH_STAT_GRID_BITS,
     [](const Object& m) { return static_cast<std::size_t>(m.value.grid.bits()); }},
    {MGDT_MESH_STAT_UNUSED_POINTS, [](const Object& m) { return m.value.unused_points.size(); }},
    {MGDT_MESH_STAT_UNUSED_FACES, [](const Object& m) { return m.value.unused_faces.size(); }},
    {MGDT_MESH_STAT_UNUSED_REGIONS, [](const Object& m) { return m.value.unused_regions.size(); }},
    {MGDT_MESH_STAT_UNUSED_HOLES, [](const Object& m) { return m.value.unused_holes.size(); }},
    {MGDT_MESH_STAT_PLANAR_FACETS, [](const Object& m) { return m.value.planar_facets; }},
    {MGDT_MESH_STAT_MISSING_FACETS, [](const Object& m) { return m.value.facet_counts.missing; }},
    {MGDT_MESH_STAT_CAVITIES, [](const Object& m) { return m.value.facet_counts.cavities; }},
    {MGDT_MESH_STAT_LARGEST_CAVITY,
     [](const Object& m) { return m.value.facet_counts.largest_cavity; }},
};

using M = DomainMesh;
constexpr auto arrays = std::make_tuple(
    array<Element::number>(MGDT_MESH_ARRAY_POINT_ORIGINS, 1, &M::point_origins),
    array<Element::number>(MGDT_MESH_ARRAY_TETRAHEDRA, 4, &M::tetrahedra),
    array<Element::number>(MGDT_MESH_ARRAY_NEIGHBORS, 4, &M::neighbors),
    array<Element::number>(MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS, 1, &M::regions),
    array<Element::integer>(MGDT_MESH_ARRAY_REGION_MARKERS, 1, &M::region_markers),
    array<Element::number>(MGDT_MESH_ARRAY_FACES, 3, &M::faces),
    array<Element::number>(MGDT_MESH_ARRAY_FACE_TETRAHEDRA, 2, &M::face_tetrahedra),
    array<Element::number>(MGDT_MESH_ARRAY_FACE_FACETS, 1, &M::face_facets),
    array<Element::integer>(MGDT_MESH_ARRAY_FACE_MARKERS, 1, &M::face_markers),
    array<Element::number>(MGDT_MESH_ARRAY_EDGES, 2, &M::edges),
    array<Element::number>(MGDT_MESH_ARRAY_EDGE_SEGMENTS, 1, &M::edge_segments),
    array<Element::integer>(MGDT_MESH_ARRAY_EDGE_MARKERS, 1, &M::edge_markers),
    array<Element::number>(MGDT_MESH_ARRAY_STEINER_EDGES, 2, &M::steiner_edges),
    array<Element::real>(MGDT_MESH_ARRAY_POINTS, 3, &M::points),
    array<Element::real>(MGDT_MESH_ARRAY_STEINER_PARAMETERS, 1, &M::steiner_parameters));

}  // namespace of_mesh
template <class Value>
mgdt_status get(const mgdt_mesh* m, std::int32_t key, std::int64_t capacity, Value* values,
                const char* name) {
    return guard(
        m,
        [&] {
            get_array(of_mesh::arrays, m->object.value, key, m->object.settings().index_base,
                      capacity, values, no_requirement);
        },
        name);
}

}  // namespace

extern "C" void mgdt_mesh_destroy(mgdt_mesh* m) {
    destroy_handle(m);
}

extern "C" mgdt_status mgdt_mesh_set_option(mgdt_mesh* m, int32_t option, int64_t value) {
    return set_option(m, option, value);
}

extern "C" mgdt_status mgdt_mesh_get_option(const mgdt_mesh* m, int32_t option, int64_t* value) {
    return get_option(m, option, value);
}

extern "C" mgdt_status mgdt_mesh_set_progress(mgdt_mesh* m, mgdt_progress_fn fn, void* user) {
    return set_progress(m, fn, user);
}

extern "C" mgdt_status mgdt_mesh_get_progress(const mgdt_mesh* m, mgdt_progress_fn* fn,
                                              void** user) {
    return get_progress(m, fn, user);
}

extern "C" mgdt_status mgdt_mesh_cancel(mgdt_mesh* m) {
    return cancel(m);
}

extern "C" mgdt_status mgdt_mesh_get_stat(const mgdt_mesh* m, int32_t key, int64_t* value) {
    return get_stat(m, m ? &m->object : nullptr, of_mesh::statistics, key, value);
}

extern "C" mgdt_status mgdt_mesh_array_info(int32_t array, int32_t* columns, int32_t* is_double) {
    return array_info(of_mesh::arrays, array, columns, is_double);
}

extern "C" mgdt_status mgdt_mesh_get_size(const mgdt_mesh* m, int32_t array, int64_t* size) {
    return guard(m, [&] {
        require_pointer(size, "size");
        *size = static_cast<std::int64_t>(
            size_of(of_mesh::arrays, m->object.value, array, no_requirement));
    });
}

extern "C" mgdt_status mgdt_mesh_get_array(const mgdt_mesh* m, int32_t array, int64_t capacity,
                                           int64_t* values) {
    return get(m, array, capacity, values, __func__);
}

extern "C" mgdt_status mgdt_mesh_get_array_i32(const mgdt_mesh* m, int32_t array, int64_t capacity,
                                               int32_t* values) {
    return get(m, array, capacity, values, __func__);
}

extern "C" mgdt_status mgdt_mesh_get_doubles(const mgdt_mesh* m, int32_t array, int64_t capacity,
                                             double* values) {
    return get(m, array, capacity, values, __func__);
}

extern "C" mgdt_status mgdt_mesh_get_tetrahedron_measures(const mgdt_mesh* m, int32_t measure,
                                                          int64_t capacity, double* x) {
    return guard_long(m, [&](StageProgress& progress) {
        const TetrahedronMeasure of = tetrahedron_measure_of(measure);
        const std::size_t count = m->object.value.tetrahedron_count();
        require_capacity(capacity, count, "x");
        if (count == 0) return;
        require_pointer(x, "x");
        Team team(thread_count(m->object.settings()));
        measure_tetrahedra(m->object.value, of, team, m->object.allocator(), progress, x);
    });
}

extern "C" mgdt_status mgdt_mesh_check(const mgdt_mesh* m) {
    return guard_long(m, [&](StageProgress& progress) {
        const Result<DomainMesh>& mesh = m->object;
        check_mesh(mesh.value, mesh.settings().index_base, mesh.allocator(), progress);
    });
}

extern "C" mgdt_status mgdt_mesh_get_error(const mgdt_mesh* m, int64_t capacity, char* buffer) {
    return get_message(m, capacity, buffer);
}
