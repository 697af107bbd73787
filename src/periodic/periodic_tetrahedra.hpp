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
    static constexpr std::uint32_t none = 0xFFFFFFFFu;

    struct Tetrahedron {
        Image corners[4];
    };
    // The tetrahedron opposite a corner: its number, and the multiples by which its representative
    // has to be moved to be there. Without one, the facet is on the hull.
    struct Neighbor {
        std::uint32_t number;
        std::int8_t of[4];
    };

    explicit PeriodicTetrahedra(Allocator& allocator)
        : allocator_(allocator), tetrahedra_(allocator), neighbors_(allocator) {}

    void list(const Halo& halo, const StopRequest& stop);
    void clear() noexcept {
        tetrahedra_.reset();
        neighbors_.reset();
    }
    std::size_t size() const { return tetrahedra_.size(); }
    const Tetrahedron& operator[](std::size_t i) const { return tetrahedra_[i]; }
    const Neighbor& neighbor(std::size_t i, unsigned corner) const {
        return neighbors_[4 * i + corner];
    }

  private:
    Allocator& allocator_;
    Buffer<Tetrahedron> tetrahedra_;
    Buffer<Neighbor> neighbors_;
};

}  // namespace mgdt
