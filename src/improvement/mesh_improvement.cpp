// SPDX-License-Identifier: MIT
#include "improvement/mesh_improvement.hpp"

#include <algorithm>
#include <utility>

#include "improvement/improver.hpp"
#include "platform/error.hpp"
#include "solid/embedding_check.hpp"

namespace mgdt {
namespace {

class MeshImprovement {
  public:
    MeshImprovement(SolidMesh& mesh, const ImprovementOptions& options, Team& team,
                    Allocator& allocator, ImprovementReport& report)
        : mesh_(mesh),
          options_(options),
          team_(team),
          allocator_(allocator),
          report_(report),
          flexible_(mesh, team, allocator),
          improver_(flexible_, team, settings()) {}

    // Returns false, and leaves the mesh as it was, if its surface has come to meet itself.
    bool run(const Buffer<std::uint32_t>& fixed, StageProgress& progress) {
        allow(fixed);
        StageProgress quiet = progress.quiet();
        const ShapeSummary before = summarize_shapes(mesh_, team_, allocator_, quiet);
        try {
            if (flexible_.can_move()) improver_.run(progress);
        } catch (const Error& error) {
            if (error.status == MGDT_ERR_CANCELLED) finish(before);
            throw;
        }
        return finish(before);
    }

  private:
    ImprovementSettings settings() const noexcept {
        constexpr double raise = 10;
        ImprovementSettings settings;
        settings.goal = squared_sine_of(options_.goal);
        settings.raised_goal = std::min(squared_sine_of(options_.goal + raise), best_quality);
        settings.slides = options_.slides;
        settings.most_passes = options_.most_passes;
        settings.mean_passes = options_.mean_passes;
        return settings;
    }
    std::size_t given_points() const noexcept {
        return mesh_.points.size() / 3 - mesh_.steiner_parameters.size();
    }

    void allow(const Buffer<std::uint32_t>& fixed) {
        Buffer<Permission> permissions(allocator_);
        permissions.resize(given_points(), static_cast<Permission>(options_.points));
        // Tetrahedra have the first of several equal points as a corner.
        for (const std::uint32_t p : fixed) permissions[mesh_.point_origins[p]] = Permission::none;
        permissions.resize(mesh_.points.size() / 3, Permission::to_leave);
        classify_vertices(flexible_, permissions, options_.slides);
    }

    // Writes the mesh and the report. All memory that the report takes is there before the mesh
    // changes. Returns false, and changes nothing, if the surface meets itself where it did not.
    bool finish(const ShapeSummary& before) {
        ImprovementReport made(report_.reasons.allocator());
        Buffer<Reason> of_slots(allocator_);
        explain(flexible_, settings().goal, of_slots);
        std::size_t count = 0;
        for (const FlexibleMesh::Tetrahedron& t : flexible_.tetrahedra)
            count += t.is_dead() ? 0 : 1;
        made.reasons.resize(count, Reason::none);
        made.is_made = true;
        made.before = made.after = before;
        made.passes = improver_.passes();
        if (improver_.changes() == 0) {
            std::copy(of_slots.begin(), of_slots.end(), made.reasons.begin());
        } else {
            SolidMesh written(mesh_.points.allocator());
            Buffer<std::uint32_t> number(allocator_);
            flexible_.write(mesh_, written, number);
            StageProgress quiet = unstoppable();
            if (options_.slides && !is_embedded(written, team_, allocator_, quiet) &&
                is_embedded(mesh_, team_, allocator_, quiet))
                return false;
            made.after = summarize_shapes(written, team_, allocator_, quiet);
            for (std::size_t i = 0; i < number.size(); ++i)
                if (number[i] != no_index) made.reasons[number[i]] = of_slots[i];
            count_points(written, made);
            mesh_ = std::move(written);
        }
        made.below_goal =
            made.reasons.size() - static_cast<std::size_t>(std::count(
                                      made.reasons.begin(), made.reasons.end(), Reason::none));
        report_ = std::move(made);
        return true;
    }

    void count_points(const SolidMesh& written, ImprovementReport& made) const {
        for (std::size_t p = 0; p < given_points(); ++p) {
            const double* const x = mesh_.points.begin() + 3 * p;
            if (!std::equal(x, x + 3, written.points.begin() + 3 * p)) ++made.moved_points;
        }
        made.removed_points = written.unused_points.size() - mesh_.unused_points.size();
    }

    // A request to stop has been answered when the mesh is written.
    StageProgress unstoppable() { return StageProgress(CallSettings(), never_); }

    SolidMesh& mesh_;
    const ImprovementOptions& options_;
    Team& team_;
    Allocator& allocator_;
    ImprovementReport& report_;
    FlexibleMesh flexible_;
    Improver improver_;
    StopFlag never_;
};

}  // namespace

double squared_sine_of(double degrees) noexcept {
    // (1 - cos(2x)) / 2 = sum of (-1)^(k+1) 2^(2k-1) x^(2k) / (2k)!, where x is at most pi / 2.
    constexpr double radians_per_degree = 0.017453292519943295769;
    const double x = degrees * radians_per_degree, square = x * x;
    double term = square, sum = square;
    for (int k = 1; k < 16; ++k) {
        term *= -4 * square / ((2 * k + 1) * (2 * k + 2));
        sum += term;
    }
    return sum;
}

void improve_mesh(SolidMesh& mesh, const ImprovementOptions& options,
                  const Buffer<std::uint32_t>& fixed, Team& team, Allocator& allocator,
                  StageProgress& progress, ImprovementReport& report) {
    // A facet of faces that are not quite in one plane sweeps a thin space where it slides. What is
    // in that space, such as another part of the surface, would be overlapped.
    if (MeshImprovement(mesh, options, team, allocator, report).run(fixed, progress)) return;
    ImprovementOptions without_slides = options;
    without_slides.slides = false;
    MeshImprovement(mesh, without_slides, team, allocator, report).run(fixed, progress);
}

}  // namespace mgdt
