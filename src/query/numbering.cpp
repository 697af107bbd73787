// SPDX-License-Identifier: MIT
#include "query/numbering.hpp"

#include <algorithm>

namespace mgdt {

// All slots but the free ones and the ghosts, which are reached from one another: no pass over the
// records.
Numbering::Numbering(Allocator& allocator, const Mesh& mesh, bool canonical)
    : bits_(allocator), ranks_(allocator), order_(allocator), rank_(allocator) {
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
    if (mesh.live_count() != 0) {
        Buffer<TetId> ghosts(allocator);
        ghosts.reserve(mesh.ghost_count);
        const auto push = [&](TetId t) {
            if (take_out(t)) ghosts.push_back(t);
        };
        push(mesh.a_ghost);
        for (std::size_t i = 0; i < ghosts.size(); ++i) {
            const Tetrahedron& t = mesh.tetrahedra[ghosts[i]];
            const int slot = t.infinite_slot();
            for (int f = 0; f < 4; ++f)
                if (f != slot) push(t.n[f] >> 2);
        }
    }
    ranks_.resize(words);
    for (std::size_t word = 0; word < words; ++word) {
        ranks_[word] = static_cast<std::uint32_t>(size_);
        size_ += static_cast<std::size_t>(popcount(bits_[word]));
    }
    if (canonical && size_ != 0) sort(mesh);
}

void Numbering::canonical_places(const Mesh& mesh, const Tetrahedron& t, unsigned places[4]) {
    std::uint32_t index[4];
    for (unsigned i = 0; i < 4; ++i) index[i] = mesh.vertices[t.v[i]].index;
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

void Numbering::sort(const Mesh& mesh) {
    // Buckets by the least index, which is linear; within a bucket there are few.
    struct Key {
        std::uint32_t v[3];
        TetId t;
        bool operator<(const Key& other) const {
            return std::lexicographical_compare(v, v + 3, other.v, other.v + 3);
        }
    };
    Allocator& allocator = bits_.allocator();
    std::uint32_t top = 0;
    for (const Vertex& v : mesh.vertices)
        if (v.index != no_index) top = std::max(top, v.index);
    Buffer<std::uint32_t> ends(allocator);
    ends.resize(std::size_t{top} + 2, 0);
    Buffer<Key> keys(allocator, size_);
    const auto index_at = [&](TetId t, unsigned place) {
        return mesh.vertices[mesh.tetrahedra[t].v[place]].index;
    };
    unsigned places[4];
    for_each([&](TetId t) {
        canonical_places(mesh, mesh.tetrahedra[t], places);
        ++ends[index_at(t, places[0]) + 1u];
    });
    for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
    for_each([&](TetId t) {
        canonical_places(mesh, mesh.tetrahedra[t], places);
        keys[ends[index_at(t, places[0])]++] = {
            {index_at(t, places[1]), index_at(t, places[2]), index_at(t, places[3])}, t};
    });
    std::size_t begin = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        std::sort(keys.begin() + begin, keys.begin() + ends[i]);
        begin = ends[i];
    }
    rank_.resize(mesh.tetrahedra.size());
    Buffer<TetId> order(allocator, size_);
    for (std::size_t i = 0; i < size_; ++i) {
        order[i] = keys[i].t;
        rank_[keys[i].t] = static_cast<std::uint32_t>(i);
    }
    order_ = std::move(order);
}

}  // namespace mgdt
