// SPDX-License-Identifier: MIT
// Creation of a Voronoi diagram, and its arrays.
#include "capi/cell_view.hpp"
#include "capi/entry_points.hpp"
#include "capi/voronoi_handle.hpp"

using namespace mgdt;

namespace {

void build(const mgdt_triangulation* t, std::int64_t n_planes, const double* planes,
           StageProgress& progress, VoronoiDiagram& diagram) {
    const std::size_t n = require_planes(n_planes, planes);
    const auto points = static_cast<std::size_t>(point_count(t->object));
    if (t->object.vertex_count() > 0) {
        with_cell_view(t, diagram.areas.allocator(), n, planes,
                       [&](const MeshView& view, const Region& region, std::size_t far) {
                           build_voronoi(view, region, points, far, progress, diagram);
                       });
    } else {
        make_empty(points, diagram);
    }
    diagram.planes.resize(4 * n);
    std::copy_n(planes, 4 * n, diagram.planes.begin());
}

namespace of_diagram {

// The faces of cells: f(face, side) is called for each face of each cell, where `side`, 0 or 1, is
// that of the cell. The same point may be on both sides, as different images: the first side is the
// cell's then.
template <class F>
void each_face_of_cell(const VoronoiDiagram& d, const F& f) {
    for (std::size_t cell = 0; cell < d.cell_count(); ++cell)
        for (std::uint64_t i = d.cell_begin[cell]; i < d.cell_begin[cell + 1]; ++i)
            f(std::size_t{d.cell_faces[i]},
              d.face_sides[2 * std::size_t{d.cell_faces[i]}] == cell ? 0u : 1u);
}

auto cell_neighbors(const VoronoiDiagram& d) {
    return Computed(d.cell_faces.size(), [&d](const auto& f) {
        each_face_of_cell(
            d, [&](std::size_t face, unsigned side) { f(d.face_sides[2 * face + 1 - side]); });
    });
}

auto cell_neighbor_shifts(const VoronoiDiagram& d) {
    return Computed(d.face_shifts.empty() ? 0 : 3 * d.cell_faces.size(), [&d](const auto& f) {
        each_face_of_cell(d, [&](std::size_t face, unsigned side) {
            for (unsigned c = 0; c < 3; ++c) {
                const std::int64_t k = d.face_shifts[3 * face + c];
                f(side == 0 ? k : -k);
            }
        });
    });
}

auto cell_face_areas(const VoronoiDiagram& d) {
    return Computed(d.cell_faces.size(), [&d](const auto& f) {
        for (const std::uint32_t face : d.cell_faces) f(d.areas[face]);
    });
}

auto cell_neighbor_distances(const VoronoiDiagram& d) {
    return Filled(d.cell_faces.size(), [&d](double* out) { write_distances(d, out); });
}

auto face_normals(const VoronoiDiagram& d) {
    return Filled(d.face_centroids.size(), [&d](double* out) { write_normals(d, out); });
}

using Object = Result<VoronoiDiagram>;

constexpr IntegerStatistic<Object> statistics[] = {
    {MGDT_VORONOI_STAT_VERTICES, [](const Object& v) { return v.value.vertices.size() / 3; }},
    {MGDT_VORONOI_STAT_RAYS, [](const Object& v) { return v.value.ray_vertices.size(); }},
    {MGDT_VORONOI_STAT_FACES, [](const Object& v) { return v.value.face_count(); }},
    {MGDT_VORONOI_STAT_POINTS, [](const Object& v) { return v.value.cell_count(); }},
    {MGDT_VORONOI_STAT_MEMORY_BYTES, [](const Object& v) { return v.allocator().bytes(); }},
};

using D = VoronoiDiagram;
static_assert(D::ray == D::plane);  // the flag of Element::flagged
constexpr auto arrays = std::make_tuple(
    array<Element::number>(MGDT_VORONOI_ARRAY_FACE_OFFSETS, 1, &D::face_begin),
    array<Element::flagged>(MGDT_VORONOI_ARRAY_FACE_CORNERS, 1, &D::face_corners),
    array<Element::flagged>(MGDT_VORONOI_ARRAY_FACE_SIDES, 2, &D::face_sides),
    array<Element::integer>(MGDT_VORONOI_ARRAY_FACE_SHIFTS, 3, &D::face_shifts),
    array<Element::number>(MGDT_VORONOI_ARRAY_RAY_VERTICES, 1, &D::ray_vertices),
    array<Element::number>(MGDT_VORONOI_ARRAY_CELL_OFFSETS, 1, &D::cell_begin),
    array<Element::number>(MGDT_VORONOI_ARRAY_CELL_FACES, 1, &D::cell_faces),
    array<Element::integer>(MGDT_VORONOI_ARRAY_CELL_BOUNDED, 1, &D::is_bounded),
    array<Element::flagged>(MGDT_VORONOI_ARRAY_CELL_NEIGHBORS, 1, cell_neighbors),
    array<Element::integer>(MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_SHIFTS, 3, cell_neighbor_shifts),
    array<Element::real>(MGDT_VORONOI_ARRAY_VERTICES, 3, &D::vertices),
    array<Element::real>(MGDT_VORONOI_ARRAY_RAY_DIRECTIONS, 3, &D::ray_directions),
    array<Element::real>(MGDT_VORONOI_ARRAY_FACE_AREAS, 1, &D::areas),
    array<Element::real>(MGDT_VORONOI_ARRAY_FACE_NORMALS, 3, face_normals),
    array<Element::real>(MGDT_VORONOI_ARRAY_FACE_CENTROIDS, 3, &D::face_centroids),
    array<Element::real>(MGDT_VORONOI_ARRAY_CELL_VOLUMES, 1, &D::volumes),
    array<Element::real>(MGDT_VORONOI_ARRAY_CELL_CENTROIDS, 3, &D::cell_centroids),
    array<Element::real>(MGDT_VORONOI_ARRAY_CELL_FACE_AREAS, 1, cell_face_areas),
    array<Element::real>(MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES, 1, cell_neighbor_distances));

}  // namespace of_diagram

// See entry_points.hpp.
struct DiagramResults {
    static constexpr const auto& statistics = of_diagram::statistics;
    static constexpr const auto& arrays = of_diagram::arrays;
    static const VoronoiDiagram& of(const Result<VoronoiDiagram>& object) { return object.value; }
    static void require(const VoronoiDiagram&) {}
};

}  // namespace

