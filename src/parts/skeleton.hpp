// SPDX-License-Identifier: MIT
// A few points of all parts that each part triangulates with its own, so that its triangulation
// spans space and its balls and hull facets are not much larger than those of all points.
#pragma once

#include "parts/part.hpp"
#include "platform/objects.hpp"

namespace mgdt {

class Skeleton {
  public:
    explicit Skeleton(Allocator& allocator) : offers_(allocator), basis_(allocator) {}

    // Collective. parts: the local ones.
    void gather(Collective& all, const Objects<Part>& parts);
    // Those for one part, with repeats, some of which may be its own.
    void points_for(PartId part, PartId parts, Buffer<PartPoint>& points) const;

  private:
    static constexpr std::size_t sample_size = 64;
    static constexpr std::size_t directions = 26;
    // What a part offers: some of its points, and the farthest in each direction; none where
    // `count` is 0.
    struct Offer {
        std::uint64_t count;
        PartPoint sample[sample_size];
        PartPoint farthest[directions];
    };
    // Points of all parts that span what all points span, exactly.
    void find_basis(Collective& all, const Objects<Part>& parts);

    Buffer<Offer> offers_;
    Buffer<PartPoint> basis_;
};

}  // namespace mgdt
