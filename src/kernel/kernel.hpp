// SPDX-License-Identifier: MIT
// The kernel: insertion of one point, in a table so that the same code is compiled for
// several instruction sets, of which a handle has one, and for meshes with spheres and without.
#pragma once

#include "kernel/workspace.hpp"

namespace mgdt {

class MarkTable;
class ThreadState;

struct Insertion {
    // Of the new star, or one that has the duplicate; no_tetrahedron where an insertion among
    // others came to what is another thread's, and changed nothing.
    TetId tetrahedron;
    VertexId duplicate;  // the vertex that was there before, or infinite_vertex
};

// A walk to the finite tetrahedron that contains q, which can be taken step by step together with
// others, so that they wait for memory together.
struct LocationWalk {
    double q[3];
    TetId tetrahedron;  // before the first step: any
    double value, error;
    // After the last step: whether it is certain that this one contains q, or is a ghost beyond
    // whose facet q is.
    bool is_certain;
    bool may_end_outside;     // whether such a ghost will do, however far away it is
    std::size_t steps_taken;  // counted by the caller of locate_step()
};

// The link of a vertex that is removed, in columns by local number, padded to fours.
struct LinkColumns {
    const double *x, *y, *z;
    double* skipped;  // -0.0 for the vertex at infinity and what is padding, else 0.0
    std::size_t size;
};

// What makes a tetrahedron with a facet of the hole, and its sphere relative to the facet's first
// vertex.
struct ApexResult {
    std::uint32_t number;  // in the link, or one of these
    Sphere sphere;
};
inline constexpr std::uint32_t infinite_apex = no_index - 1;  // the facet is on the hull
inline constexpr std::uint32_t no_apex = no_index;            // the filter does not decide

struct KernelCalls {
    // Inserts vertex q, whose record is in the mesh, walking from `start`. Strong guarantee: when
    // it throws (std::bad_alloc, Error with MGDT_ERR_TOO_LARGE) the triangulation is unchanged.
    Insertion (*insert)(Mesh& mesh, Workspace& workspace, VertexId q, TetId start);
    // The same while other threads insert in zones of their own, where q and `start` are in this
    // thread's and the tetrahedra between zones are closed; null without spheres. May throw
    // SlotSupply::NoSlots too.
    Insertion (*insert_in_zone)(Mesh& mesh, Workspace& workspace, ThreadState& thread_state,
                                VertexId q, TetId start);
    // The same while other threads insert anywhere: q and the vertices of `start` are the
    // thread_state's.
    // May throw SlotSupply::NoSlots too.
    Insertion (*insert_concurrent)(Mesh& mesh, Workspace& workspace, ThreadState& thread_state,
                                   VertexId q, TetId start);
    // A location's first power, and its next step; false where it ends. See walk.hpp.
    void (*locate_begin)(const Mesh& mesh, LocationWalk& walk);
    bool (*locate_step)(const Mesh& mesh, LocationWalk& walk);
    // Continues a long walk from the best of `tries` tetrahedra all over the mesh.
    void (*locate_jump)(const Mesh& mesh, LocationWalk& walk, std::size_t tries);
    // The cavity that q would have, of which `start` is a member. It is left in the workspace, and
    // its tetrahedra in `marks`; many threads may do this to one mesh. Throws std::bad_alloc.
    void (*find_cavity)(const Mesh& mesh, Workspace& workspace, MarkTable& marks, const double* q,
                        TetId start);
};

struct Kernel {
    const char* isa;
    KernelCalls with_spheres;     // for a mesh that keeps them
    KernelCalls without_spheres;  // for one that does not
    // All of the link has to be in the range in which filters are proved.
    ApexResult (*find_apex)(const LinkColumns& link, const std::uint32_t (&facet)[3]);

    const KernelCalls& on(const Mesh& mesh) const noexcept {
        return mesh.tetrahedra.has_spheres() ? with_spheres : without_spheres;
    }
};

// The kernel of that name, or the best for NULL; nullptr if this processor does not run it.
const Kernel* find_kernel(const char* name) noexcept;

// The kernel that MGDT_ISA in the environment names if the processor runs it, else the best.
const Kernel& default_kernel() noexcept;

}  // namespace mgdt
