// SPDX-License-Identifier: MIT
// The options and results of a mesh, its measures and its check.
#include "capi/entry_points.hpp"
#include "capi/measure.hpp"
#include "capi/mesh_handle.hpp"
#include "parallel/thread_count.hpp"
#include "solid/mesh_check.hpp"
#include "solid/mesh_measures.hpp"

using namespace mgdt;

namespace {

namespace of_mesh {

using Object = MeshObject;

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
    {MGDT_MESH_STAT_IS_DELAUNAY,
     [](const Object& m) { return std::size_t{m.value.is_delaunay ? 1u : 0u}; }},
    {MGDT_MESH_STAT_IS_OF_DOMAIN,
     [](const Object& m) { return std::size_t{m.value.is_of_domain ? 1u : 0u}; }},
    {MGDT_MESH_STAT_KEEPS_BOUNDARY,
     [](const Object& m) { return std::size_t{m.value.keeps_facets ? 1u : 0u}; }},
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
    {MGDT_MESH_STAT_BELOW_GOAL, [](const Object& m) { return m.value.report.below_goal; }},
    {MGDT_MESH_STAT_PASSES, [](const Object& m) { return m.value.report.passes; }},
    {MGDT_MESH_STAT_MOVED_POINTS, [](const Object& m) { return m.value.report.moved_points; }},
    {MGDT_MESH_STAT_REMOVED_POINTS, [](const Object& m) { return m.value.report.removed_points; }},
    {MGDT_MESH_STAT_INSERTED_POINTS, [](const Object& m) { return m.value.refinement.inserted; }},
    {MGDT_MESH_STAT_REFUSED, [](const Object& m) { return m.value.refinement.refused; }},
};

// Pairs of numbers, before and after the last improvement: of(summary, i) for i below n. None if
// there was no improvement.
template <class Of>
auto before_and_after(const MeshState& m, std::size_t n, const Of& of) {
    const ImprovementReport& report = m.report;
    return computed_each(report.is_made ? 2 * n : 0, [&report, of](std::size_t i) {
        return of(i % 2 == 0 ? report.before : report.after, i / 2);
    });
}

auto reasons(const MeshState& m) {
    return computed_each(m.report.reasons.size(), [&m](std::size_t t) {
        return static_cast<std::int32_t>(m.report.reasons[t]);
    });
}
auto refusals(const MeshState& m) {
    return computed_each(m.refinement.refusals.size(), [&m](std::size_t t) {
        return static_cast<std::int32_t>(m.refinement.refusals[t]);
    });
}
auto sizes(const MeshState& m) {
    return computed_each(m.refinement.sizes.size(),
                         [&m](std::size_t v) { return m.refinement.sizes[v]; });
}
// Rows of a summary.
constexpr std::size_t n_shapes = 3;
double shape(const ShapeSummary& s, std::size_t i) {
    return i == 0 ? s.least_angle : i == 1 ? s.largest_angle : s.mean_volume_length;
}
std::int64_t angles_in(const ShapeSummary& s, std::size_t bin) {
    return static_cast<std::int64_t>(s.angles[bin]);
}
std::int64_t below(const ShapeSummary& s, std::size_t bound) {
    return static_cast<std::int64_t>(s.tetrahedra_below[bound]);
}

auto angle_histogram(const MeshState& m) {
    return before_and_after(m, ShapeSummary::angle_bins, angles_in);
}
auto tetrahedra_below(const MeshState& m) {
    return before_and_after(m, ShapeSummary::bounds, below);
}
auto shapes(const MeshState& m) {
    return before_and_after(m, n_shapes, shape);
}

using M = MeshState;
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
    array<Element::integer>(MGDT_MESH_ARRAY_REASONS, 1, reasons),
    array<Element::integer>(MGDT_MESH_ARRAY_ANGLE_HISTOGRAM, 2, angle_histogram),
    array<Element::integer>(MGDT_MESH_ARRAY_TETRAHEDRA_BELOW, 2, tetrahedra_below),
    array<Element::integer>(MGDT_MESH_ARRAY_REFUSALS, 1, refusals),
    array<Element::real>(MGDT_MESH_ARRAY_POINTS, 3, &M::points),
    array<Element::real>(MGDT_MESH_ARRAY_STEINER_PARAMETERS, 1, &M::steiner_parameters),
    array<Element::real>(MGDT_MESH_ARRAY_SHAPES, 2, shapes),
    array<Element::real>(MGDT_MESH_ARRAY_SIZES, 1, sizes));

}  // namespace of_mesh

