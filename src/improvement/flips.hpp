// SPDX-License-Identifier: MIT
// Passes over the worst tetrahedra that remove edges and faces.
#pragma once

#include "improvement/change_round.hpp"
#include "improvement/edge_removal.hpp"
#include "improvement/face_removal.hpp"

namespace mgdt {

class Flips {
  public:
    Flips(FlexibleMesh& mesh, Team& team, ChangeRound& round, bool slides)
        : mesh_(mesh),
          round_(round),
          finders_(team, mesh.allocator(), &mesh, slides),
          candidates_(mesh.allocator()) {}

    // Removes an edge or a face of each tetrahedron whose quality is below the goal, where that
    // makes the worst one better. Returns the number of changes.
    std::size_t pass(double goal, StageProgress& progress);
    // The tetrahedra that the last pass has tried to improve.
    std::size_t candidate_count() const noexcept { return candidates_.size(); }

  private:
    struct Finder {
        Finder(const FlexibleMesh* mesh, bool slides)
            : edges(*mesh, slides), faces(*mesh), other(mesh->allocator()) {}
        EdgeRemoval edges;
        FaceRemoval faces;
        Change other;
    };
    bool find(std::uint32_t t, Finder& finder, Change& best) const;

    FlexibleMesh& mesh_;
    ChangeRound& round_;
    PerMember<Finder> finders_;
    Buffer<std::uint32_t> candidates_;
};

}  // namespace mgdt
