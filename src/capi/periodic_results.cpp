// SPDX-License-Identifier: MIT
// The numbers and arrays of a periodic box, and its Voronoi cells.
#include <algorithm>
#include <iterator>

#include "capi/measure.hpp"
#include "capi/periodic_handle.hpp"
#include "capi/voronoi_handle.hpp"
#include "periodic/periodic_cells.hpp"
#include "periodic/periodic_diagram.hpp"

using namespace mgdt;

namespace {

std::size_t statistic(const Periodic& p, std::int32_t key) {
    switch (key) {
        case MGDT_PERIODIC_GIVEN_POINTS:
            return p.point_count();
        case MGDT_PERIODIC_MEMORY_BYTES:
            return p.bytes();
        case MGDT_PERIODIC_DIMENSIONS:
            return p.dimensions();
        case MGDT_PERIODIC_VERTICES:
            return p.vertex_count();
        case MGDT_PERIODIC_TETRAHEDRA:
            return p.has_triangulation() ? p.tetrahedra().size() : 0;
        case MGDT_PERIODIC_EDGES:
            return p.has_triangulation() ? p.neighbors().images.size() / 2 : 0;
        case MGDT_PERIODIC_IMAGES:
            return p.has_triangulation() ? p.halo().point_count() - p.halo().own_count() : 0;
        case MGDT_PERIODIC_ROUNDS:
            return p.has_triangulation() ? p.halo().rounds() : 0;
        default:
            fail(MGDT_ERR_UNKNOWN_KEY, "there is no number %d", static_cast<int>(key));
    }
}

bool is_array_of_doubles(std::int32_t array) {
    return array == MGDT_PERIODIC_ARRAY_POINTS || array == MGDT_PERIODIC_ARRAY_VECTORS;
}

constexpr std::int32_t arrays[] = {
    MGDT_PERIODIC_ARRAY_POINT_MAP,
    MGDT_PERIODIC_ARRAY_POINT_OFFSETS,
    MGDT_PERIODIC_ARRAY_TETRAHEDRA,
    MGDT_PERIODIC_ARRAY_OFFSETS,
    MGDT_PERIODIC_ARRAY_NEIGHBORS,
    MGDT_PERIODIC_ARRAY_NEIGHBOR_OFFSETS,
    MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_STARTS,
    MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS,
    MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_OFFSETS,
    MGDT_PERIODIC_ARRAY_POINTS,
    MGDT_PERIODIC_ARRAY_VECTORS,
};

std::size_t size_of(const Periodic& p, std::int32_t array) {
    if (std::find(std::begin(arrays), std::end(arrays), array) == std::end(arrays))
        fail(MGDT_ERR_UNKNOWN_KEY, "there is no array %d", static_cast<int>(array));
    require_triangulation(p);
    const std::size_t points = p.point_count();
    switch (array) {
        case MGDT_PERIODIC_ARRAY_POINT_MAP:
            return points;
        case MGDT_PERIODIC_ARRAY_POINT_OFFSETS:
        case MGDT_PERIODIC_ARRAY_POINTS:
            return 3 * points;
        case MGDT_PERIODIC_ARRAY_TETRAHEDRA:
        case MGDT_PERIODIC_ARRAY_NEIGHBORS:
            return 4 * p.tetrahedra().size();
        case MGDT_PERIODIC_ARRAY_OFFSETS:
        case MGDT_PERIODIC_ARRAY_NEIGHBOR_OFFSETS:
            return 12 * p.tetrahedra().size();
        case MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_STARTS:
            return points + 1;
        case MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS:
            return p.neighbors().images.size();
        case MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_OFFSETS:
            return 3 * p.neighbors().images.size();
        default:
            return 3 * p.dimensions();  // MGDT_PERIODIC_ARRAY_VECTORS
    }
}

using Offset = std::array<std::int64_t, 3>;

// Calls index(i) for each element of an array of numbers that start at the index base, and
// offset(o) for each offset.
template <class Index, class AddOffset>
void each_integer(const Periodic& p, std::int32_t array, const Index& index,
                  const AddOffset& offset) {
    using Record = PeriodicTetrahedra::Record;
    // An image that is a corner or a neighbour, as seen from a point of the box.
    const auto seen_from = [&](std::uint32_t point, const Image& image) {
        offset(p.offset_from(point, image));
    };
    const auto points = static_cast<std::uint32_t>(p.point_count());
    switch (array) {
        case MGDT_PERIODIC_ARRAY_POINT_MAP:
            for (std::uint32_t i = 0; i < points; ++i) index(p.vertex_of(i));
            return;
        case MGDT_PERIODIC_ARRAY_POINT_OFFSETS:
            for (std::uint32_t i = 0; i < points; ++i) seen_from(i, {p.vertex_of(i), {}});
            return;
        case MGDT_PERIODIC_ARRAY_TETRAHEDRA:
            for (const Record& record : p.tetrahedra().records())
                for (const Image& corner : record.tetrahedron.corners) index(corner.point);
            return;
        case MGDT_PERIODIC_ARRAY_OFFSETS:
            for (const Record& record : p.tetrahedra().records())
                for (const Image& corner : record.tetrahedron.corners)
                    seen_from(record.tetrahedron.corners[0].point, corner);
            return;
        case MGDT_PERIODIC_ARRAY_NEIGHBORS:
            for (const Record& record : p.tetrahedra().records())
                for (const PeriodicTetrahedra::Neighbor& n : record.neighbors)
                    index(n.number == PeriodicTetrahedra::none ? -1 : std::int64_t{n.number});
            return;
        case MGDT_PERIODIC_ARRAY_NEIGHBOR_OFFSETS: {
            const Buffer<Record>& records = p.tetrahedra().records();
            const bool needs_point = !p.has_one_shift();
            for (const Record& record : records) {
                const std::uint32_t first = record.tetrahedron.corners[0].point;
                for (const PeriodicTetrahedra::Neighbor& n : record.neighbors) {
                    if (n.number == PeriodicTetrahedra::none)
                        offset({});
                    else
                        seen_from(
                            first,
                            {needs_point ? records[n.number].tetrahedron.corners[0].point : first,
                             {n.of[0], n.of[1], n.of[2], 0}});
                }
            }
            return;
        }
        case MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_STARTS:
            for (const std::uint64_t start : p.neighbors().begin)
                index(static_cast<std::int64_t>(start));
            return;
        case MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS:
            for (const Image& image : p.neighbors().images) index(image.point);
            return;
        default: {
            const VertexNeighbors& neighbors = p.neighbors();
            for (std::uint32_t i = 0; i < points; ++i)
                for (std::uint64_t k = neighbors.begin[i]; k < neighbors.begin[i + 1]; ++k)
                    seen_from(i, neighbors.images[k]);
        }
    }
}

template <class Int>
void get_integers(const Periodic& p, std::int32_t array, std::int64_t capacity, Int* values) {
    const std::size_t size = size_of(p, array);
    if (is_array_of_doubles(array))
        fail(MGDT_ERR_UNKNOWN_KEY, "array %d has doubles, not integers", static_cast<int>(array));
    require_capacity(capacity, size, "values");
    if (size == 0) return;
    require_pointer(values, "values");
    const std::int64_t base = p.settings().index_base;
    // Nothing is written unless all fits. The numbers in an array are those of points, or are at
    // most its size, or are positions in another array.
    const std::size_t positions =
        array == MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_STARTS ? p.neighbors().images.size() : 0;
    const auto largest_number = static_cast<double>(std::max({size, p.point_count(), positions}));
    if (sizeof(Int) < sizeof(std::int64_t) &&
        std::max(largest_number, p.largest_offset()) >= 0x1p31 - 2) {
        const auto require = [](std::int64_t x) {
            if (x < std::numeric_limits<Int>::min() || x > std::numeric_limits<Int>::max())
                fail(MGDT_ERR_INDEX_RANGE, "%lld does not fit a 32-bit integer",
                     static_cast<long long>(x));
        };
        each_integer(
            p, array, [&](std::int64_t i) { require(i + base); },
            [&](const Offset& of) {
                for (const std::int64_t x : of) require(x);
            });
    }
    each_integer(
        p, array, [&](std::int64_t i) { *values++ = static_cast<Int>(i + base); },
        [&](const Offset& of) {
            for (const std::int64_t x : of) *values++ = static_cast<Int>(x);
        });
}

void get_doubles(const Periodic& p, std::int32_t array, std::int64_t capacity, double* values) {
    const std::size_t size = size_of(p, array);
    if (!is_array_of_doubles(array))
        fail(MGDT_ERR_UNKNOWN_KEY, "array %d has integers, not doubles", static_cast<int>(array));
    require_capacity(capacity, size, "values");
    if (size == 0) return;
    require_pointer(values, "values");
    double x[3];
    for (std::uint32_t i = 0; i < size / 3; ++i) {
        if (array == MGDT_PERIODIC_ARRAY_POINTS)
            p.rounded(i, x);
        else
            p.rounded_vector(i, x);
        std::copy_n(x, 3, values + 3 * std::size_t{i});
    }
}

void require_cells(const Periodic& p) {
    require_triangulation(p);
    if (p.point_count() > 0 && p.halo().triangulation().dimension() < 3)
        fail(MGDT_ERR_INVALID_ARGUMENT, "there are no cells: the points do not span space");
}

void get_measures(const Periodic& p, std::int32_t measure, std::int64_t capacity, double* x) {
    const Measure m = measure_of(measure);
    require_cells(p);
    const std::size_t size = width_of(m) * p.point_count();
    require_capacity(capacity, size, "x");
    if (size == 0) return;
    require_pointer(x, "x");
    export_periodic_measures(p, m, x);
}

}  // namespace

