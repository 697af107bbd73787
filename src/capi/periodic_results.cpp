// SPDX-License-Identifier: MIT
// The numbers and arrays of a periodic box, and its Voronoi cells.
#include "capi/entry_points.hpp"
#include "capi/measure.hpp"
#include "capi/periodic_handle.hpp"
#include "capi/voronoi_handle.hpp"
#include "periodic/periodic_cells.hpp"
#include "periodic/periodic_diagram.hpp"

using namespace mgdt;

namespace {

namespace of_box {

constexpr IntegerStatistic<Periodic> statistics[] = {
    {MGDT_PERIODIC_STAT_POINTS, [](const Periodic& p) { return p.point_count(); }},
    {MGDT_PERIODIC_STAT_VERTICES, [](const Periodic& p) { return p.vertex_count(); }},
    {MGDT_PERIODIC_STAT_TETRAHEDRA,
     [](const Periodic& p) { return p.has_triangulation() ? p.tetrahedra().size() : 0; }},
    {MGDT_PERIODIC_STAT_EDGES,
     [](const Periodic& p) { return p.has_triangulation() ? p.neighbors().images.size() / 2 : 0; }},
    {MGDT_PERIODIC_STAT_DIMENSIONS,
     [](const Periodic& p) { return static_cast<std::size_t>(p.dimensions()); }},
    {MGDT_PERIODIC_STAT_MEMORY_BYTES, [](const Periodic& p) { return p.bytes(); }},
    {MGDT_PERIODIC_STAT_IMAGES,
     [](const Periodic& p) {
         return p.has_triangulation() ? p.halo().point_count() - p.halo().own_count() : 0;
     }},
    {MGDT_PERIODIC_STAT_ROUNDS,
     [](const Periodic& p) {
         return p.has_triangulation() ? static_cast<std::size_t>(p.halo().rounds()) : 0;
     }},
};

using Record = PeriodicTetrahedra::Record;

// Calls f for the three integers of the shift of an image, seen from a point of the box.
template <class F>
void each_of_shift(const Periodic& p, std::uint32_t point, const Image& image, const F& f) {
    for (const std::int64_t k : p.shift_from(point, image)) f(k);
}

std::uint32_t count_of(const Periodic& p) {
    return static_cast<std::uint32_t>(p.point_count());
}

auto point_map(const Periodic& p) {
    return Computed(p.point_count(), [&p](const auto& f) {
        for (std::uint32_t i = 0; i < count_of(p); ++i) f(p.vertex_of(i));
    });
}

auto point_shifts(const Periodic& p) {
    return Computed(3 * p.point_count(), [&p](const auto& f) {
        for (std::uint32_t i = 0; i < count_of(p); ++i)
            each_of_shift(p, i, {p.vertex_of(i), {}}, f);
    });
}

auto tetrahedra(const Periodic& p) {
    return Computed(4 * p.tetrahedra().size(), [&p](const auto& f) {
        for (const Record& record : p.tetrahedra().records())
            for (const Image& corner : record.tetrahedron.corners) f(corner.point);
    });
}

auto tetrahedron_shifts(const Periodic& p) {
    return Computed(12 * p.tetrahedra().size(), [&p](const auto& f) {
        for (const Record& record : p.tetrahedra().records())
            for (const Image& corner : record.tetrahedron.corners)
                each_of_shift(p, record.tetrahedron.corners[0].point, corner, f);
    });
}

auto neighbors(const Periodic& p) {
    return Computed(4 * p.tetrahedra().size(), [&p](const auto& f) {
        for (const Record& record : p.tetrahedra().records())
            for (const PeriodicTetrahedra::Neighbor& n : record.neighbors) f(n.number);
    });
}

auto neighbor_shifts(const Periodic& p) {
    return Computed(12 * p.tetrahedra().size(), [&p](const auto& f) {
        const Buffer<Record>& records = p.tetrahedra().records();
        const bool needs_point = !p.has_one_wrap();
        for (const Record& record : records) {
            const std::uint32_t first = record.tetrahedron.corners[0].point;
            for (const PeriodicTetrahedra::Neighbor& n : record.neighbors) {
                if (n.number == no_index) {
                    for (unsigned c = 0; c < 3; ++c) f(std::int64_t{0});
                    continue;
                }
                const std::uint32_t other =
                    needs_point ? records[n.number].tetrahedron.corners[0].point : first;
                each_of_shift(p, first, {other, {n.of[0], n.of[1], n.of[2], 0}}, f);
            }
        }
    });
}

const auto& vertex_neighbor_offsets(const Periodic& p) {
    return p.neighbors().begin;
}

auto vertex_neighbors(const Periodic& p) {
    return Computed(p.neighbors().images.size(), [&p](const auto& f) {
        for (const Image& image : p.neighbors().images) f(image.point);
    });
}

auto vertex_neighbor_shifts(const Periodic& p) {
    return Computed(3 * p.neighbors().images.size(), [&p](const auto& f) {
        const VertexNeighbors& all = p.neighbors();
        for (std::uint32_t i = 0; i < count_of(p); ++i)
            for (std::uint64_t k = all.begin[i]; k < all.begin[i + 1]; ++k)
                each_of_shift(p, i, all.images[k], f);
    });
}

auto points(const Periodic& p) {
    return Filled(3 * p.point_count(), [&p](double* x) {
        for (std::uint32_t i = 0; i < count_of(p); ++i) p.rounded(i, x + 3 * std::size_t{i});
    });
}

auto vectors(const Periodic& p) {
    return Filled(3 * std::size_t{p.dimensions()}, [&p](double* x) {
        for (std::uint32_t i = 0; i < p.dimensions(); ++i)
            p.rounded_vector(i, x + 3 * std::size_t{i});
    });
}

constexpr auto arrays = std::make_tuple(
    array<Element::number>(MGDT_PERIODIC_ARRAY_POINT_MAP, 1, point_map),
    array<Element::integer>(MGDT_PERIODIC_ARRAY_POINT_SHIFTS, 3, point_shifts),
    array<Element::number>(MGDT_PERIODIC_ARRAY_TETRAHEDRA, 4, tetrahedra),
    array<Element::integer>(MGDT_PERIODIC_ARRAY_TETRAHEDRON_SHIFTS, 12, tetrahedron_shifts),
    array<Element::number>(MGDT_PERIODIC_ARRAY_NEIGHBORS, 4, neighbors),
    array<Element::integer>(MGDT_PERIODIC_ARRAY_NEIGHBOR_SHIFTS, 12, neighbor_shifts),
    array<Element::number>(MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_OFFSETS, 1, vertex_neighbor_offsets),
    array<Element::number>(MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS, 1, vertex_neighbors),
    array<Element::integer>(MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_SHIFTS, 3, vertex_neighbor_shifts),
    array<Element::real>(MGDT_PERIODIC_ARRAY_POINTS, 3, points),
    array<Element::real>(MGDT_PERIODIC_ARRAY_VECTORS, 3, vectors));

}  // namespace of_box

// See entry_points.hpp.
struct BoxResults {
    static constexpr const auto& statistics = of_box::statistics;
    static constexpr const auto& arrays = of_box::arrays;
    static const Periodic& of(const Periodic& object) { return object; }
    static void require(const Periodic& box) { require_triangulation(box); }
};

void require_cells(const Periodic& p) {
    require_triangulation(p);
    if (p.point_count() > 0 && p.halo().triangulation().dimension() < 3)
        fail(MGDT_ERR_INVALID_ARGUMENT, "there are no cells: the points do not span space");
}

void get_measures(const Periodic& p, std::int32_t measure, std::int64_t capacity,
                  StageProgress& progress, double* x) {
    const Measure m = measure_of(measure);
    require_cells(p);
    const std::size_t size = width_of(m) * p.point_count();
    require_capacity(capacity, size, "x");
    if (size == 0) return;
    require_pointer(x, "x");
    export_periodic_measures(p, m, progress, x);
}

}  // namespace

MGDT_RESULTS(periodic, BoxResults)
MGDT_DOUBLES(periodic, BoxResults)

extern "C" mgdt_status mgdt_periodic_get_cell_measures(const mgdt_periodic* p, int32_t measure,
                                                       int64_t capacity, double* x) {
    return guard_long(p, [&](StageProgress& progress) {
        get_measures(p->object, measure, capacity, progress, x);
    });
}

extern "C" mgdt_status mgdt_periodic_create_voronoi(const mgdt_periodic* p, mgdt_voronoi** out) {
    if (!out) return MGDT_ERR_NULL_POINTER;
    *out = nullptr;
    return guard_long(p, [&](StageProgress& progress) {
        require_cells(p->object);
        *out = new_result<mgdt_voronoi>(p->object, [&](Result<VoronoiDiagram>& made) {
            if (p->object.point_count() == 0) return make_empty(0, made.value);
            build_periodic_diagram(p->object, progress, made.value);
        });
    });
}
