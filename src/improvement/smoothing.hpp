// SPDX-License-Identifier: MIT
// Moves vertices so that the worst tetrahedra at them become better.
#pragma once

#include "improvement/vertex_classes.hpp"
#include "improvement/vertex_star.hpp"
#include "parallel/per_member.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

class Smoothing {
  public:
    Smoothing(FlexibleMesh& mesh, Team& team, const Buffer<VertexClass>& classes)
        : mesh_(mesh),
          team_(team),
          classes_(classes),
          movers_(team, mesh.allocator(), &mesh.allocator()),
          candidates_(mesh.allocator()),
          stars_(mesh.allocator()),
          color_(mesh.allocator()),
          begin_of_color_(mesh.allocator()),
          order_(mesh.allocator()) {}

    // Moves the vertices of the tetrahedra whose quality is below the goal, where that makes the
    // worst tetrahedron of the star better. Returns the number of vertices that have moved.
    std::size_t pass(double goal, StageProgress& progress);
    std::size_t candidate_count() const noexcept { return candidates_.size(); }

  private:
    // What a thread works with.
    struct Mover {
        explicit Mover(Allocator* allocator)
            : star(*allocator), tetrahedra(*allocator), qualities(*allocator) {}
        VertexStar star;
        Buffer<std::uint32_t> tetrahedra;  // of all stars that the thread has collected
        Buffer<double> qualities;          // of the star at the place that is tried
        std::size_t moved = 0;
    };
    // Where the star of a candidate is.
    struct Star {
        std::size_t begin;
        std::uint32_t member, size;
    };

    void choose_candidates(double goal);
    void collect_stars(StageProgress& progress);
    void color();
    bool smooth(std::uint32_t candidate, Mover& mover);
    const std::uint32_t* tetrahedra_of(const Star& star) const noexcept {
        return movers_[star.member].tetrahedra.begin() + star.begin;
    }

    FlexibleMesh& mesh_;
    Team& team_;
    const Buffer<VertexClass>& classes_;
    PerMember<Mover> movers_;
    Buffer<std::uint32_t> candidates_;
    Buffer<Star> stars_;                    // of each candidate
    Buffer<std::uint8_t> color_;            // of each vertex, 0 for none
    Buffer<std::uint32_t> begin_of_color_;  // where the candidates of each colour begin
    Buffer<std::uint32_t> order_;           // candidates by colour
};

}  // namespace mgdt
