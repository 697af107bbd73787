// SPDX-License-Identifier: MIT
// The tetrahedra of a part as its program takes them: with the numbers that vertices and tetrahedra
// have among those of all parts.
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

    // Those with a corner that is the part's own. Returns how many it owns; of these `first` is the
    // number of the first. at_border: those that it owns and that have corners of others.
    std::size_t list(const Part& part, PartId self, std::int64_t first,
                     Buffer<std::size_t>* at_border = nullptr);
    void forget();
    // Those that the part owns come first, and their numbers follow one another.
    std::size_t size() const { return slots_.size(); }
    std::size_t owned() const { return owned_; }
    // The points of others that are corners of these, in ascending order of their numbers.
    const Buffer<std::uint32_t>& ghosts() const { return ghosts_; }
    std::int64_t number(std::size_t i) const {
        return i < owned_ ? first_ + static_cast<std::int64_t>(i) : numbers_[i - owned_];
    }
    PartId owner(std::size_t i) const { return i < owned_ ? self_ : owners_[i - owned_]; }
    // The corners of each in turn, positively oriented, as points of the part.
    void corners(const Part& part, std::size_t i, std::uint32_t (&v)[4]) const {
        const Mesh& mesh = part.triangulation().mesh();
        for (int k = 0; k < 4; ++k) v[k] = mesh.vertices[mesh.tetrahedra[slots_[i]].v[k]].index;
    }
    // 4 numbers of vertices for each.
    void get_vertices(const Part& part, std::int64_t* vertices) const;
    // 4 places for each: of the part's own points and its ghosts, in their order.
    void get_places(const Part& part, std::int64_t* places) const;
    // 4 numbers of tetrahedra for each owned one, opposite the vertices, or -1.
    void get_neighbors(const Part& part, std::int64_t* neighbors) const;

    // Whether all that was found is the same.
    bool is_like(const PartTetrahedra& other) const;

  private:
    friend class TetrahedraFinder;
    std::size_t index_of_owned(TetId slot) const;
    // A facet of an owned one that others had to be asked about: its place among the neighbours.
    struct Across {
        std::uint64_t side;
        std::int64_t number;
    };
    PartId self_ = 0;
    std::size_t owned_ = 0;
    std::int64_t first_ = 0;
    Buffer<TetId> slots_;
    Buffer<std::int64_t> numbers_;  // of those that others own
    Buffer<PartId> owners_;
    Buffer<Across> across_;  // by side
    Buffer<std::uint32_t> ghosts_;
};

// Collective. Those of the local parts, whose triangulations are finished; the tetrahedra that
// part p owns have the numbers from first[p] to before first[p + 1].
void find_tetrahedra(Collective& all, const Homes& homes, const Objects<Part>& parts,
                     Objects<PartTetrahedra>& found, Buffer<std::int64_t>& first,
                     Allocator& allocator);

}  // namespace mgdt