extern "C" mgdt_status mgdt_periodic_get_stat(const mgdt_periodic* p, int32_t key, int64_t* value) {
    return guard(p, [&] {
        require_pointer(value, "value");
        *value = static_cast<std::int64_t>(statistic(p->box, key));
    });
}

extern "C" mgdt_status mgdt_periodic_get_size(const mgdt_periodic* p, int32_t array,
                                              int64_t* size) {
    return guard(p, [&] {
        require_pointer(size, "size");
        *size = static_cast<std::int64_t>(size_of(p->box, array));
    });
}

extern "C" mgdt_status mgdt_periodic_get_array(const mgdt_periodic* p, int32_t array,
                                               int64_t capacity, int64_t* values) {
    return guard(p, [&] { get_integers(p->box, array, capacity, values); });
}

extern "C" mgdt_status mgdt_periodic_get_array_i32(const mgdt_periodic* p, int32_t array,
                                                   int64_t capacity, int32_t* values) {
    return guard(p, [&] { get_integers(p->box, array, capacity, values); });
}

extern "C" mgdt_status mgdt_periodic_get_doubles(const mgdt_periodic* p, int32_t array,
                                                 int64_t capacity, double* values) {
    return guard(p, [&] { get_doubles(p->box, array, capacity, values); });
}

extern "C" mgdt_status mgdt_periodic_get_cell_measures(const mgdt_periodic* p, int32_t measure,
                                                       int64_t capacity, double* x) {
    return guard(p, [&] { get_measures(p->box, measure, capacity, x); });
}

extern "C" mgdt_status mgdt_periodic_create_voronoi(const mgdt_periodic* p, mgdt_voronoi** out) {
    if (!out) return MGDT_ERR_NULL_POINTER;
    *out = nullptr;
    return guard(p, [&] {
        require_cells(p->box);
        *out = make_voronoi(p->box.allocator(), p->box.settings().index_base,
                            [&](VoronoiDiagram& diagram) {
                                if (p->box.point_count() == 0) return make_empty(0, diagram);
                                const Periodic::Call call(p->box);
                                build_periodic_diagram(p->box, call.stop_request(), diagram);
                            });
    });
}
