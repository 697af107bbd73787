// SPDX-License-Identifier: MIT
// Improves a mesh until its tetrahedra reach a goal, or nothing helps any more.
#pragma once

#include "improvement/change_round.hpp"
#include "improvement/edge_contraction.hpp"
#include "improvement/edge_removal.hpp"
#include "improvement/face_removal.hpp"
#include "improvement/smoothing.hpp"
#include "improvement/vertex_insertion.hpp"

namespace mgdt {

struct ImprovementSettings {
    double goal = 0;         // a quality
    double raised_goal = 0;  // the goal near tetrahedra for which nothing else helps
    bool slides = false;     // whether edges inside of plane facets may change
    int most_passes = 100;
    int mean_passes = 0;
};

class Improver {
  public:
    Improver(FlexibleMesh& mesh, Team& team, const ImprovementSettings& settings)
        : mesh_(mesh),
          settings_(settings),
          round_(mesh, team),
          finders_(team, mesh.allocator(), &mesh, settings.slides),
          smoothing_(mesh, team),
          failed_(mesh.allocator()),
          candidates_(mesh.allocator()),
          is_near_(mesh.allocator()) {}

    // A mesh that reaches the goal is left as it is, unless the goal is 0.
    void run(StageProgress& progress);
    // The changes and moves of all passes so far, and the passes over what is below the goal.
    std::size_t changes() const noexcept { return changes_; }
    std::size_t passes() const noexcept { return passes_; }

    // Single passes over the candidates. Each returns the number of changes.
    std::size_t flip(StageProgress& progress);
    std::size_t contract(StageProgress& progress);
    std::size_t insert(StageProgress& progress);
    std::size_t smooth(StageProgress& progress);
    std::size_t smooth_mean(StageProgress& progress);
    // Makes the tetrahedra below a quality the candidates. Returns by how much they miss it, all
    // together, in units of the quality.
    double choose(double quality);

  private:
    struct Finder {
        Finder(const FlexibleMesh* mesh, bool slides)
            : edges(*mesh, slides),
              faces(*mesh),
              contraction(*mesh),
              insertion(*mesh),
              other(mesh->allocator()) {}
        EdgeRemoval edges;
        FaceRemoval faces;
        EdgeContraction contraction;
        VertexInsertion insertion;
        Change other;
    };
    std::uint32_t last_change(std::uint32_t t) const noexcept;
    template <class Find>
    std::size_t run_round(FailedTries::Kind kind, StageProgress& progress, const Find& find);
    template <class Pass>
    std::size_t count_changes(StageProgress& progress, const Pass& pass);
    bool find_flip(std::uint32_t t, Finder& finder, Change& best) const;
    bool find_contraction(std::uint32_t t, Finder& finder, Change& best) const;
    double pass(double quality, bool inserts, StageProgress& progress);
    void choose_near(double quality, int rings);
    void flip_most(StageProgress& progress);
    void reach_goal(StageProgress& progress);

    FlexibleMesh& mesh_;
    const ImprovementSettings settings_;
    ChangeRound round_;
    PerMember<Finder> finders_;
    Smoothing smoothing_;
    FailedTries failed_;                // of tetrahedra
    Buffer<std::uint32_t> candidates_;  // tetrahedra
    Buffer<std::uint8_t> is_near_;      // whether a vertex is near what is left
    double goal_ = 0;                   // below which tetrahedra are candidates
    bool pushes_ = false;               // whether moves may push other tetrahedra below the goal
    bool is_tail_ = false;  // whether few tetrahedra are left, which are hard to improve
    std::size_t changes_ = 0, passes_ = 0;
    int rings_ = 0;  // 0 while all tetrahedra may be candidates
};

}  // namespace mgdt
