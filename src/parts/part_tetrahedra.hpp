// SPDX-License-Identifier: MIT
// The tetrahedra of a part as callers see them, with global numbers of vertices and tetrahedra.
#pragma once

#include "parts/collective.hpp"
#include "parts/part.hpp"

namespace mgdt {

class PartTetrahedra {
  public:
    explicit PartTetrahedra(Allocator& allocator)
        : slots_(allocator),
          numbers_(allocator),
          owners_(allocator),
          across_(allocator),
          ghosts_(allocator) {}

    // Finds the tetrahedra with a corner among the part's own points. Returns the number of
    // tetrahedra that the part owns, which are numbered from `first` on. `at_border` gets the
    // positions of the owned tetrahedra that have corners of other parts.
    std::size_t list(const Part& part, PartId self, std::int64_t first,
                     Buffer<std::size_t>* at_border = nullptr);
    void forget();
    // The tetrahedra that the part owns come first, and have consecutive numbers.
    std::size_t size() const { return slots_.size(); }
    std::size_t owned() const { return owned_; }
    // The points of other parts that are corners of the part's tetrahedra, as indices of the part's
    // points, sorted by number.
    const Buffer<std::uint32_t>& ghosts() const { return ghosts_; }
    std::int64_t number(std::size_t i) const {
        return i < owned_ ? first_ + static_cast<std::int64_t>(i) : numbers_[i - owned_];
    }
    PartId owner(std::size_t i) const { return i < owned_ ? self_ : owners_[i - owned_]; }
    // The corners of tetrahedron i, positively oriented, as indices of the part's points.
    void corners(const Part& part, std::size_t i, std::uint32_t (&v)[4]) const {
        const Mesh& mesh = part.triangulation().mesh();
        for (int k = 0; k < 4; ++k) v[k] = mesh.vertices[mesh.tetrahedra[slots_[i]].v[k]].index;
    }
    // The global numbers of the 4 corners of each tetrahedron.
    void get_vertices(const Part& part, std::int64_t* vertices) const;
    // The 4 corners of each tetrahedron as positions among the part's own vertices and its ghosts.
    void get_positions(const Part& part, std::int64_t* positions) const;
    // For each owned tetrahedron, the numbers of the 4 tetrahedra opposite its vertices. The number
    // is -1 at a hull facet.
    void get_neighbors(const Part& part, std::int64_t* neighbors) const;

    // Whether `other` has the same tetrahedra and numbers. Parts::check() calls this.
    bool is_like(const PartTetrahedra& other) const;

  private:
    friend class TetrahedraFinder;
    std::size_t index_of_owned(TetId slot) const;
    // A facet of an owned tetrahedron, beyond which this part owns no tetrahedron. `side` is the
    // position in the result of get_neighbors(), `number` is the value there.
    struct Across {
        std::uint64_t side;
        std::int64_t number;
    };
    PartId self_ = 0;
    std::size_t owned_ = 0;
    std::int64_t first_ = 0;
    Buffer<TetId> slots_;
    Buffer<std::int64_t> numbers_;  // the numbers of the tetrahedra that other parts own
    Buffer<PartId> owners_;
    Buffer<Across> across_;  // sorted by `side`
    Buffer<std::uint32_t> ghosts_;
};

// Collective. Finds the tetrahedra of the local parts, whose triangulations are finished. The
// tetrahedra that part p owns have the numbers first[p] to first[p + 1] - 1.
void find_tetrahedra(Collective& all, const Homes& homes, const Objects<Part>& parts,
                     Objects<PartTetrahedra>& found, Buffer<std::int64_t>& first,
                     Allocator& allocator);

}  // namespace mgdt
