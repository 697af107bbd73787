// SPDX-License-Identifier: MIT
#include "query/numbering.hpp"

#include <algorithm>

namespace mgdt {

Numbering* Numbering::make(Allocator& allocator, const Mesh& mesh, bool canonical) {
    void* memory = allocator.allocate(sizeof(Numbering), alignof(Numbering));
    Numbering* made = new (memory) Numbering(allocator);
    try {
        const std::size_t slots = mesh.tetrahedra.size(), words = (slots + 63) / 64;
        made->bits_.resize(words, 0);
        made->ranks_.resize(words);
        for (std::size_t word = 0; word < words; ++word) {
            made->ranks_[word] = static_cast<std::uint32_t>(made->size_);
            std::uint64_t bits = 0;
            const std::size_t end = std::min(slots, word * 64 + 64);
            for (std::size_t t = word * 64; t < end; ++t) {
                const Tetrahedron& tet = mesh.tetrahedra[t];
                const bool finite = !tet.is_dead() && !tet.is_ghost();
                bits |= static_cast<std::uint64_t>(finite) << (t & 63);
            }
            made->bits_[word] = bits;
            made->size_ += static_cast<std::size_t>(popcount(bits));
        }
        if (canonical && made->size_ != 0) made->sort(mesh);
    } catch (...) {
        destroy(allocator, made);
        throw;
    }
    return made;
}

void Numbering::destroy(Allocator& allocator, Numbering* numbering) noexcept {
    numbering->~Numbering();
    allocator.release(numbering, sizeof(Numbering), alignof(Numbering));
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