const OwnOptions<MeshSettings> mesh_options = {
    {MGDT_MESH_OPTION_GOAL, &MeshSettings::goal, MeshSettings::largest_goal},
    {MGDT_MESH_OPTION_BOUNDARY, &MeshSettings::slides},
    {MGDT_MESH_OPTION_POINTS, &MeshSettings::points, MGDT_POINTS_REMOVE},
    {MGDT_MESH_OPTION_MEAN_PASSES, &MeshSettings::mean_passes, MeshSettings::largest_mean_passes},
    {MGDT_MESH_OPTION_MOST_PASSES, &MeshSettings::most_passes, MeshSettings::largest_most_passes},
    {MGDT_MESH_OPTION_MOST_POINTS, &MeshSettings::most_points,
     std::numeric_limits<std::int32_t>::max()},
    {MGDT_MESH_OPTION_SIZES_OF_SURFACE, &MeshSettings::sizes_of_surface}};

constexpr DoubleOption<MeshSettings> mesh_double_options[] = {
    {MGDT_MESH_OPTION_SIZE, &MeshSettings::size, MeshSettings::bound},
    {MGDT_MESH_OPTION_GRADATION, &MeshSettings::gradation, MeshSettings::gradation_bound},
    {MGDT_MESH_OPTION_RADIUS_EDGE, &MeshSettings::radius_edge, MeshSettings::bound},
    {MGDT_MESH_OPTION_VOLUME, &MeshSettings::volume, MeshSettings::bound}};

// See entry_points.hpp.
struct MeshResults {
    static constexpr const auto& statistics = of_mesh::statistics;
    static constexpr const auto& arrays = of_mesh::arrays;
    static const MeshState& of(const MeshObject& object) { return object.value; }
    static void require(const MeshState&) {}
};

}  // namespace

MGDT_LIFE(mesh)
MGDT_OPTIONS(mesh, mesh_options)
MGDT_DOUBLE_OPTIONS(mesh, mesh_double_options)
MGDT_PROGRESS(mesh)
MGDT_RESULTS(mesh, MeshResults)
MGDT_DOUBLES(mesh, MeshResults)
MGDT_MESSAGE(mesh)

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

extern "C" mgdt_status mgdt_mesh_get_shape_summary(const mgdt_mesh* m, double* shapes,
                                                   int64_t* angles, int64_t* tetrahedra_below) {
    return guard_long(m, [&](StageProgress& progress) {
        Team team(thread_count(m->object.settings()));
        const ShapeSummary found =
            summarize_shapes(m->object.value, team, m->object.allocator(), progress);
        if (shapes)
            for (std::size_t i = 0; i < of_mesh::n_shapes; ++i)
                shapes[i] = of_mesh::shape(found, i);
        if (angles)
            for (std::size_t i = 0; i < ShapeSummary::angle_bins; ++i)
                angles[i] = of_mesh::angles_in(found, i);
        if (tetrahedra_below)
            for (std::size_t i = 0; i < ShapeSummary::bounds; ++i)
                tetrahedra_below[i] = of_mesh::below(found, i);
    });
}

extern "C" mgdt_status mgdt_mesh_check(const mgdt_mesh* m) {
    return guard_long(m, [&](StageProgress& progress) {
        const MeshObject& mesh = m->object;
        check_mesh(mesh.value, mesh.settings().index_base, mesh.allocator(), progress);
    });
}
