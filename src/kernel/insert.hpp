// SPDX-License-Identifier: MIT
// The insertion of a point: the walk to a tetrahedron in conflict with it, the cavity of all
// tetrahedra in conflict, and the star that replaces them. Compiled in each island.
#pragma once

#include "kernel/apex.hpp"
#include "kernel/cavity.hpp"
#include "kernel/kernel.hpp"
#include "kernel/star.hpp"
#include "kernel/walk.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

template <class Access>
MGDT_ALWAYS_INLINE Insertion insert_with(Access access, Mesh& mesh, Workspace& w, VertexId q,
                                         TetId start) {
    // If the mesh has no extreme vertices, q is not extreme, and the second test is skipped.
    const double* const point = mesh.point(q);
    const Query query(point, MGDT_LIKELY(!mesh.has_extremes) || in_normal_range(point));
    const typename Access::SphereSource spheres(mesh);
    // Whether the walk starts in the star of the previous insertion.
    const bool is_in_star = w.slot_count != 0 && start == tetrahedron_of(w.slots.data[0]);
    const WalkResult found = walk(
        access, mesh,
        is_in_star ? start_in_star(spheres, w, query, w.counters)
                   : start_at(spheres, start, query, w.counters),
        query, w.counters, [&] { return is_in_star ? ghost_of_star(mesh, w) : no_tetrahedron; },
        w.may_jump);
    if (found.duplicate != infinite_vertex) return {found.start.tetrahedron, found.duplicate};
    if (found.start.tetrahedron == no_tetrahedron ||
        !dig_cavity(access, mesh, w, found.start, query))
        return {no_tetrahedron, infinite_vertex};
    return {build_star(access, mesh, w, q), infinite_vertex};
}

template <class Spheres>
Insertion insert(Mesh& mesh, Workspace& w, VertexId q, TetId start) {
    return insert_with(SerialAccess<Spheres>{mesh}, mesh, w, q, start);
}

template <class Spheres>
Insertion insert_concurrent(Mesh& mesh, Workspace& w, ThreadState& thread_state, VertexId q,
                            TetId start) {
    return insert_with(ConcurrentAccess<Spheres>(mesh, thread_state), mesh, w, q, start);
}

inline Insertion insert_in_zone(Mesh& mesh, Workspace& w, ThreadState& thread_state, VertexId q,
                                TetId start) {
    return insert_with(ZoneAccess(mesh, thread_state), mesh, w, q, start);
}

template <class Spheres>
void find_cavity(const Mesh& mesh, Workspace& w, MarkTable& marks, const double* q, TetId start) {
    // With ReadingAccess, dig_cavity() writes to the workspace and to `marks`, but not to the mesh.
    dig_cavity(ReadingAccess<Spheres>{marks}, const_cast<Mesh&>(mesh), w, {start, 0}, Query(q));
}

inline bool dig_walled(Mesh& mesh, Workspace& w, const std::uint8_t* walls, const double* q,
                       TetId start) {
    return dig_cavity(WalledAccess(mesh, walls, nullptr), mesh, w, {start, 0}, Query(q));
}

inline void fill_walled(Mesh& mesh, Workspace& w, VertexId q, TetId** slots) {
    build_star(WalledAccess(mesh, nullptr, slots), mesh, w, q);
}

template <class Spheres>
constexpr KernelCalls kernel_calls = {insert<Spheres>,
                                      Spheres::are_kept ? insert_in_zone : nullptr,
                                      insert_concurrent<Spheres>,
                                      locate_begin<Spheres>,
                                      locate_step<Spheres>,
                                      locate_jump<Spheres>,
                                      find_cavity<Spheres>,
                                      Spheres::are_kept ? dig_walled : nullptr,
                                      Spheres::are_kept ? fill_walled : nullptr};

// The functions of this island that the library calls.
constexpr Kernel kernel_named(const char* isa) {
    return {isa, kernel_calls<KeptSpheres>, kernel_calls<ComputedSpheres>, find_apex};
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
