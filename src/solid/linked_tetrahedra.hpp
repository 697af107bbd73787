// SPDX-License-Identifier: MIT
// Tetrahedra with links to their neighbours, and the facets that their faces are parts of.
#pragma once

#include "mesh/tetrahedron.hpp"
#include "platform/memory.hpp"

namespace mgdt {

// Face i of tetrahedron t is opposite its corner i and has the code 4 t + i. There are no ghosts:
// behind a face of the hull is no_index.
struct LinkedTetrahedra {
    struct Tetrahedron {
        std::uint32_t v[4];       // points, positively oriented; v[0] is no_index if it is dead
        std::uint32_t n[4];       // the codes of the faces on the other sides
        std::uint32_t facets[4];  // the facet that each face is a part of, or no_index

        bool is_dead() const noexcept { return v[0] == no_index; }
        unsigned position(std::uint32_t point) const noexcept {
            unsigned i = 0;
            while (v[i] != point) ++i;
            return i;
        }
        bool has(std::uint32_t point) const noexcept {
            return v[0] == point || v[1] == point || v[2] == point || v[3] == point;
        }
    };

    explicit LinkedTetrahedra(Allocator& allocator)
        : tetrahedra(allocator),
          free_slots(allocator),
          hints(allocator),
          star_(allocator),
          stamp_(allocator) {}

    Tetrahedron& of(std::uint32_t face) noexcept { return tetrahedra[face / 4]; }
    const Tetrahedron& of(std::uint32_t face) const noexcept { return tetrahedra[face / 4]; }
    // The corner opposite a face.
    std::uint32_t apex(std::uint32_t face) const noexcept { return of(face).v[face % 4]; }

    // A tetrahedron with the edge between two points, or no_tetrahedron.
    std::uint32_t tetrahedron_at(std::uint32_t a, std::uint32_t b) {
        return find_at(a, [&](std::uint32_t t) { return tetrahedra[t].has(b); });
    }
    // The first of the tetrahedra at a point for which is_wanted(t) is true, or no_tetrahedron.
    template <class IsWanted>
    std::uint32_t find_at(std::uint32_t point, const IsWanted& is_wanted);

    // Makes two faces neighbours. The second one may be no_index.
    void join(std::uint32_t face, std::uint32_t other) noexcept {
        of(face).n[face % 4] = other;
        if (other != no_index) of(other).n[other % 4] = face;
    }
    // Marks a face, on both sides, as a part of a facet.
    void mark(std::uint32_t face, std::uint32_t facet) noexcept {
        of(face).facets[face % 4] = facet;
        if (const std::uint32_t other = of(face).n[face % 4]; other != no_index)
            of(other).facets[other % 4] = facet;
    }
    // Adds a tetrahedron and returns its number. Its faces have no neighbours and are parts of no
    // facet.
    std::uint32_t add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
    void remove(std::uint32_t tetrahedron);
    // The number of a free slot, or of a new one, which is to be filled.
    std::uint32_t take_slot();

    Buffer<Tetrahedron> tetrahedra;
    Buffer<std::uint32_t> free_slots;
    Buffer<std::uint32_t> hints;  // a tetrahedron of each point, or no_tetrahedron

  private:
    Buffer<std::uint32_t> star_;   // working memory of find_at()
    Buffer<std::uint32_t> stamp_;  // the last search that has visited each tetrahedron
    std::uint32_t search_ = 0;
};

template <class IsWanted>
std::uint32_t LinkedTetrahedra::find_at(std::uint32_t point, const IsWanted& is_wanted) {
    if (hints[point] == no_tetrahedron) return no_tetrahedron;
    stamp_.grow(tetrahedra.size());
    stamp_.resize(tetrahedra.size(), 0u);
    ++search_;
    star_.clear();
    star_.push_back(hints[point]);
    stamp_[hints[point]] = search_;
    for (std::size_t i = 0; i < star_.size(); ++i) {
        if (is_wanted(star_[i])) return star_[i];
        const Tetrahedron& t = tetrahedra[star_[i]];
        for (unsigned k = 0; k < 4; ++k) {
            const std::uint32_t next = t.n[k];
            if (t.v[k] == point || next == no_index || stamp_[next / 4] == search_) continue;
            stamp_[next / 4] = search_;
            star_.push_back(next / 4);
        }
    }
    return no_tetrahedron;
}

}  // namespace mgdt
