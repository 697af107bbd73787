// SPDX-License-Identifier: MIT
// The circumspheres of a star, for eight facets at a time: see kernel/spheres.hpp.
#pragma once

#include "kernel/avx2/star_spheres.hpp"
#include "kernel/avx512/transpose.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

using EightVertices = PointColumns<Eight>;

// Eight vertices by id, relative to q.
MGDT_ALWAYS_INLINE EightVertices load_vertices(const Vertex* vertices, const VertexId* ids,
                                               VertexId q) {
    const Transpose8 rows([&](unsigned k) { return vertices[ids[k]].x; });
    return {_mm512_sub_pd(rows.first(), _mm512_set1_pd(vertices[q].x[0])),
            _mm512_sub_pd(rows.second(), _mm512_set1_pd(vertices[q].x[1])),
            _mm512_sub_pd(rows.third(), _mm512_set1_pd(vertices[q].x[2]))};
}

MGDT_ALWAYS_INLINE __m512i load_numbers(const std::uint8_t* numbers) {
    return _mm512_cvtepu8_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(numbers)));
}

// Up to 16 vertices in registers, with what LocalVertex has; picking by number is one permutation.
class SixteenVertices {
  public:
    MGDT_ALWAYS_INLINE SixteenVertices(const Vertex* vertices, const VertexId* ids, VertexId q)
        : v0_(load_vertices(vertices, ids, q)), v1_(load_vertices(vertices, ids + 8, q)) {}
    MGDT_ALWAYS_INLINE LocalColumns<Eight> pick(const std::uint8_t* numbers) const {
        const __m512i i = load_numbers(numbers);
        const auto one = [&](__m512d a, __m512d b) { return _mm512_permutex2var_pd(a, i, b); };
        return {{one(v0_.x, v1_.x), one(v0_.y, v1_.y), one(v0_.z, v1_.z)},
                one(v0_.square, v1_.square),
                one(v0_.largest, v1_.largest)};
    }

  private:
    LocalColumns<Eight> v0_, v1_;
};

// Up to 32: two permutations and a blend, so that the rest is sooner computed than picked.
class ThirtyTwoVertices {
  public:
    MGDT_ALWAYS_INLINE ThirtyTwoVertices(const Vertex* vertices, const VertexId* ids, VertexId q)
        : v0_(load_vertices(vertices, ids, q)),
          v1_(load_vertices(vertices, ids + 8, q)),
          v2_(load_vertices(vertices, ids + 16, q)),
          v3_(load_vertices(vertices, ids + 24, q)) {}
    MGDT_ALWAYS_INLINE LocalColumns<Eight> pick(const std::uint8_t* numbers) const {
        const __m512i i = load_numbers(numbers);
        const __mmask8 upper = _mm512_test_epi64_mask(i, _mm512_set1_epi64(16));
        const auto one = [&](__m512d a, __m512d b, __m512d c, __m512d d) {
            return _mm512_mask_blend_pd(upper, _mm512_permutex2var_pd(a, i, b),
                                        _mm512_permutex2var_pd(c, i, d));
        };
        return LocalColumns<Eight>({one(v0_.x, v1_.x, v2_.x, v3_.x),
                                    one(v0_.y, v1_.y, v2_.y, v3_.y),
                                    one(v0_.z, v1_.z, v2_.z, v3_.z)});
    }

  private:
    EightVertices v0_, v1_, v2_, v3_;
};

// Any number of vertices, in memory.
class MemoryVertices {
  public:
    explicit MemoryVertices(const Workspace& w) : x_(w.x.data), y_(w.y.data), z_(w.z.data) {}
    MGDT_ALWAYS_INLINE LocalColumns<Eight> pick(const std::uint32_t* numbers) const {
        const __m256i i = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers));
        return LocalColumns<Eight>({_mm512_i32gather_pd(i, x_, 8), _mm512_i32gather_pd(i, y_, 8),
                                    _mm512_i32gather_pd(i, z_, 8)});
    }

  private:
    const double *x_, *y_, *z_;
};

