// SPDX-License-Identifier: MIT
// The Gabriel graph and the minimum spanning tree.
#include "query/graphs.hpp"

#include "capi/counts.hpp"
#include "capi/triangulation_handle.hpp"

using namespace mgdt;

namespace {

template <class Int>
void gabriel(const mgdt_triangulation* t, int64_t capacity, Int* v, Int* count,
             StageProgress& progress) {
    require_pointer(count, "count");
    require_capacity(capacity, 0, "the output array");
    Team team(t->object.threads_for(t->object.mesh().tetrahedra.size(), 65536));
    const EdgeLists edges = gabriel_edges(
        view_of(team, t, false), static_cast<std::size_t>(point_count(t->object)), progress);
    give_rows(t, 2, edges.size(), capacity, v, count, [&](Int base) {
        edges.write([&](std::size_t k, std::size_t position, const std::uint32_t* others,
                        std::size_t size) {
            for (std::size_t i = 0; i < size; ++i) {
                v[2 * (position + i)] = static_cast<Int>(k) + base;
                v[2 * (position + i) + 1] = static_cast<Int>(others[i]) + base;
            }
        });
    });
}

template <class Int>
void tree(const mgdt_triangulation* t, int64_t capacity, Int* v, Int* count,
          StageProgress& progress) {
    require_pointer(count, "count");
    require_capacity(capacity, 0, "the output array");
    Team team(t->object.threads_for(t->object.mesh().tetrahedra.size(), 65536));
    const Buffer<std::uint32_t> ends =
        spanning_tree(view_of(team, t, false), t->object.point_map(), progress);
    give_rows(t, 2, ends.size() / 2, capacity, v, count, [&](Int base) {
        for (std::size_t i = 0; i < ends.size(); ++i) v[i] = static_cast<Int>(ends[i]) + base;
    });
}

}  // namespace

extern "C" mgdt_status mgdt_get_gabriel_edges(const mgdt_triangulation* t, int64_t capacity,
                                              int64_t* v, int64_t* count) {
    return guard_long(t,
                      [&](StageProgress& progress) { gabriel(t, capacity, v, count, progress); });
}

extern "C" mgdt_status mgdt_get_gabriel_edges_i32(const mgdt_triangulation* t, int64_t capacity,
                                                  int32_t* v, int32_t* count) {
    return guard_long(t,
                      [&](StageProgress& progress) { gabriel(t, capacity, v, count, progress); });
}

extern "C" mgdt_status mgdt_get_spanning_tree(const mgdt_triangulation* t, int64_t capacity,
                                              int64_t* v, int64_t* count) {
    return guard_long(t, [&](StageProgress& progress) { tree(t, capacity, v, count, progress); });
}

extern "C" mgdt_status mgdt_get_spanning_tree_i32(const mgdt_triangulation* t, int64_t capacity,
                                                  int32_t* v, int32_t* count) {
    return guard_long(t, [&](StageProgress& progress) { tree(t, capacity, v, count, progress); });
}
