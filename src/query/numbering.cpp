// SPDX-License-Identifier: MIT
#include "query/numbering.hpp"

#include "query/canonical_sort.hpp"
#include "query/vertex_indices.hpp"

namespace mgdt {

// The finite tetrahedra are in all slots but the free ones and those of ghosts, so the records of
// finite tetrahedra need not be read.
Numbering::Numbering(Allocator& allocator, const Mesh& mesh, bool canonical, Team& team,
                     std::size_t few)
    : bits_(allocator),
      ranks_(allocator),
      by_slot_(allocator),
      is_canonical_(canonical && mesh.finite_count() > 0) {
    const std::size_t slots = mesh.tetrahedra.size(), words = (slots + 63) / 64;
    bits_.resize(words, ~std::uint64_t{0});
    if (slots % 64 != 0) bits_[words - 1] = (std::uint64_t{1} << slots % 64) - 1;
    const auto take_out = [&](TetId t) {
        std::uint64_t& word = bits_[t >> 6];
        const std::uint64_t bit = std::uint64_t{1} << (t & 63);
        const bool was_in = (word & bit) != 0;
        word &= ~bit;
        return was_in;
    };
    for (const TetId t : mesh.free_slots) take_out(t);
    ghosts_of(mesh, allocator, take_out);
    ranks_.resize(words);
    std::uint32_t size = 0;
    std::size_t with_gaps = 0;
    for (std::size_t word = 0; word < words; ++word) {
        const bool is_full = bits_[word] == ~std::uint64_t{0};
        ranks_[word] = is_full ? size : size | gaps;
        with_gaps += is_full ? 0 : 1;
        size += popcount(bits_[word]);
    }
    if (!is_canonical_ && slots > few && with_gaps < words / 8) return;
    by_slot_.resize(slots, -1);
    if (is_canonical_)
        sort(mesh, team);
    else
        for_each_run(0, words, [&](TetId first, TetId last, std::size_t number) {
            std::int32_t* const numbers = by_slot_.data() + first;
            const auto count = static_cast<std::int32_t>(last - first),
                       from = static_cast<std::int32_t>(number);
            for (std::int32_t i = 0; i < count; ++i) numbers[i] = from + i;
        });
}

void Numbering::sort(const Mesh& mesh, Team& team) {
    struct Rest {
        std::uint64_t second_and_third;
        std::uint32_t fourth;
        TetId t;
        bool operator<(const Rest& other) const {
            return second_and_third != other.second_and_third
                       ? second_and_third < other.second_and_third
                       : fourth < other.fourth;
        }
    };
    Allocator& allocator = bits_.allocator();
    const VertexIndices indices(team, mesh, allocator);
    const auto each = [&](std::size_t begin, std::size_t end, auto f) {
        for_each_run(begin, end, [&](TetId first, TetId last, std::size_t) {
            for (TetId id = first; id < last; ++id) {
                const Tetrahedron& t = mesh.tetrahedra[id];
                unsigned positions[4];
                canonical_positions(t, indices, positions);
                const auto index = [&](unsigned i) { return indices[t.v[positions[i]]]; };
                f(index(0), Rest{std::uint64_t{index(1)} << 32 | index(2), index(3), id});
            }
        });
    };
    constexpr std::size_t min_items_per_thread = 1024;
    canonical_sort<Rest>(team, allocator, stretches(), min_items_per_thread, indices.end(), each,
                         [&](std::size_t, std::size_t position, const Rest& rest) {
                             by_slot_[rest.t] = static_cast<std::int32_t>(position);
                         });
}

}  // namespace mgdt
