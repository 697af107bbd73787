// SPDX-License-Identifier: MIT
// The sizes that a caller gives as a field of points or as a function.
#pragma once

#include <optional>

#include "core/triangulation.hpp"
#include "mgdt/mgdt_mesh.h"
#include "platform/stage_progress.hpp"
#include "refinement/size_tree.hpp"

namespace mgdt {

// Sizes at places, in the units of the caller's coordinates.
struct VaryingSizes {
    explicit VaryingSizes(Allocator& allocator) : field_points(allocator), field_sizes(allocator) {}

    Buffer<double> field_points;  // three coordinates each
    Buffer<double> field_sizes;   // at these points; linear between them
    mgdt_size_fn function = nullptr;
    void* user = nullptr;

    bool empty() const noexcept { return field_sizes.empty() && !function; }
};

class SizeSampler {
  public:
    // `scale` is what the caller's lengths are multiplied by in the mesh.
    SizeSampler(const VaryingSizes& sizes, double scale, Team& team, Allocator& allocator,
                StageProgress& progress);

    // Writes the sizes at n places, in the units of the mesh: the lesser one where there are two,
    // and infinity where there is none. Throws MGDT_ERR_INVALID_ARGUMENT if the function gives
    // something that is no size, and MGDT_ERR_CANCELLED if it asks to stop.
    void sample(std::size_t n, const double* places, double* sizes);
    // The points of the field, in the units of the mesh.
    void list_seeds(Buffer<SizeTree::Seed>& seeds) const;

  private:
    void ask_function(std::size_t n, double* sizes);
    void interpolate_field(std::size_t n, double* sizes);

    const VaryingSizes& given_;
    const double scale_;
    Team& team_;
    Allocator& allocator_;
    StageProgress& progress_;
    std::optional<Triangulation> field_;
    Buffer<double> places_, values_;
};

}  // namespace mgdt
