// SPDX-License-Identifier: MIT
// The tetrahedra of a periodic triangulation, one of each class of translated tetrahedra, with
// their neighbours.
#pragma once

#include "periodic/halo.hpp"

namespace mgdt {

// The representative of a class is the tetrahedron whose lexicographically least corner is in the
// box; this is corner 0. Corners are positively oriented. Corner 1 is the least of the other three,
// first by point and then by multiples. The tetrahedra are sorted by their corners in the same way.
class PeriodicTetrahedra {
  public:
    struct Tetrahedron {
        Image corners[4];
    };
    // The neighbour opposite a corner: the number of its class, and the multiples by which the
    // representative of that class is moved. `number` is no_index if the facet is on the hull.
    struct Neighbor {
        std::uint32_t number;
        std::int8_t of[4];
    };
    // A tetrahedron with its neighbours.
    struct Record {
        Tetrahedron tetrahedron;
        Neighbor neighbors[4];
    };

    PeriodicTetrahedra(Allocator& allocator, const Halo& halo);

    std::size_t size() const { return records_.size(); }
    const Buffer<Record>& records() const { return records_; }
    const Tetrahedron& operator[](std::size_t i) const { return records_[i].tetrahedron; }

  private:
    Buffer<Record> records_;
};

}  // namespace mgdt
