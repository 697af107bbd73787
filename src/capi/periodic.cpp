// SPDX-License-Identifier: MIT
// Creation, options and points of a periodic box, and the calls that make its triangulation.
#include <algorithm>
#include <cmath>

#include "capi/entry_points.hpp"
#include "capi/periodic_handle.hpp"
#include "core/point_scan.hpp"
#include "periodic/periodic_check.hpp"

using namespace mgdt;

namespace {

long long shown(const Periodic& p, std::uint64_t number) {
    return static_cast<long long>(number) + p.settings().index_base;
}

void set_vectors(Periodic& p, std::int32_t dimensions, const double* vectors) {
    if (dimensions < 1 || dimensions > 3)
        fail(MGDT_ERR_INVALID_ARGUMENT, "a box has one to three vectors, not %d",
             static_cast<int>(dimensions));
    require_pointer(vectors, "vectors");
    for (std::int32_t i = 0; i < 3 * dimensions; ++i)
        if (!std::isfinite(vectors[i]))
            fail(MGDT_ERR_NOT_FINITE, "coordinate %c of vector %d of the box is not finite",
                 "xyz"[i % 3], static_cast<int>(i / 3 + p.settings().index_base));
    p.set_vectors(static_cast<unsigned>(dimensions), vectors);
}

void insert(Periodic& p, std::int64_t n, const double* xyz) {
    const std::size_t count = require_count(n);
    if (count > 0) require_pointer(xyz, "xyz");
    p.require_room(count);  // before coordinates are read that may not be there
    for (std::size_t i = 0; i < 3 * count; ++i)
        require_finite(xyz[i], i % 3, shown(p, p.point_count() + i / 3));
    p.insert(count, xyz);
}

void require_each_once(const Buffer<std::uint32_t>& points, std::int64_t base,
                       Allocator& allocator) {
    Buffer<std::uint32_t> sorted(allocator);
    sorted.resize(points.size());
    std::copy(points.begin(), points.end(), sorted.begin());
    std::sort(sorted.begin(), sorted.end());
    const std::uint32_t* const twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
        fail(MGDT_ERR_INVALID_ARGUMENT, "point %lld is to be moved twice",
             static_cast<long long>(*twice) + base);
}

template <class Int>
void move(Periodic& p, std::int64_t n, const Int* points, const double* xyz) {
    const std::size_t count = require_count(n);
    if (!points && count != p.point_count())
        fail(MGDT_ERR_INVALID_ARGUMENT, "%zu places are given for all points, which are %zu", count,
             p.point_count());
    if (count > 0) require_pointer(xyz, "xyz");
    const std::int64_t base = p.settings().index_base;
    Buffer<std::uint32_t> numbers(p.allocator());
    numbers.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t index = points ? points[i] : static_cast<std::int64_t>(i) + base;
        if (index < base || static_cast<std::uint64_t>(index - base) >= p.point_count())
            fail(MGDT_ERR_INVALID_ARGUMENT, "there is no point %lld; there are %zu",
                 static_cast<long long>(index), p.point_count());
        numbers[i] = static_cast<std::uint32_t>(index - base);
        for (std::size_t c = 0; c < 3; ++c) require_finite(xyz[3 * i + c], c, index);
    }
    if (points) require_each_once(numbers, base, p.allocator());
    p.move(count, numbers.begin(), xyz);
}

}  // namespace

MGDT_LIFE(periodic)
MGDT_OPTIONS(periodic, {})
MGDT_PROGRESS(periodic)
MGDT_MESSAGE(periodic)

extern "C" mgdt_status mgdt_periodic_clear(mgdt_periodic* p) {
    return guard(p, [&] { p->object.clear(); });
}

extern "C" mgdt_status mgdt_periodic_set_vectors(mgdt_periodic* p, int32_t dimensions,
                                                 const double* vectors) {
    return guard(p, [&] { set_vectors(p->object, dimensions, vectors); });
}

extern "C" mgdt_status mgdt_periodic_set_merge_distance(mgdt_periodic* p, double distance) {
    return guard(p, [&] {
        if (!(distance >= 0) || !std::isfinite(distance))
            fail(MGDT_ERR_INVALID_ARGUMENT, "the distance is %g; it must be finite and at least 0",
                 distance);
        p->object.settings().merge_distance = distance;
    });
}

extern "C" mgdt_status mgdt_periodic_get_merge_distance(const mgdt_periodic* p, double* distance) {
    return guard_short(p, [&] {
        require_pointer(distance, "distance");
        *distance = p->object.settings().merge_distance;
    });
}

extern "C" mgdt_status mgdt_periodic_insert_points(mgdt_periodic* p, int64_t n, const double* xyz) {
    return guard(p, [&] { insert(p->object, n, xyz); });
}

extern "C" mgdt_status mgdt_periodic_move_points(mgdt_periodic* p, int64_t n, const int64_t* points,
                                                 const double* xyz) {
    return guard(p, [&] { move(p->object, n, points, xyz); });
}

extern "C" mgdt_status mgdt_periodic_move_points_i32(mgdt_periodic* p, int64_t n,
                                                     const int32_t* points, const double* xyz) {
    return guard(p, [&] { move(p->object, n, points, xyz); });
}

extern "C" mgdt_status mgdt_periodic_build(mgdt_periodic* p) {
    return guard(p, [&] { p->object.build(); });
}

extern "C" mgdt_status mgdt_periodic_check(const mgdt_periodic* p) {
    return guard_long(p, [&](StageProgress& progress) {
        require_triangulation(p->object);
        check_periodic(p->object, progress);
    });
}
