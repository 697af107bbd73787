// SPDX-License-Identifier: MIT
// The edges of the tetrahedra, as one list for each vertex.
#pragma once

#include <algorithm>
#include <cstdint>

#include "parallel/team_lists.hpp"
#include "platform/error.hpp"
#include "query/mesh_view.hpp"

namespace mgdt {

// Edge e of a tetrahedron joins its vertices edge_ends[e][0] and [1].
inline constexpr unsigned char edge_ends[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

// A table: for each set of faces, the set of edges that lie in two of them. Sets are bit masks. An
// edge lies in the two faces that are opposite the vertices that it does not join.
struct EdgesBetween {
    unsigned char of_faces[16] = {};
    constexpr EdgesBetween() {
        for (unsigned faces = 0; faces < 16; ++faces)
            for (unsigned e = 0; e < 6; ++e) {
                const unsigned both = 0xFu & ~(1u << edge_ends[e][0] | 1u << edge_ends[e][1]);
                if ((faces & both) == both)
                    of_faces[faces] = static_cast<unsigned char>(of_faces[faces] | 1u << e);
            }
    }
};
inline constexpr EdgesBetween edges_between;

// The edges of a face. Each of them lies in this face and in one other face.
constexpr unsigned edges_of_face(unsigned face) {
    unsigned edges = 0;
    for (unsigned other = 0; other < 4; ++other)
        if (other != face) edges |= edges_between.of_faces[1u << face | 1u << other];
    return edges;
}

// The edges that a tetrahedron emits: an edge is emitted if both neighbours across the faces at the
// edge are in later slots. Edges to the vertex at infinity are left out.
inline unsigned owned_edges(const Tetrahedron& t, TetId id) {
    if (t.is_dead()) return 0;
    unsigned later = 0;
    for (unsigned f = 0; f < 4; ++f) later |= (tetrahedron_of(t.n[f]) > id ? 1u : 0u) << f;
    const unsigned edges = edges_between.of_faces[later];
    return t.is_ghost() ? edges & edges_of_face(static_cast<unsigned>(t.infinite_slot())) : edges;
}

// Calls f(a, b) for edges of the tetrahedra in slots begin..end-1, where a and b are the names of
// the ends. Of the tetrahedra around an edge, the one in the first slot always emits the edge, and
// others rarely do. So every edge is emitted, and few edges are emitted twice. For each
// tetrahedron, only its own record is read.
template <class Name, class F>
void for_each_edge(const Mesh& mesh, std::size_t begin, std::size_t end, Name name, F f) {
    constexpr std::size_t ahead = 32;
    for (std::size_t id = begin; id < end; ++id) {
        const Tetrahedron& t = mesh.tetrahedra[id];
        mesh.tetrahedra.prefetch(id + ahead);
        for (unsigned left = owned_edges(t, static_cast<TetId>(id)); left != 0; left &= left - 1) {
            const unsigned char* const at = edge_ends[lowest_bit(left)];
            f(name(t.v[at[0]]), name(t.v[at[1]]));
        }
    }
}

// Returns an `each` for EdgeLists that emits each edge under the lesser of the names of its ends.
template <class Name>
auto edges_from_lesser(const Mesh& mesh, Name name) {
    return [&mesh, name](std::size_t begin, std::size_t end, auto f) {
        for_each_edge(mesh, begin, end, name,
                      [&](std::uint32_t a, std::uint32_t b) { f(std::min(a, b), std::max(a, b)); });
    };
}

// For each of `keys` names, the sorted list of the names at the other ends of its edges, without
// repeats.
class EdgeLists {
  public:
    // each(begin, end, f) calls f(key, other) for the edges that slots begin..end-1 emit.
    template <class Each>
    EdgeLists(const MeshView& view, std::size_t keys, Each each)
        : team_(view.team),
          keys_(keys),
          ends_(view.allocator, keys + 1),
          others_(view.allocator),
          sizes_(view.allocator, keys) {
        constexpr std::size_t min_items_per_thread = 65536;
        require_few(view.mesh.tetrahedra.size(), each);
        make_lists(
            view.team, view.allocator, view.mesh.tetrahedra.size(), min_items_per_thread, keys,
            ends_.data(), each, [&](std::size_t size) { others_.resize(size); },
            [&](std::size_t position, std::uint32_t other) { others_[position] = other; });
        set_sizes([&](std::size_t k) {
            std::uint32_t* const first = others_.begin() + ends_[k];
            std::uint32_t* const last = others_.begin() + ends_[k + 1];
            std::sort(first, last);
            return std::unique(first, last) - first;
        });
    }

    // Removes from the list of each key the names that the list of this key in `other` has.
    void subtract(const EdgeLists& other) {
        set_sizes([&](std::size_t k) {
            std::uint32_t* const first = others_.begin() + ends_[k];
            const std::uint32_t* out = other.others_.begin() + other.ends_[k];
            const std::uint32_t* const out_end = out + other.sizes_[k];
            std::uint32_t* to = first;
            for (const std::uint32_t* from = first; from != first + sizes_[k]; ++from) {
                while (out != out_end && *out < *from) ++out;
                if (out == out_end || *out != *from) *to++ = *from;
            }
            return to - first;
        });
    }

    // The total length of all lists.
    std::size_t size() const noexcept { return position_of_[Team::most]; }

    // Calls write(key, position, others, size) for the list of each key, on several threads at the
    // same time. The list begins at position `position` of the concatenation of all lists.
    template <class Write>
    void write(Write write) const {
        team_.split(keys_, keys_per_thread, [&](std::size_t begin, std::size_t end, unsigned m) {
            std::size_t position = position_of_[m];
            for (std::size_t k = begin; k < end; ++k) {
                write(k, position, others_.begin() + ends_[k], std::size_t{sizes_[k]});
                position += sizes_[k];
            }
        });
    }

  private:
    // Requires that the entries fit, since positions in the lists have 32 bits. At most half of the
    // tetrahedra around an edge emit the edge, so a slot emits at most three edges on average, or
    // six entries if each edge is listed at both ends.
    template <class Each>
    static void require_few(std::size_t slots, Each each) {
        constexpr std::uint64_t most = 0xFFFFFFFFu;
        if (6 * std::uint64_t{slots} < most) return;
        std::uint64_t count = 0;
        each(std::size_t{0}, slots, [&](std::uint32_t, std::uint32_t) { ++count; });
        if (count >= most)
            fail(MGDT_ERR_TOO_LARGE, "more than 2^32 ends of edges are to be sorted");
    }

    template <class Size>
    void set_sizes(Size size) {
        std::fill_n(position_of_, Team::most + 1, std::size_t{0});
        team_.split(keys_, keys_per_thread, [&](std::size_t begin, std::size_t end, unsigned m) {
            std::size_t sum = 0;
            for (std::size_t k = begin; k < end; ++k) {
                sizes_[k] = static_cast<std::uint32_t>(size(k));
                sum += sizes_[k];
            }
            position_of_[m + 1] = sum;
        });
        for (unsigned m = 0; m < Team::most; ++m) position_of_[m + 1] += position_of_[m];
    }

    static constexpr std::size_t keys_per_thread = 16384;

    Team& team_;
    std::size_t keys_;
    Buffer<std::uint32_t> ends_, others_, sizes_;
    std::size_t position_of_[Team::most + 1] = {};  // the position of the first list of each thread
};

}  // namespace mgdt
