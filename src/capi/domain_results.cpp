// SPDX-License-Identifier: MIT
// The numbers and arrays of a domain.
#include "capi/domain_handle.hpp"

using namespace mgdt;

namespace {

std::size_t statistic(const Domain& d, std::int32_t key) {
    const DomainMesh& m = d.mesh();
    switch (key) {
        case MGDT_DOMAIN_GIVEN_POINTS:
            return d.input().point_count();
        case MGDT_DOMAIN_GIVEN_FACETS:
            return d.input().facet_count();
        case MGDT_DOMAIN_GIVEN_SEGMENTS:
            return d.input().segment_count();
        case MGDT_DOMAIN_MEMORY_BYTES:
            return d.allocator().bytes();
        case MGDT_DOMAIN_STEINER_POINTS:
            return m.steiner_parameters.size();
        case MGDT_DOMAIN_TETRAHEDRA:
            return m.tetrahedron_count();
        case MGDT_DOMAIN_REGIONS:
            return m.region_markers.size();
        case MGDT_DOMAIN_FACES:
            return m.face_facets.size();
        case MGDT_DOMAIN_IS_ROUNDED:
            return m.is_rounded ? 1 : 0;
        case MGDT_DOMAIN_GRID_BITS:
            return static_cast<std::size_t>(d.mesh().grid_bits);
        case MGDT_DOMAIN_OPEN_EDGES:
            return d.open_edges().size();
        case MGDT_DOMAIN_UNUSED_POINTS:
            return m.unused_points.size();
        case MGDT_DOMAIN_UNUSED_FACES:
            return m.unused_faces.size();
        case MGDT_DOMAIN_UNUSED_REGIONS:
            return m.unused_regions.size();
        case MGDT_DOMAIN_UNUSED_HOLES:
            return m.unused_holes.size();
        case MGDT_DOMAIN_PLANAR_FACETS:
            return d.planar_facets();
        case MGDT_DOMAIN_MISSING_FACETS:
            return d.facet_counts().missing;
        case MGDT_DOMAIN_CAVITIES:
            return d.facet_counts().cavities;
        case MGDT_DOMAIN_LARGEST_CAVITY:
            return d.facet_counts().largest_cavity;
        default:
            fail(MGDT_ERR_UNKNOWN_KEY, "there is no number %d", static_cast<int>(key));
    }
}

bool has_doubles(std::int32_t array) {
    return array == MGDT_DOMAIN_ARRAY_POINTS || array == MGDT_DOMAIN_ARRAY_STEINER_PARAMETERS;
}

// Calls f with an array of doubles.
template <class F>
auto with_doubles(const DomainMesh& m, std::int32_t array, F f) {
    return f(array == MGDT_DOMAIN_ARRAY_POINTS ? m.points : m.steiner_parameters);
}

// Calls indices(array) for an array of numbers that start at the index base, and markers(array) for
// one of markers.
template <class Indices, class Markers>
auto with_integers(const DomainMesh& m, std::int32_t array, Indices indices, Markers markers) {
    switch (array) {
        case MGDT_DOMAIN_ARRAY_TETRAHEDRA:
            return indices(m.tetrahedra);
        case MGDT_DOMAIN_ARRAY_NEIGHBORS:
            return indices(m.neighbors);
        case MGDT_DOMAIN_ARRAY_REGIONS:
            return indices(m.regions);
        case MGDT_DOMAIN_ARRAY_REGION_MARKERS:
            return markers(m.region_markers);
        case MGDT_DOMAIN_ARRAY_FACES:
            return indices(m.faces);
        case MGDT_DOMAIN_ARRAY_FACE_TETRAHEDRA:
            return indices(m.face_tetrahedra);
        case MGDT_DOMAIN_ARRAY_FACE_FACETS:
            return indices(m.face_facets);
        case MGDT_DOMAIN_ARRAY_FACE_MARKERS:
            return markers(m.face_markers);
        case MGDT_DOMAIN_ARRAY_SEGMENTS:
            return indices(m.segments);
        case MGDT_DOMAIN_ARRAY_SEGMENT_SOURCES:
            return indices(m.segment_sources);
        case MGDT_DOMAIN_ARRAY_SEGMENT_MARKERS:
            return markers(m.segment_markers);
        case MGDT_DOMAIN_ARRAY_STEINER_EDGES:
            return indices(m.steiner_edges);
        default:
            fail(MGDT_ERR_UNKNOWN_KEY, "there is no array %d", static_cast<int>(array));
    }
}

std::size_t size_of(const Domain& d, std::int32_t array) {
    if (array == MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS) return 4 * d.offences().size();
    if (array == MGDT_DOMAIN_ARRAY_OPEN_EDGES) return 3 * d.open_edges().size();
    const auto size = [](const auto& of) { return of.size(); };
    const std::size_t n = has_doubles(array) ? with_doubles(d.mesh(), array, size)
                                             : with_integers(d.mesh(), array, size, size);
    require_mesh(d);
    return n;
}

template <class Int>
void write(const Domain& d, std::int32_t array, Int* out) {
    const std::int64_t base = d.settings().index_base;
    if (array == MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS) {
        for (const Offence& o : d.offences())
            for (const Offence::Item& item : {o.first, o.second}) {
                *out++ = static_cast<Int>(item.kind);
                *out++ = static_cast<Int>(std::int64_t{item.index} + base);
            }
        return;
    }
    if (array == MGDT_DOMAIN_ARRAY_OPEN_EDGES) {
        for (const OpenEdge& e : d.open_edges())
            for (const std::uint32_t i : {e.ends[0], e.ends[1], e.facet})
                *out++ = static_cast<Int>(std::int64_t{i} + base);
        return;
    }
    with_integers(
        d.mesh(), array,
        [&](const Buffer<std::uint32_t>& from) {
            for (const std::uint32_t i : from)
                *out++ = static_cast<Int>((i == DomainMesh::none ? -1 : std::int64_t{i}) + base);
        },
        [&](const Buffer<std::int32_t>& from) {
            for (const std::int32_t marker : from) *out++ = marker;
        });
}

template <class Int>
void get_integers(const Domain& d, std::int32_t array, std::int64_t capacity, Int* values) {
    const std::size_t size = size_of(d, array);
    if (has_doubles(array))
        fail(MGDT_ERR_UNKNOWN_KEY, "array %d has doubles, not integers", static_cast<int>(array));
    const DomainMesh& m = d.mesh();
    const std::uint64_t most = std::max<std::uint64_t>(
        {m.tetrahedron_count(), m.points.size() / 3, d.input().point_count(),
         d.input().facet_count(), d.input().segment_count()});
    if (most + static_cast<std::uint64_t>(d.settings().index_base) >
        static_cast<std::uint64_t>(std::numeric_limits<Int>::max()))
        fail(MGDT_ERR_INDEX_RANGE, "numbers up to %llu do not fit a 32-bit integer",
             static_cast<unsigned long long>(most));
    require_capacity(capacity, size, "values");
    if (size == 0) return;
    require_pointer(values, "values");
    write(d, array, values);
}

}  // namespace

