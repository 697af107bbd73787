// SPDX-License-Identifier: MIT
// The tetrahedra of a periodic triangulation, one of each class of translated tetrahedra, with
// their neighbours.
#pragma once

#include "periodic/halo.hpp"

namespace mgdt {

// Each class is represented by the tetrahedron whose lexicographically least corner is in the box,
// which is corner 0. Corners are positively oriented. Of corners 1 to 3, the first is the least by
// its point and then by its multiples. The tetrahedra are sorted by their corners in the same way.
class PeriodicTetrahedra {
  public:
    struct Tetrahedron {
        Image corners[4];
    };
    // The tetrahedron opposite a corner: its number, and the multiples by which its representative
    // has to be moved to be there. Without one, the facet is on the hull.
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
