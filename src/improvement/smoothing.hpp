// SPDX-License-Identifier: MIT
// Moves vertices so that the worst tetrahedra at them become better.
#pragma once

#include "improvement/failed_tries.hpp"
#include "improvement/flexible_mesh.hpp"
#include "improvement/place_search.hpp"
#include "improvement/vertex_star.hpp"
#include "parallel/per_member.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

class Smoothing {
  public:
    Smoothing(FlexibleMesh& mesh, Team& team)
        : mesh_(mesh),
          team_(team),
          movers_(team, mesh.allocator(), &mesh.allocator()),
          candidates_(mesh.allocator()),
          stars_(mesh.allocator()),
          color_(mesh.allocator()),
          begin_of_color_(mesh.allocator()),
          order_(mesh.allocator()),
          failed_(mesh.allocator()) {}

    // Moves the vertices of some tetrahedra where that makes the worst tetrahedron at the vertex
    // better. Moves of a kind that have failed are not tried again while the star is the same.
    // Returns the number of vertices that have moved.
    std::size_t pass(const Buffer<std::uint32_t>& tetrahedra, const Moves& moves,
                     FailedTries::Kind kind, StageProgress& progress);
    // Moves the vertices of some tetrahedra where that makes the mean better, and none worse than
    // the goal or the worst one at the vertex.
    std::size_t pass_for_mean(const Buffer<std::uint32_t>& tetrahedra, double goal,
                              StageProgress& progress);

  private:
    // What a thread works with.
    struct Mover {
        explicit Mover(Allocator* allocator)
            : star(*allocator), search(*allocator), tetrahedra(*allocator) {}
        VertexStar star;
        PlaceSearch search;
        Buffer<std::uint32_t> tetrahedra;  // of all stars that the thread has collected
    };
    // Where the star of a candidate is.
    struct Star {
        std::size_t begin;
        std::uint32_t member, size;
        bool has_moved;
        double place[3];  // where the vertex was before
    };

    void choose_candidates(const Buffer<std::uint32_t>& tetrahedra);
    void collect_stars(StageProgress& progress);
    void color();
    template <class Search>
    std::size_t move_all(const Buffer<std::uint32_t>& tetrahedra, StageProgress& progress,
                         const Search& search);
    template <class Search>
    void move(std::uint32_t candidate, Mover& mover, const Search& search);
    void put(std::uint32_t candidate, const double (&place)[3]);
    void undo_moves();
    template <class Search>
    std::size_t move_colors(StageProgress& progress, const Search& search);
    std::size_t note_moves(std::size_t begin, std::size_t end);
    const std::uint32_t* tetrahedra_of(const Star& star) const noexcept {
        return movers_[star.member].tetrahedra.begin() + star.begin;
    }

    FlexibleMesh& mesh_;
    Team& team_;
    PerMember<Mover> movers_;
    Buffer<std::uint32_t> candidates_;
    Buffer<Star> stars_;                    // of each candidate
    Buffer<std::uint8_t> color_;            // of each vertex, 0 for none
    Buffer<std::uint32_t> begin_of_color_;  // where the candidates of each colour begin
    Buffer<std::uint32_t> order_;           // candidates by colour
    FailedTries failed_;                    // of vertices
};

}  // namespace mgdt