// set_sphere(), and normals of ghosts, for eight facets at a time, with what else is to be done
// with their tetrahedra, for which the processor has time while it computes spheres. The arrays of
// numbers may be read past their ends.
template <bool at_hull, class Vertices, class Number, class Link>
MGDT_ALWAYS_INLINE void set_spheres_vector(Workspace& w, const Vertices& vertices,
                                           std::uint32_t infinite, const Number* as,
                                           const Number* bs, const Number* cs, SphereStore spheres,
                                           Link link) {
    const std::size_t size = w.boundary_size;
    const FacetCode* const slots = w.slots.data;
    for (std::size_t begin = 0; begin < size; begin += 8) {
        const SphereColumns<Eight> s =
            star_spheres<at_hull>(vertices.pick(as + begin), vertices.pick(bs + begin),
                                  vertices.pick(cs + begin), bs + begin, cs + begin, infinite);

        // Each 128 bits are the upper halves of a sphere.
        const auto pairs = [](__m512d low, __m512d high) {
            return _mm512_castps_pd(
                _mm512_mask_movehdup_ps(_mm512_castpd_ps(high), 0x5555, _mm512_castpd_ps(low)));
        };
        const __m512d left = pairs(s.x, s.y), right = pairs(s.z, s.e);
        const auto store = [&](std::size_t k, __m128i sphere) {
            return finish(slots, size, spheres, begin + k, sphere, link);
        };
        const __m512i even = _mm512_castpd_si512(_mm512_unpacklo_pd(left, right)),
                      odd = _mm512_castpd_si512(_mm512_unpackhi_pd(left, right));
        static_cast<void>(store(0, _mm512_castsi512_si128(even)) &&
                          store(1, _mm512_castsi512_si128(odd)) &&
                          store(2, _mm512_extracti32x4_epi32(even, 1)) &&
                          store(3, _mm512_extracti32x4_epi32(odd, 1)) &&
                          store(4, _mm512_extracti32x4_epi32(even, 2)) &&
                          store(5, _mm512_extracti32x4_epi32(odd, 2)) &&
                          store(6, _mm512_extracti32x4_epi32(even, 3)) &&
                          store(7, _mm512_extracti32x4_epi32(odd, 3)));
    }
}

template <class Vertices, class Number, class Link>
MGDT_ALWAYS_INLINE void set_spheres_vector(Workspace& w, const Vertices& vertices,
                                           std::uint32_t infinite, const Number* as,
                                           const Number* bs, const Number* cs, SphereStore spheres,
                                           Link link) {
    if (infinite == no_index)
        set_spheres_vector<false>(w, vertices, infinite, as, bs, cs, spheres, link);
    else
        set_spheres_vector<true>(w, vertices, infinite, as, bs, cs, spheres, link);
}

template <class Link>
inline void set_spheres_small(Workspace& w, const Vertex* vertices, VertexId q, std::uint32_t count,
                              std::uint32_t infinite, SphereStore spheres, Link link) {
    const Workspace::SmallStar& s = w.small;
    if (count <= 16)
        set_spheres_vector(w, SixteenVertices(vertices, w.ids.data, q), infinite, s.a, s.b, s.c,
                           spheres, link);
    else
        set_spheres_vector(w, ThirtyTwoVertices(vertices, w.ids.data, q), infinite, s.a, s.b, s.c,
                           spheres, link);
}

inline void set_spheres(Workspace& w, const Vertex* vertices, VertexId q, std::uint32_t count,
                        std::uint32_t infinite, SphereStore spheres) {
    set_coordinates(w, vertices, q, count);
    set_spheres_vector(w, MemoryVertices(w), infinite, w.a.data, w.b.data, w.c.data, spheres,
                       NoLinks());
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
