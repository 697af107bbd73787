// SPDX-License-Identifier: MIT
// The skeleton: a few points of all parts, which each part triangulates with its own. With them,
// each triangulation spans space, and its circumballs are not much larger than those of all points.
#pragma once

#include "parts/part.hpp"
#include "platform/objects.hpp"

namespace mgdt {

class Skeleton {
  public:
    explicit Skeleton(Allocator& allocator) : offers_(allocator), basis_(allocator) {}

    // Collective. `parts` are the local parts.
    void gather(Collective& all, const Objects<Part>& parts);
    // The points for one part. There may be repeats and the part's own points.
    void points_for(PartId part, PartId parts, Buffer<PartPoint>& points) const;

  private:
    static constexpr std::size_t sample_size = 64;
    static constexpr std::size_t directions = 26;
    // The points that a part offers: some of them, and the farthest in each direction. None if
    // `count` is 0.
    struct Offer {
        std::uint64_t count;
        PartPoint sample[sample_size];
        PartPoint farthest[directions];
    };
    // Points of all parts that span the affine hull of all points, exactly.
    void find_basis(Collective& all, const Objects<Part>& parts);

    Buffer<Offer> offers_;
    Buffer<PartPoint> basis_;
};

}  // namespace mgdt
