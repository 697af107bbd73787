// SPDX-License-Identifier: MIT
// The handle of a mesh behind the C interface.
#pragma once

#include "capi/handle.hpp"
#include "improvement/mesh_improvement.hpp"
#include "mgdt/mgdt_mesh.h"
#include "platform/cached.hpp"
#include "refinement/mesh_refinement.hpp"
#include "solid/boundary_places.hpp"
#include "solid/given_mesh.hpp"
#include "solid/mesh_locator.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

struct MeshSettings : CallSettings, ImprovementOptions, RefinementOptions {};

// A mesh, and what its handle has beside it.
struct MeshState : SolidMesh {
    explicit MeshState(Allocator& allocator)
        : SolidMesh(allocator),
          fixed_points(allocator),
          report(allocator),
          wishes(allocator),
          refinement(allocator),
          locator(allocator),
          boundary_places(allocator),
          input(allocator),
          fixed_input_points(allocator) {}

    std::size_t given_point_count() const noexcept {
        return points.size() / 3 - steiner_parameters.size();
    }

    void forget_places() noexcept {
        locator.forget();
        boundary_places.forget();
    }
    // What is known of points and tetrahedra by their numbers, which change.
    void forget_numbers() noexcept {
        forget_places();
        wishes.of_points.reset();
        wishes.of_tetrahedra.reset();
        refinement.clear();
    }
    void clear_input() noexcept {
        has_input = false;
        input.points.reset();
        for (Buffer<std::uint32_t>* const list :
             {&input.tetrahedra, &input.faces, &input.edges, &fixed_input_points})
            list->reset();
        for (Buffer<std::int32_t>* const list :
             {&input.tetrahedron_markers, &input.face_markers, &input.edge_markers})
            list->reset();
    }

    Buffer<std::uint32_t> fixed_points;  // of this mesh
    ImprovementReport report;            // of its last improvement
    SizeWishes wishes;                   // for its next refinement
    RefinementReport refinement;         // of its last one, unless the mesh has changed since
    // What finds places; forgotten when the mesh changes.
    mutable Cached<MeshLocator> locator;
    mutable Cached<BoundaryPlaces> boundary_places;
    // What the next build makes a mesh of, if points have been set since the last one.
    bool has_input = false;
    GivenMesh input;
    Buffer<std::uint32_t> fixed_input_points;
};

using MeshObject = Result<MeshState, MeshSettings>;

}  // namespace mgdt

struct mgdt_mesh : mgdt::Handle<mgdt::MeshObject> {
    using Handle::Handle;
};
