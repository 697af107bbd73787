// SPDX-License-Identifier: MIT
// The tetrahedra of a periodic triangulation, one of each class of translated tetrahedra, with
// their neighbours. The list has numbers alone; corners are read from the triangulation of the box
// and its halo.
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
    // A tetrahedron with its neighbours.
    struct Record {
        Tetrahedron tetrahedron;
        Neighbor neighbors[4];
    };

    // The halo has to stay as it is.
    PeriodicTetrahedra(Allocator& allocator, const Halo& halo);

    std::size_t size() const { return slots_.size(); }
    Tetrahedron operator[](std::size_t i) const;
    Record record(std::size_t i) const;
    // Calls visit(i, tetrahedron or record) for all in turn. This is faster than single calls.
    template <class Visit>
    void each_tetrahedron(const Visit& visit) const {
        for (std::size_t i = 0; i < size(); ++i) {
            prefetch(i);
            visit(i, (*this)[i]);
        }
    }
    template <class Visit>
    void each_record(const Visit& visit) const {
        for (std::size_t i = 0; i < size(); ++i) {
            prefetch(i);
            visit(i, record(i));
        }
    }

  private:
    // A side whose neighbour in the mesh is not a representative.
    struct Crossing {
        std::uint64_t side;  // four times the number of the tetrahedron, plus the corner
        Neighbor neighbor;
    };
    const Mesh& mesh() const { return halo_.triangulation().mesh(); }
    void prefetch(std::size_t i) const;
    unsigned first_position(TetId slot) const;
    Tetrahedron read(TetId slot, std::uint8_t (&positions)[4]) const;
    void find(Buffer<std::uint32_t>& begin);
    void sort(const Buffer<std::uint32_t>& begin);
    void find_crossings();

    const Halo& halo_;
    Buffer<TetId> slots_;  // where the mesh has the tetrahedra
    Buffer<std::uint32_t> number_of_slot_;
    Buffer<Crossing> crossings_;  // sorted by their sides
};

}  // namespace mgdt