MGDT_RESULTS(voronoi, DiagramResults)
MGDT_DOUBLES(voronoi, DiagramResults)
MGDT_MESSAGE(voronoi)

extern "C" mgdt_status mgdt_voronoi_create(const mgdt_triangulation* t, int64_t n_planes,
                                           const double* planes, mgdt_voronoi** out) {
    if (!out) return MGDT_ERR_NULL_POINTER;
    *out = nullptr;
    return guard_long(
        t,
        [&](StageProgress& progress) {
            *out = new_result<mgdt_voronoi>(t->object, [&](Result<VoronoiDiagram>& made) {
                build(t, n_planes, planes, progress, made.value);
            });
        },
        Watched::always);
}

extern "C" void mgdt_voronoi_destroy(mgdt_voronoi* v) {
    destroy_handle(v);
}

extern "C" mgdt_status mgdt_voronoi_drop_small_faces(mgdt_voronoi* v, double least_area,
                                                     double least_share) {
    return guard(v, [&] {
        if (!(least_area >= 0))
            fail(MGDT_ERR_INVALID_ARGUMENT, "the least area is %g; it has to be at least 0",
                 least_area);
        if (!(least_share >= 0 && least_share < 1))
            fail(MGDT_ERR_INVALID_ARGUMENT,
                 "the least share of the area is %g; it has to be at least 0 and less than 1",
                 least_share);
        drop_small_faces(v->object.value, least_area, least_share);
    });
}
