// SPDX-License-Identifier: MIT
// The numbers that finite tetrahedra have outside: 0, 1, ... in the order of storage, or in
// canonical order, which depends on the points alone.
#pragma once

#include "mesh/mesh.hpp"
#include "parallel/team.hpp"
#include "platform/cpu.hpp"

namespace mgdt {

inline unsigned popcount(std::uint64_t x) noexcept {
    x -= (x >> 1) & 0x5555555555555555u;
    x = (x & 0x3333333333333333u) + ((x >> 2) & 0x3333333333333333u);
    x = (x + (x >> 4)) & 0x0F0F0F0F0F0F0F0Fu;
    return static_cast<unsigned>((x * 0x0101010101010101u) >> 56);
}

// The slots of all ghosts, which are reached from one another. is_new(t) is true when it is asked
// for the first time.
template <class IsNew>
Buffer<TetId> ghosts_of(const Mesh& mesh, Allocator& allocator, IsNew is_new) {
    Buffer<TetId> ghosts(allocator);
    if (mesh.live_count() == 0) return ghosts;
    ghosts.reserve(mesh.ghost_count);
    const auto push = [&](TetId t) {
        if (is_new(t)) ghosts.push_back(t);
    };
    push(mesh.a_ghost);
    for (std::size_t i = 0; i < ghosts.size(); ++i) {
        const Tetrahedron& t = mesh.tetrahedra[ghosts[i]];
        const int slot = t.infinite_slot();
        for (int f = 0; f < 4; ++f)
            if (f != slot) push(t.n[f] >> 2);
    }
    return ghosts;
}

class Numbering {
  public:
    // In a small set there are ghosts everywhere, and numbers by slot stay in the second cache.
    static constexpr std::size_t few_slots = 131072;
    Numbering(Allocator& allocator, const Mesh& mesh, bool canonical, Team& team,
              std::size_t few = few_slots);

    bool is_canonical() const noexcept { return is_canonical_; }
    // The number of a finite tetrahedron, -1 of any other slot: two ways to look it up, for loops
    // that do so by one of them.
    struct BySlot {
        MGDT_ALWAYS_INLINE std::int32_t operator()(TetId t) const noexcept { return numbers[t]; }
        const std::int32_t* numbers;
    };
    struct ByBits {
        MGDT_ALWAYS_INLINE std::int32_t operator()(TetId t) const noexcept {
            const std::uint32_t rank = ranks[t >> 6], place = t & 63;
            if (MGDT_UNLIKELY((rank & gaps) != 0)) return among_gaps(t);
            return static_cast<std::int32_t>(rank + place);
        }
        std::int32_t among_gaps(TetId t) const noexcept {
            const std::size_t word = t >> 6;
            const std::uint64_t bit = std::uint64_t{1} << (t & 63);
            if ((bits[word] & bit) == 0) return -1;
            return static_cast<std::int32_t>((ranks[word] & ~gaps) +
                                             popcount(bits[word] & (bit - 1)));
        }
        const std::uint64_t* bits;
        const std::uint32_t* ranks;
    };
    bool is_by_slot() const noexcept { return !by_slot_.empty(); }
    BySlot by_slot() const noexcept { return {by_slot_.data()}; }
    ByBits by_bits() const noexcept { return {bits_.data(), ranks_.data()}; }
    MGDT_ALWAYS_INLINE std::int32_t number(TetId t) const noexcept {
        return is_by_slot() ? by_slot()(t) : by_bits()(t);
    }
    // Calls f(t, number) for the finite tetrahedra of some of the stretches of 64 slots that the
    // storage is made of, in the order of storage.
    std::size_t stretches() const noexcept { return bits_.size(); }
    // Where they are not canonical: the first number of a stretch.
    std::size_t first_number(std::size_t stretch) const noexcept { return ranks_[stretch] & ~gaps; }
    template <class F>
    void for_each(std::size_t begin, std::size_t end, F f) const {
        if (is_canonical())
            for_each_slot(begin, end,
                          [&](TetId t) { f(t, static_cast<std::size_t>(by_slot_[t])); });
        else if (begin < end)
            for_each_slot(begin, end,
                          [&, number = first_number(begin)](TetId t) mutable { f(t, number++); });
    }
    // The places of a tetrahedron's vertices in its exported record, indices[vertex] deciding.
    template <class Indices>
    static void canonical_places(const Tetrahedron& t, const Indices& indices, unsigned places[4]);

  private:
    void sort(const Mesh& mesh, Team& team);

    template <class F>
    void for_each_slot(std::size_t begin, std::size_t end, F f) const {
        for (std::size_t word = begin; word < end; ++word) {
            const TetId first = static_cast<TetId>(word * 64);
            if (bits_[word] == ~std::uint64_t{0})
                for (TetId t = first; t < first + 64; ++t) f(t);
            else
                for (std::uint64_t bits = bits_[word]; bits != 0; bits &= bits - 1)
                    f(first + lowest_bit(bits));
        }
    }
    // In a rank, that some slots of its word hold no finite tetrahedra. Few words have such, so
    // that ranks alone are looked at, and fit the second cache.
    static constexpr std::uint32_t gaps = 1u << 31;
    static_assert(max_tetrahedra <= gaps);

    Buffer<std::uint64_t> bits_;    // which slots hold finite tetrahedra
    Buffer<std::uint32_t> ranks_;   // number of the first of each word of bits_, and gaps
    Buffer<std::int32_t> by_slot_;  // numbers: canonical ones, or where slots are few
    const bool is_canonical_;
};

template <class Indices>
void Numbering::canonical_places(const Tetrahedron& t, const Indices& indices, unsigned places[4]) {
    std::uint32_t index[4];
    for (unsigned i = 0; i < 4; ++i) index[i] = indices[t.v[i]];
    unsigned first = 0;
    for (unsigned i = 1; i < 4; ++i)
        if (index[i] < index[first]) first = i;
    // The other three in the order that keeps the orientation, turned so that their least leads:
    // (first, a, b, c) is an even permutation of (0, 1, 2, 3).
    static constexpr unsigned char others[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    const unsigned char* rest = others[first];
    unsigned turn = 0;
    for (unsigned i = 1; i < 3; ++i)
        if (index[rest[i]] < index[rest[turn]]) turn = i;
    places[0] = first;
    for (unsigned i = 0; i < 3; ++i) places[i + 1] = rest[(turn + i) % 3];
}

}  // namespace mgdt
