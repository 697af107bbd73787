// SPDX-License-Identifier: MIT
// The functions of a mesh.
#include "capi/entry_points.hpp"
#include "capi/measure.hpp"
#include "capi/mesh_handle.hpp"
#include "parallel/thread_count.hpp"
#include "solid/mesh_check.hpp"
#include "solid/mesh_measures.hpp"

using namespace mgdt;

namespace {

namespace of_mesh {

using Object = Result<SolidMesh>;

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
    {MGDT_MESH_STAT_MISSING_FACETS, [](const Object& m) { return m.value.missing_facets; }},
    {MGDT_MESH_STAT_CAVITIES, [](const Object& m) { return m.value.cavities; }},
    {MGDT_MESH_STAT_LARGEST_CAVITY, [](const Object& m) { return m.value.largest_cavity; }},
};

using M = SolidMesh;
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

// See entry_points.hpp.
struct MeshResults {
    static constexpr const auto& statistics = of_mesh::statistics;
    static constexpr const auto& arrays = of_mesh::arrays;
    static const SolidMesh& of(const Result<SolidMesh>& object) { return object.value; }
    static void require(const SolidMesh&) {}
};

}  // namespace

MGDT_OPTIONS(mesh, {})
MGDT_PROGRESS(mesh)
MGDT_RESULTS(mesh, MeshResults)
MGDT_DOUBLES(mesh, MeshResults)
MGDT_MESSAGE(mesh)

extern "C" void mgdt_mesh_destroy(mgdt_mesh* m) {
    destroy_handle(m);
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
        const Result<SolidMesh>& mesh = m->object;
        check_mesh(mesh.value, mesh.settings().index_base, mesh.allocator(), progress);
    });
}
