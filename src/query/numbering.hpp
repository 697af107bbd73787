// SPDX-License-Identifier: MIT
// The numbers that finite tetrahedra have outside: 0, 1, ... in the order of storage, or in
// canonical order, which depends on the points alone.
#pragma once

#include "mesh/mesh.hpp"

namespace mgdt {

class Numbering {
  public:
    Numbering(Allocator& allocator, const Mesh& mesh, bool canonical);

    std::size_t size() const noexcept { return size_; }
    bool is_canonical() const noexcept { return !order_.empty(); }
    bool is_finite(TetId t) const noexcept { return (bits_[t >> 6] >> (t & 63) & 1) != 0; }
    // Number of a finite tetrahedron.
    std::size_t rank(TetId t) const noexcept {
        if (is_canonical()) return rank_[t];
        const std::size_t word = t >> 6;
        // Nearly all words are full: what is missing below is counted instead of what is there.
        const std::uint64_t missing = ~bits_[word] & ((std::uint64_t{1} << (t & 63)) - 1);
        const std::size_t rank = ranks_[word] + std::size_t{t & 63};
        return MGDT_UNLIKELY(missing != 0) ? rank - static_cast<std::size_t>(popcount(missing))
                                           : rank;
    }
    // Calls f(t) for the finite tetrahedra in the order of their numbers.
    template <class F>
    void for_each(F f) const {
        for_each(0, stretches(), f);
    }
    // The same for some of the stretches that the order is made of, each of 64 at most.
    std::size_t stretches() const noexcept {
        return is_canonical() ? (order_.size() + 63) / 64 : bits_.size();
    }
    std::size_t first_number(std::size_t stretch) const noexcept {
        return is_canonical() ? stretch * 64 : ranks_[stretch];
    }
    template <class F>
    void for_each(std::size_t begin, std::size_t end, F f) const {
        if (is_canonical()) {
            const std::size_t last = end * 64 < order_.size() ? end * 64 : order_.size();
            for (std::size_t i = begin * 64; i < last; ++i) f(order_[i]);
            return;
        }
        for (std::size_t word = begin; word < end; ++word) {
            const TetId first = static_cast<TetId>(word * 64);
            if (bits_[word] == ~std::uint64_t{0})
                for (TetId t = first; t < first + 64; ++t) f(t);
            else
                for (std::uint64_t bits = bits_[word]; bits != 0; bits &= bits - 1)
                    f(first + static_cast<TetId>(lowest(bits)));
        }
    }
    // The places of a tetrahedron's vertices in its exported record.
    static void canonical_places(const Mesh& mesh, const Tetrahedron& t, unsigned places[4]);

  private:
    void sort(const Mesh& mesh);

    static int popcount(std::uint64_t x) noexcept {
        x -= (x >> 1) & 0x5555555555555555u;
        x = (x & 0x3333333333333333u) + ((x >> 2) & 0x3333333333333333u);
        x = (x + (x >> 4)) & 0x0F0F0F0F0F0F0F0Fu;
        return static_cast<int>((x * 0x0101010101010101u) >> 56);
    }
    static int lowest(std::uint64_t x) noexcept { return popcount((x & (~x + 1)) - 1); }

    Buffer<std::uint64_t> bits_;   // which slots hold finite tetrahedra
    Buffer<std::uint32_t> ranks_;  // number of the first of each word of bits_
    Buffer<TetId> order_;          // canonical only: by number
    Buffer<std::uint32_t> rank_;   // canonical only: by slot
    std::size_t size_ = 0;
};

}  // namespace mgdt
