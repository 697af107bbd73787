// SPDX-License-Identifier: MIT
// The kernel's interface: tables of functions. The same code is compiled for several instruction
// sets, and for meshes with and without stored spheres; each handle uses one table.
#pragma once

#include "kernel/workspace.hpp"

namespace mgdt {

class MarkTable;
class ThreadState;

struct Insertion {
    // A tetrahedron of the new star, or one that has the duplicate vertex. no_tetrahedron if the
    // insertion met a tetrahedron that another thread owns; nothing has changed then.
    TetId tetrahedron;
    VertexId duplicate;  // the vertex with the same coordinates, or infinite_vertex
};

// A walk to the finite tetrahedron that contains q. Its steps can be interleaved with those of
// other walks, so that their cache misses overlap.
struct LocationWalk {
    double q[3];
    TetId tetrahedron;  // where the walk is; any tetrahedron may be the first
    double value, error;
    // After the last step: whether the walk has certainly ended at the tetrahedron that contains q,
    // or at a ghost whose facet q is beyond.
    bool is_certain;
    bool may_end_outside;     // whether a ghost in conflict ends the walk, even a distant one
    std::size_t steps_taken;  // counted by the caller of locate_step()
};

// The coordinates of the vertices around a hole, as columns by local number. Their length is a
// multiple of four. The elements of the vertex at infinity and of padding are NaN.
struct HoleColumns {
    static constexpr std::size_t most = 128;

    const double *x, *y, *z;
    std::size_t size;                  // at most `most`
    std::uint64_t skipped[most / 64];  // a bit for each element that is NaN
};

// The vertex that makes a tetrahedron with a facet of the hole, and the sphere of that tetrahedron
// relative to the first vertex of the facet.
struct ApexResult {
    std::uint32_t number;  // a local number, or one of the two constants below
    Sphere sphere;
};
inline constexpr std::uint32_t infinite_apex = no_index - 1;  // the facet is on the hull
inline constexpr std::uint32_t no_apex = no_index;            // the filter does not decide

struct KernelCalls {
    // Inserts vertex q, whose record is in the mesh, walking from `start`. Strong guarantee: when
    // it throws (std::bad_alloc, Error with MGDT_ERR_TOO_LARGE) the triangulation is unchanged.
    Insertion (*insert)(Mesh& mesh, Workspace& workspace, VertexId q, TetId start);
    // Like insert(), while other threads insert in their zones. q and `start` are in the zone of
    // this thread, and tetrahedra between zones are closed. The pointer is null for meshes without
    // spheres. The function also throws SlotSupply::NoSlots.
    Insertion (*insert_in_zone)(Mesh& mesh, Workspace& workspace, ThreadState& thread_state,
                                VertexId q, TetId start);
    // Like insert(), while other threads insert anywhere. This thread owns q and the guards of
    // `start`. The function also throws SlotSupply::NoSlots.
    Insertion (*insert_concurrent)(Mesh& mesh, Workspace& workspace, ThreadState& thread_state,
                                   VertexId q, TetId start);
    // locate_begin() computes the power with respect to the first tetrahedron of a location, and
    // locate_step() takes one step; it returns false when the walk has ended. See walk.hpp.
    void (*locate_begin)(const Mesh& mesh, LocationWalk& walk);
    bool (*locate_step)(const Mesh& mesh, LocationWalk& walk);
    // Samples `tries` random tetrahedra, and moves a long walk to the best if that has less power.
    void (*locate_jump)(const Mesh& mesh, LocationWalk& walk, std::size_t tries);
    // Finds the cavity that q would have; `start` is one of its members. The function leaves the
    // cavity in the workspace, and its members in `marks`. Several threads may call the function on
    // one mesh at the same time. Throws std::bad_alloc.
    void (*find_cavity)(const Mesh& mesh, Workspace& workspace, MarkTable& marks, const double* q,
                        TetId start);
    // Digs the cavity of q, without filling it, in a mesh with walls, through which it does not
    // grow: bit i of walls[t] says whether face i of tetrahedron t is one. `start` is in conflict
    // with q. Members are marked. Returns false, with no marks left, if the cavity needs a closed
    // tetrahedron. The pointer is null for meshes without spheres, as the next one is. Several
    // threads may call both functions on one mesh, each in its zone. Throws std::bad_alloc.
    bool (*dig_walled)(Mesh& mesh, Workspace& workspace, const std::uint8_t* walls, const double* q,
                       TetId start);
    // Fills the cavity in the workspace, which has room for its star, with the star of vertex q.
    // The new tetrahedra take slots from a stack, which ends at *slots, after those of the cavity;
    // slots that are free afterwards go there. Facet i of the boundary becomes face 0 of the new
    // tetrahedron in the workspace's slot i.
    void (*fill_walled)(Mesh& mesh, Workspace& workspace, VertexId q, TetId** slots);
};

struct Kernel {
    const char* isa;
    KernelCalls with_spheres;     // for a mesh that stores spheres
    KernelCalls without_spheres;  // for a mesh in compact storage
    // Finds the apex of a facet. All vertices around the hole must be in the normal range.
    ApexResult (*find_apex)(const HoleColumns& vertices, const std::uint32_t (&facet)[3]);

    const KernelCalls& on(const Mesh& mesh) const noexcept {
        return mesh.tetrahedra.has_spheres() ? with_spheres : without_spheres;
    }
};

// The kernel with this name, or the best one for a null pointer; nullptr if the processor cannot
// run it.
const Kernel* find_kernel(const char* name) noexcept;

// The kernel that the environment variable MGDT_ISA names, if the processor can run it; otherwise
// the best one.
const Kernel& default_kernel() noexcept;

}  // namespace mgdt
