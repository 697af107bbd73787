// SPDX-License-Identifier: MIT
// The skeleton: a few points of all parts, which each part triangulates together with its own
// points. With the skeleton, the triangulation of each part spans space, and its circumballs are
// not much larger than the circumballs of the triangulation of all points.
#pragma once

#include "parts/part.hpp"
#include "platform/objects.hpp"

namespace mgdt {

class Skeleton {
  public:
    explicit Skeleton(Allocator& allocator) : offers_(allocator), basis_(allocator) {}

    // Collective. `parts` are the local parts.
    void gather(Collective& all, const Objects<Part>& parts);
    // Sets `points` to the skeleton for one part, which may contain repeats and the part's own
    // points.
    void points_for(PartId part, PartId parts, Buffer<PartPoint>& points) const;

  private:
    static constexpr std::size_t sample_size = 64;
    static constexpr std::size_t directions = 26;
    // The points that a part offers: a sample of its own points, and the farthest one in each
    // direction. `count` is the number of own points; without own points, a part offers none.
    struct Offer {
        std::uint64_t count;
        PartPoint sample[sample_size];
        PartPoint farthest[directions];
    };
    // Finds up to four points of all parts that span exactly the affine hull of all points.
    void find_basis(Collective& all, const Objects<Part>& parts);

    Buffer<Offer> offers_;
    Buffer<PartPoint> basis_;
};

}  // namespace mgdt
