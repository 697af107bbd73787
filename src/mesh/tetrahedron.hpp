// SPDX-License-Identifier: MIT
// The records of vertices and tetrahedra.
#pragma once

#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#include "platform/compiler.hpp"
#include "platform/no_index.hpp"

namespace mgdt {

using VertexId = std::uint32_t;
using TetId = std::uint32_t;
// A facet of a tetrahedron: 4 times the tetrahedron plus the face, where face i is opposite vertex
// i. A neighbour is stored as the code of the shared facet on the neighbour's side.
using FacetCode = std::uint32_t;

inline constexpr VertexId infinite_vertex = 0;
inline constexpr TetId no_tetrahedron = 0xFFFFFFFFu;
// Facet codes have 32 bits.
inline constexpr std::uint32_t max_tetrahedra = 1u << 30;

MGDT_ALWAYS_INLINE constexpr FacetCode facet_code(TetId t, unsigned face) noexcept {
    assert(t < max_tetrahedra && "a tetrahedron without a facet code");
    assert(face < 4 && "a tetrahedron has four faces");
    return 4 * t + face;
}
MGDT_ALWAYS_INLINE constexpr TetId tetrahedron_of(FacetCode code) noexcept {
    return code >> 2;
}
MGDT_ALWAYS_INLINE constexpr unsigned face_of(FacetCode code) noexcept {
    return code & 3;
}
// The code of face 0. It identifies the tetrahedron as well as its number does.
MGDT_ALWAYS_INLINE constexpr FacetCode first_facet(TetId t) noexcept {
    assert(t < max_tetrahedra && "a tetrahedron without a facet code");
    return 4 * t;
}
MGDT_ALWAYS_INLINE constexpr FacetCode first_facet_of(FacetCode code) noexcept {
    return code & ~3u;
}

// While a cavity is being built, this bit of v[1] marks the tetrahedra in the cavity.
inline constexpr VertexId in_cavity = 0x80000000u;
MGDT_ALWAYS_INLINE constexpr VertexId unmarked(VertexId v) noexcept {
    return v & ~in_cavity;
}

// Half a cache line. Vertex 0 is the vertex at infinity; its coordinates are never used.
struct alignas(32) Vertex {
    double x[3];          // scaled, see mesh/scale.hpp
    std::uint32_t index;  // the least of the caller's points at this vertex, counted from 0
    VertexId moved_to;    // the new number while vertices are renumbered; otherwise 0 or has_equals
};
static_assert(sizeof(Vertex) == 32);
// A flag in `moved_to`: several points are, or were, at this vertex.
inline constexpr VertexId has_equals = 1;

// v[0], the base vertex, is the newest of the four, v[1] the second newest. So the newest vertex of
// face 0 is v[1], and that of any other face is v[0]. Removal of vertices breaks this order, see
// Mesh::guards_agree. A finite tetrahedron is positively oriented. In a ghost, v[2] or v[3] is the
// vertex at infinity, which stands for a point beyond the hull facet of the other three.
struct alignas(16) Tetrahedron {
    VertexId v[4];
    FacetCode n[4];

    MGDT_ALWAYS_INLINE bool is_ghost() const noexcept {
        return v[2] == infinite_vertex || v[3] == infinite_vertex;
    }
    // The base vertex of a live tetrahedron is finite, that of a dead one is not.
    MGDT_ALWAYS_INLINE bool is_dead() const noexcept { return v[0] == infinite_vertex; }
    MGDT_ALWAYS_INLINE void kill() noexcept { v[0] = infinite_vertex; }
    // The mark is valid only while a cavity is being built.
    MGDT_ALWAYS_INLINE bool is_in_cavity() const noexcept { return (v[1] & in_cavity) != 0; }
    MGDT_ALWAYS_INLINE int infinite_slot() const noexcept {
        assert(is_ghost() && "a finite tetrahedron has no vertex at infinity");
        return v[2] == infinite_vertex ? 2 : 3;
    }
};
static_assert(sizeof(Tetrahedron) == 32);

// The circumsphere of a tetrahedron. With u = q - v[0], the power of q is |u|^2 - w.u for a finite
// tetrahedron, and -w.u for a ghost. See kernel/circumsphere.hpp.
struct Sphere {
    double w[3];
    double e;  // a bound on the error of w; the sign bit is set for a ghost

    MGDT_ALWAYS_INLINE bool is_ghost() const noexcept { return std::signbit(e); }
};

// The upper 32 bits of a double, which keep its full range and 21 significant bits. The lower bits
// are truncated.
MGDT_ALWAYS_INLINE std::uint32_t upper_half(double x) noexcept {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return static_cast<std::uint32_t>(bits >> 32);
}
MGDT_ALWAYS_INLINE double from_upper_half(std::uint32_t half) noexcept {
    const std::uint64_t bits = std::uint64_t{half} << 32;
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

// A sphere as the mesh stores it, in upper halves of doubles. These halve the memory, and their
// larger error leaves few tests undecided.
struct alignas(16) KeptSphere {
    std::uint32_t w[3];
    std::uint32_t e;  // also bounds the error of truncating w

    MGDT_ALWAYS_INLINE bool is_ghost() const noexcept { return e >> 31 != 0; }
    // While threads insert in zones, a tetrahedron between zones is closed: its error bound is NaN,
    // which marks the tetrahedron and leaves every test undecided.
    static constexpr std::uint32_t no_number = 0x7FF80000u, sign_of_ghost = 0x80000000u;
    MGDT_ALWAYS_INLINE bool is_closed() const noexcept { return (e & ~sign_of_ghost) == no_number; }
    MGDT_ALWAYS_INLINE void close() noexcept {
        assert(!is_closed() && "the tetrahedron is closed already");
        e = (e & sign_of_ghost) | no_number;
    }
    MGDT_ALWAYS_INLINE Sphere in_doubles() const noexcept {
        return {{from_upper_half(w[0]), from_upper_half(w[1]), from_upper_half(w[2])},
                from_upper_half(e)};
    }
};
static_assert(sizeof(KeptSphere) == 16);

// For each face of a positively oriented tetrahedron its vertices a, b, c, in the order that makes
// (q, a, b, c) positively oriented for a point q beyond the face.
inline constexpr unsigned char outer_face[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};

// Sorts the vertices of a record without changing its orientation: the two largest numbers come
// first, and vertex i goes to position[i]. The vertex at infinity has the least number and comes
// third or fourth. Returns whether some vertex moves.
inline bool positions_by_number(const VertexId (&v)[4], unsigned (&position)[4]) noexcept {
    unsigned order[4] = {0, 1, 2, 3};
    bool is_odd = false;
    for (unsigned i = 1; i < 4; ++i)
        for (unsigned j = i; j > 0 && v[order[j]] > v[order[j - 1]]; --j) {
            std::swap(order[j], order[j - 1]);
            is_odd = !is_odd;
        }
    for (unsigned i = 1; i < 4; ++i)
        assert(v[order[i]] < v[order[i - 1]] && "two vertices of a tetrahedron are the same");
    for (unsigned i = 0; i < 4; ++i) position[order[i]] = is_odd && i >= 2 ? 5 - i : i;
    return position[0] != 0 || position[1] != 1 || position[2] != 2;
}

}  // namespace mgdt
