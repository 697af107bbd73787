// SPDX-License-Identifier: MIT
// Removal, motion and renumbering of points.
#include "capi/counts.hpp"
#include "capi/triangulation_handle.hpp"

using namespace mgdt;

namespace {

// Converts the caller's indices to indices from 0. Each index is checked before it is converted to
// 32 bits; the function refuses an index that no point has.
template <class Int>
void read_points(const Triangulation& core, std::size_t n, const Int* points,
                 Buffer<std::uint32_t>& list) {
    const auto given = static_cast<std::uint64_t>(core.point_map().size());
    if (n > given)
        fail(MGDT_ERR_INVALID_ARGUMENT, "%zu indices, where there are %llu points", n,
             static_cast<unsigned long long>(given));
    list.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
        const std::int64_t i = points[k];
        const std::uint64_t from_zero =
            static_cast<std::uint64_t>(i) - static_cast<std::uint64_t>(core.settings().index_base);
        if (from_zero >= given)
            fail(MGDT_ERR_INVALID_ARGUMENT,
                 "there is no point %lld: %llu were given, counted from %d",
                 static_cast<long long>(i), static_cast<unsigned long long>(given),
                 static_cast<int>(core.settings().index_base));
        list[k] = static_cast<std::uint32_t>(from_zero);
    }
}

template <class Int>
mgdt_status remove(mgdt_triangulation* t, int64_t n, const Int* points, const char* name) {
    return guard(
        t,
        [&] {
            const std::size_t count = require_count(n);
            if (count == 0) return;
            require_pointer(points, "points");
            Buffer<std::uint32_t> list(t->object.allocator());
            read_points(t->object, count, points, list);
            t->object.remove(list);
        },
        name);
}

// Moves all points that are in the triangulation.
void move_all(Triangulation& core, std::size_t count, const double* xyz) {
    const Buffer<VertexId>& map = core.point_map();
    if (count != map.size())
        fail(MGDT_ERR_INVALID_ARGUMENT, "%zu places for %zu points", count, map.size());
    Buffer<std::uint32_t> list(core.allocator());
    Buffer<double> places(core.allocator());
    list.reserve(count);
    places.reserve(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        if (map[i] == infinite_vertex) continue;
        list.push_back(static_cast<std::uint32_t>(i));
        for (std::size_t k = 0; k < 3; ++k) places.push_back(xyz[3 * i + k]);
    }
    core.move(list, places.data());
}

template <class Int>
mgdt_status move(mgdt_triangulation* t, int64_t n, const Int* points, const double* xyz,
                 const char* name) {
    return guard(
        t,
        [&] {
            const std::size_t count = require_count(n);
            if (count == 0) return;
            require_pointer(xyz, "xyz");
            if (!points) return move_all(t->object, count, xyz);
            Buffer<std::uint32_t> list(t->object.allocator());
            read_points(t->object, count, points, list);
            t->object.move(list, xyz);
        },
        name);
}

template <class Int>
mgdt_status renumber(mgdt_triangulation* t, int64_t capacity, Int* new_index, const char* name) {
    return guard(
        t,
        [&] {
            const Buffer<VertexId>& map = t->object.point_map();
            if (!map.empty()) require_pointer(new_index, "new_index");
            require_capacity(capacity, map.size(), "new_index");
            const Statistics& now = t->object.statistics();
            require_range<Int>(now.points_inserted + now.duplicates, t);
            const std::int64_t base = t->object.settings().index_base;
            std::int64_t next = base;
            for (std::size_t i = 0; i < map.size(); ++i)
                new_index[i] = static_cast<Int>(map[i] == infinite_vertex ? base - 1 : next++);
            t->object.forget_absent_points();
        },
        name);
}

}  // namespace

extern "C" mgdt_status mgdt_remove_points(mgdt_triangulation* t, int64_t n, const int64_t* points) {
    return remove(t, n, points, __func__);
}

extern "C" mgdt_status mgdt_remove_points_i32(mgdt_triangulation* t, int64_t n,
                                              const int32_t* points) {
    return remove(t, n, points, __func__);
}

extern "C" mgdt_status mgdt_move_points(mgdt_triangulation* t, int64_t n, const int64_t* points,
                                        const double* xyz) {
    return move(t, n, points, xyz, __func__);
}

extern "C" mgdt_status mgdt_move_points_i32(mgdt_triangulation* t, int64_t n, const int32_t* points,
                                            const double* xyz) {
    return move(t, n, points, xyz, __func__);
}

extern "C" mgdt_status mgdt_renumber_points(mgdt_triangulation* t, int64_t capacity,
                                            int64_t* new_index) {
    return renumber(t, capacity, new_index, __func__);
}

extern "C" mgdt_status mgdt_renumber_points_i32(mgdt_triangulation* t, int64_t capacity,
                                                int32_t* new_index) {
    return renumber(t, capacity, new_index, __func__);
}
