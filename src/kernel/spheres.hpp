// SPDX-License-Identifier: MIT
// The circumspheres of a star, computed over the local coordinate arrays of the workspace: for
// each facet (a, b, c) of local numbers, w and e of its new tetrahedron.
#pragma once

#include "kernel/circumsphere.hpp"
#include "kernel/workspace.hpp"

#if defined(__AVX512F__) && defined(__AVX512VL__) && defined(__AVX512DQ__)
#include <immintrin.h>
#endif

namespace mgdt {
inline namespace MGDT_ISA {

MGDT_ALWAYS_INLINE LocalVertex local_vertex(const Workspace& w, std::uint32_t i) {
    return local_vertex(w.x.data[i], w.y.data[i], w.z.data[i]);
}

inline void set_spheres_scalar(const Workspace& w, Tetrahedron* tetrahedra) {
    for (std::size_t i = 0; i < w.boundary_size; ++i)
        set_sphere(local_vertex(w, w.a.data[i]), local_vertex(w, w.b.data[i]),
                   local_vertex(w, w.c.data[i]), tetrahedra[w.slots.data[i]]);
}

#if defined(__AVX512F__) && defined(__AVX512VL__) && defined(__AVX512DQ__)

// Up to 32 local coordinates in four registers; picking by number is two permutes and a blend.
class Picker {
  public:
    MGDT_ALWAYS_INLINE explicit Picker(const double* values)
        : v0_(_mm512_load_pd(values)),
          v1_(_mm512_load_pd(values + 8)),
          v2_(_mm512_load_pd(values + 16)),
          v3_(_mm512_load_pd(values + 24)) {}
    template <bool few>
    MGDT_ALWAYS_INLINE __m512d pick(__m512i i, __mmask8 upper) const {
        const __m512d low = _mm512_permutex2var_pd(v0_, i, v1_);
        if constexpr (few) return low;
        return _mm512_mask_blend_pd(upper, low, _mm512_permutex2var_pd(v2_, i, v3_));
    }

  private:
    __m512d v0_, v1_, v2_, v3_;
};

struct LocalVertices {
    __m512d x, y, z, square, largest;
};

template <bool few>
MGDT_ALWAYS_INLINE LocalVertices pick_vertices(const std::uint32_t* numbers, const Picker& x,
                                               const Picker& y, const Picker& z) {
    const __m512i i =
        _mm512_cvtepu32_epi64(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers)));
    const __mmask8 upper = few ? 0 : _mm512_test_epi64_mask(i, _mm512_set1_epi64(16));
    LocalVertices v;
    v.x = x.pick<few>(i, upper);
    v.y = y.pick<few>(i, upper);
    v.z = z.pick<few>(i, upper);
    v.square = _mm512_fmadd_pd(v.z, v.z, _mm512_fmadd_pd(v.y, v.y, _mm512_mul_pd(v.x, v.x)));
    v.largest =
        _mm512_max_pd(_mm512_abs_pd(v.x), _mm512_max_pd(_mm512_abs_pd(v.y), _mm512_abs_pd(v.z)));
    return v;
}

