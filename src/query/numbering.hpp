// SPDX-License-Identifier: MIT
// The numbers of finite tetrahedra that callers see: 0, 1, ... in the order of storage, or in
// canonical order, which depends on the points alone.
#pragma once

#include <cassert>

#include "mesh/mesh.hpp"
#include "parallel/team.hpp"
#include "platform/compiler.hpp"

namespace mgdt {

inline unsigned popcount(std::uint64_t x) noexcept {
    x -= (x >> 1) & 0x5555555555555555u;
    x = (x & 0x3333333333333333u) + ((x >> 2) & 0x3333333333333333u);
    x = (x + (x >> 4)) & 0x0F0F0F0F0F0F0F0Fu;
    return static_cast<unsigned>((x * 0x0101010101010101u) >> 56);
}

// The slots of all ghosts, found by traversal of their neighbours. is_new(t) returns true when it
// is called with t for the first time.
template <class IsNew>
Buffer<TetId> ghosts_of(const Mesh& mesh, Allocator& allocator, IsNew is_new) {
    Buffer<TetId> ghosts(allocator);
    if (mesh.live_count() == 0) return ghosts;
    // The loop is branchless, since whether a ghost is new cannot be predicted. It writes every
    // ghost that it meets, so the array has one more element, for a ghost that is not new.
    ghosts.resize(mesh.ghost_count + 1);
    std::size_t size = 0;
    const auto push = [&](TetId t) {
        assert(size <= mesh.ghost_count && "more ghosts than were counted");
        ghosts[size] = t;
        size += is_new(t) ? 1 : 0;
    };
    push(mesh.a_ghost);
    for (std::size_t i = 0; i < size; ++i) {
        const Tetrahedron& t = mesh.tetrahedra[ghosts[i]];
        push(tetrahedron_of(t.n[0]));
        push(tetrahedron_of(t.n[1]));
        push(tetrahedron_of(t.n[t.infinite_slot() ^ 1]));  // of 2 and 3, the facet at infinity
    }
    assert(size == mesh.ghost_count && "fewer ghosts than were counted");
    ghosts.resize(size);
    return ghosts;
}

class Numbering {
  public:
    // Up to this many slots, numbers are stored by slot: the array fits into the second-level
    // cache. For more slots a bitmap is faster, unless one in eight of its words has ghosts or free
    // slots.
    static constexpr std::size_t few_slots = 131072;
    Numbering(Allocator& allocator, const Mesh& mesh, bool canonical, Team& team,
              std::size_t few = few_slots);

    bool is_canonical() const noexcept { return is_canonical_; }
    // Two function objects that give the number of a finite tetrahedron, or -1 for any other slot.
    // Loops choose one of them once.
    struct BySlot {
        MGDT_ALWAYS_INLINE std::int32_t operator()(TetId t) const noexcept { return numbers[t]; }
        const std::int32_t* numbers;
    };
    struct ByBits {
        MGDT_ALWAYS_INLINE std::int32_t operator()(TetId t) const noexcept {
            const std::uint32_t rank = ranks[t >> 6], position = t & 63;
            if (MGDT_UNLIKELY((rank & gaps) != 0)) return among_gaps(t);
            return static_cast<std::int32_t>(rank + position);
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
    BySlot by_slot() const noexcept {
        assert(is_by_slot() && "numbers are found by bits");
        return {by_slot_.data()};
    }
    ByBits by_bits() const noexcept { return {bits_.data(), ranks_.data()}; }
    MGDT_ALWAYS_INLINE std::int32_t number(TetId t) const noexcept {
        assert((t >> 6) < bits_.size() && "there is no such slot");
        return is_by_slot() ? by_slot()(t) : by_bits()(t);
    }
    // A stretch is 64 consecutive slots. for_each() calls f(t, number) for the finite tetrahedra of
    // stretches begin..end-1, in the order of storage.
    std::size_t stretches() const noexcept { return bits_.size(); }
    template <class F>
    void for_each(std::size_t begin, std::size_t end, F f) const {
        for_each_run(begin, end, [&](TetId first, TetId last, std::size_t number) {
            for (TetId t = first; t < last; ++t, ++number)
                f(t, is_canonical() ? static_cast<std::size_t>(by_slot_[t]) : number);
        });
    }
    // Calls f(first, end, number) for each run of slots first..end-1 with finite tetrahedra.
    // `number` is the number of the first one, unless numbers are canonical.
    template <class F>
    void for_each_run(std::size_t begin, std::size_t end, F f) const;
    // The positions of a tetrahedron's vertices in its canonical record, which is sorted by
    // indices[vertex].
    template <class Indices>
    static void canonical_positions(const Tetrahedron& t, const Indices& indices,
                                    unsigned positions[4]);

  private:
    void sort(const Mesh& mesh, Team& team);

    // A flag in a rank: some slots of the word have no finite tetrahedra. Few words have this flag,
    // so most look-ups read the rank alone, and the ranks fit into the second-level cache.
    static constexpr std::uint32_t gaps = 1u << 31;
    static_assert(max_tetrahedra <= gaps);

    Buffer<std::uint64_t> bits_;  // which slots have finite tetrahedra
    Buffer<std::uint32_t>
        ranks_;  // for each word of bits_: the number of its first tetrahedron, and `gaps`
    Buffer<std::int32_t>
        by_slot_;  // numbers by slot, if canonical, or if slots are few or gaps many
    const bool is_canonical_;
};

template <class F>
void Numbering::for_each_run(std::size_t begin, std::size_t end, F f) const {
    assert(begin <= end && end <= bits_.size() && "stretches beyond the last");
    if (begin == end) return;
    constexpr std::uint64_t all = ~std::uint64_t{0};
    std::size_t number = ranks_[begin] & ~gaps;
    for (std::size_t word = begin; word < end;) {
        const TetId slot = static_cast<TetId>(word * 64);
        std::uint64_t bits = bits_[word++];
        while (bits != 0) {
            const TetId first = slot + lowest_bit(bits);
            bits |= bits - 1;  // sets the bits of the word before this run
            TetId last = slot + 64;
            if (bits != all) {
                last = slot + lowest_bit(~bits);
                bits &= bits + 1;
            } else {
                for (; word < end && bits_[word] == all; ++word) last += 64;
                bits = 0;
            }
            f(first, last, number);
            number += last - first;
        }
    }
}

template <class Indices>
void Numbering::canonical_positions(const Tetrahedron& t, const Indices& indices,
                                    unsigned positions[4]) {
    std::uint32_t index[4];
    for (unsigned i = 0; i < 4; ++i) index[i] = indices[t.v[i]];
    unsigned first = 0;
    for (unsigned i = 1; i < 4; ++i)
        if (index[i] < index[first]) first = i;
    // The other three vertices in an order that keeps the orientation: (first, a, b, c) is an even
    // permutation of (0, 1, 2, 3). They are rotated below, so that the least index comes first.
    static constexpr unsigned char others[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    const unsigned char* rest = others[first];
    unsigned turn = 0;
    for (unsigned i = 1; i < 3; ++i)
        if (index[rest[i]] < index[rest[turn]]) turn = i;
    positions[0] = first;
    for (unsigned i = 0; i < 3; ++i) positions[i + 1] = rest[(turn + i) % 3];
}

}  // namespace mgdt
