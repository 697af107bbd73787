// SPDX-License-Identifier: MIT
// The improvement of a mesh as a caller asks for it: with options, and a report.
#pragma once

#include "improvement/explanation.hpp"
#include "improvement/vertex_classes.hpp"
#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"
#include "solid/shape_summary.hpp"

namespace mgdt {

struct ImprovementOptions {
    static constexpr std::int32_t largest_goal = 70, largest_mean_passes = 1000,
                                  largest_most_passes = 10000;

    std::int32_t goal = 25;  // for the least dihedral angle, in degrees
    std::int32_t mean_passes = 0;
    std::int32_t most_passes = 100;
    bool slides = false;  // whether faces and edges that the mesh lists may change
    std::int32_t points =
        static_cast<std::int32_t>(Permission::to_move);  // for those that were set
};

struct ImprovementReport {
    explicit ImprovementReport(Allocator& allocator) : reasons(allocator) {}

    void clear() noexcept {
        is_made = false;
        reasons.reset();
        below_goal = passes = moved_points = removed_points = 0;
    }

    bool is_made = false;
    ShapeSummary before, after;
    Buffer<Reason> reasons;  // of each tetrahedron of the mesh
    std::size_t below_goal = 0, passes = 0;
    std::size_t moved_points = 0, removed_points = 0;  // of those that were set
};

// Improves a mesh. `fixed` are points that stay where they are. If the call is cancelled, the mesh
// and the report are those of the last complete round, or if that has a surface that meets itself,
// both stay as they were. They do so if memory runs out, too.
void improve_mesh(SolidMesh& mesh, const ImprovementOptions& options,
                  const Buffer<std::uint32_t>& fixed, Team& team, Allocator& allocator,
                  StageProgress& progress, ImprovementReport& report);

// The square of the sine of an angle in degrees, from 0 to 90. It is the same on all machines.
double squared_sine_of(double degrees) noexcept;

}  // namespace mgdt