extern "C" mgdt_status mgdt_domain_get_stat(const mgdt_domain* d, int32_t key, int64_t* value) {
    return guard(d, [&] {
        require_pointer(value, "value");
        *value = static_cast<std::int64_t>(statistic(d->object, key));
    });
}

extern "C" mgdt_status mgdt_domain_get_size(const mgdt_domain* d, int32_t array, int64_t* size) {
    return guard(d, [&] {
        require_pointer(size, "size");
        *size = static_cast<std::int64_t>(size_of(d->object, array));
    });
}

extern "C" mgdt_status mgdt_domain_get_array(const mgdt_domain* d, int32_t array, int64_t capacity,
                                             int64_t* values) {
    return guard(d, [&] { get_integers(d->object, array, capacity, values); });
}

extern "C" mgdt_status mgdt_domain_get_array_i32(const mgdt_domain* d, int32_t array,
                                                 int64_t capacity, int32_t* values) {
    return guard(d, [&] { get_integers(d->object, array, capacity, values); });
}

extern "C" mgdt_status mgdt_domain_get_doubles(const mgdt_domain* d, int32_t array,
                                               int64_t capacity, double* values) {
    return guard(d, [&] {
        const std::size_t size = size_of(d->object, array);
        if (!has_doubles(array))
            fail(MGDT_ERR_UNKNOWN_KEY, "array %d has integers, not doubles",
                 static_cast<int>(array));
        require_capacity(capacity, size, "values");
        if (size == 0) return;
        require_pointer(values, "values");
        with_doubles(d->object.mesh(), array, [&](const Buffer<double>& from) {
            std::copy_n(from.begin(), from.size(), values);
        });
    });
}