// set_sphere() for eight facets at a time.
template <bool few>
MGDT_ALWAYS_INLINE void set_spheres_vector(Workspace& w, Tetrahedron* tetrahedra) {
    const Picker px(w.x.data), py(w.y.data), pz(w.z.data);
    const __m512d of_sum = _mm512_set1_pd(proved_bounds.sphere_sum * unit_roundoff);
    const __m512d of_det = _mm512_set1_pd(proved_bounds.sphere_det * unit_roundoff);
    const std::size_t size = w.boundary_size;
    for (std::size_t begin = 0; begin < size; begin += 8) {
        const LocalVertices a = pick_vertices<few>(w.a.data + begin, px, py, pz);
        const LocalVertices b = pick_vertices<few>(w.b.data + begin, px, py, pz);
        const LocalVertices c = pick_vertices<few>(w.c.data + begin, px, py, pz);
        const auto minor = [](__m512d p, __m512d q, __m512d r, __m512d s) {
            return _mm512_fmsub_pd(p, q, _mm512_mul_pd(r, s));
        };
        const __m512d bcx = minor(b.y, c.z, b.z, c.y), bcy = minor(b.z, c.x, b.x, c.z),
                      bcz = minor(b.x, c.y, b.y, c.x);
        const __m512d cax = minor(c.y, a.z, c.z, a.y), cay = minor(c.z, a.x, c.x, a.z),
                      caz = minor(c.x, a.y, c.y, a.x);
        const __m512d abx = minor(a.y, b.z, a.z, b.y), aby = minor(a.z, b.x, a.x, b.z),
                      abz = minor(a.x, b.y, a.y, b.x);
        const auto dot = [](__m512d p, __m512d q, __m512d r, __m512d s, __m512d t, __m512d u) {
            return _mm512_fmadd_pd(t, u, _mm512_fmadd_pd(r, s, _mm512_mul_pd(p, q)));
        };
        const __m512d det = dot(a.x, bcx, a.y, bcy, a.z, bcz);
        const __m512d inverse = _mm512_div_pd(_mm512_set1_pd(1.0), det);
        const __m512d wx = _mm512_mul_pd(inverse, dot(a.square, bcx, b.square, cax, c.square, abx));
        const __m512d wy = _mm512_mul_pd(inverse, dot(a.square, bcy, b.square, cay, c.square, aby));
        const __m512d wz = _mm512_mul_pd(inverse, dot(a.square, bcz, b.square, caz, c.square, abz));

        const __m512d lbc = _mm512_mul_pd(b.largest, c.largest),
                      lca = _mm512_mul_pd(c.largest, a.largest),
                      lab = _mm512_mul_pd(a.largest, b.largest);
        const __m512d sum = dot(a.square, lbc, b.square, lca, c.square, lab);
        const __m512d product = _mm512_mul_pd(of_det, _mm512_mul_pd(a.largest, lbc));
        const __m512d largest =
            _mm512_max_pd(_mm512_abs_pd(wx), _mm512_max_pd(_mm512_abs_pd(wy), _mm512_abs_pd(wz)));
        const __m512d bound =
            _mm512_mul_pd(inverse, _mm512_fmadd_pd(product, largest, _mm512_mul_pd(of_sum, sum)));
        const __mmask8 sound = _mm512_cmp_pd_mask(det, product, _CMP_GT_OQ);
        const __m512d e = _mm512_mask_blend_pd(sound, _mm512_set1_pd(infinity), bound);
        const __m256 rounded =
            _mm256_add_ps(_mm512_cvtpd_ps(_mm512_mul_pd(e, _mm512_set1_pd(1 + 0x1p-22))),
                          _mm256_set1_ps(std::numeric_limits<float>::denorm_min()));
        // e in the lower half of each 64 bits, mark 0 in the upper.
        const __m512d em = _mm512_castsi512_pd(_mm512_cvtepu32_epi64(_mm256_castps_si256(rounded)));

        // Transposed, each 256 bits are the second half of a record.
        const __m512d xy_even = _mm512_unpacklo_pd(wx, wy), xy_odd = _mm512_unpackhi_pd(wx, wy);
        const __m512d ze_even = _mm512_unpacklo_pd(wz, em), ze_odd = _mm512_unpackhi_pd(wz, em);
        const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11);
        const __m512i second = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
        const __m512d out02 = _mm512_permutex2var_pd(xy_even, first, ze_even);
        const __m512d out46 = _mm512_permutex2var_pd(xy_even, second, ze_even);
        const __m512d out13 = _mm512_permutex2var_pd(xy_odd, first, ze_odd);
        const __m512d out57 = _mm512_permutex2var_pd(xy_odd, second, ze_odd);
        const auto store = [&](std::size_t k, __m256d half) {
            Tetrahedron& t = begin + k < size ? tetrahedra[w.slots.data[begin + k]] : w.beyond;
            _mm256_store_pd(t.w, half);
        };
        store(0, _mm512_castpd512_pd256(out02));
        store(1, _mm512_castpd512_pd256(out13));
        store(2, _mm512_extractf64x4_pd(out02, 1));
        store(3, _mm512_extractf64x4_pd(out13, 1));
        store(4, _mm512_castpd512_pd256(out46));
        store(5, _mm512_castpd512_pd256(out57));
        store(6, _mm512_extractf64x4_pd(out46, 1));
        store(7, _mm512_extractf64x4_pd(out57, 1));
    }
}

inline void set_spheres(Workspace& w, std::uint32_t vertices, Tetrahedron* tetrahedra) {
    if (vertices <= 16)
        set_spheres_vector<true>(w, tetrahedra);
    else if (vertices <= 32)
        set_spheres_vector<false>(w, tetrahedra);
    else
        set_spheres_scalar(w, tetrahedra);
}

#else

inline void set_spheres(Workspace& w, std::uint32_t, Tetrahedron* tetrahedra) {
    set_spheres_scalar(w, tetrahedra);
}

#endif

}  // namespace MGDT_ISA
}  // namespace mgdt
