// SPDX-License-Identifier: MIT
// set_sphere(), and normals of ghosts, for as many tetrahedra at a time as a vector has doubles.
#pragma once

#include <cstring>
#include <type_traits>

#include "kernel/circumsphere.hpp"

#if defined(__AVX2__) && defined(__FMA__) && defined(__x86_64__)
#define MGDT_HAVE_FOUR_ROWS 1
#include <immintrin.h>

namespace mgdt {
inline namespace MGDT_ISA {

struct Four {
    using Vector = __m256d;
    using Mask = __m256d;  // all bits of an element or none
    MGDT_ALWAYS_INLINE static Mask either(Mask a, Mask b) { return _mm256_or_pd(a, b); }
    MGDT_ALWAYS_INLINE static Vector where(Mask mask, Vector x, Vector y) {
        return _mm256_blendv_pd(y, x, mask);
    }
    MGDT_ALWAYS_INLINE static Vector zero_where(Mask mask, Vector x) {
        return _mm256_andnot_pd(mask, x);
    }
    // Which of so many numbers equal one.
    MGDT_ALWAYS_INLINE static Mask equal(const std::uint8_t* numbers, std::uint32_t number) {
        std::int32_t four;
        std::memcpy(&four, numbers, sizeof four);
        return equal(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(four)), number);
    }
    MGDT_ALWAYS_INLINE static Mask equal(const std::uint32_t* numbers, std::uint32_t number) {
        return equal(_mm_loadu_si128(reinterpret_cast<const __m128i*>(numbers)), number);
    }
    MGDT_ALWAYS_INLINE static Vector all(double x) { return _mm256_set1_pd(x); }
    MGDT_ALWAYS_INLINE static Vector subtract(Vector a, Vector b) { return _mm256_sub_pd(a, b); }
    MGDT_ALWAYS_INLINE static Vector multiply(Vector a, Vector b) { return _mm256_mul_pd(a, b); }
    MGDT_ALWAYS_INLINE static Vector divide(Vector a, Vector b) { return _mm256_div_pd(a, b); }
    // a * b + c, a * b - c
    MGDT_ALWAYS_INLINE static Vector multiply_add(Vector a, Vector b, Vector c) {
        return _mm256_fmadd_pd(a, b, c);
    }
    MGDT_ALWAYS_INLINE static Vector multiply_subtract(Vector a, Vector b, Vector c) {
        return _mm256_fmsub_pd(a, b, c);
    }
    MGDT_ALWAYS_INLINE static Vector magnitude(Vector a) {
        return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
    }
    MGDT_ALWAYS_INLINE static Vector larger(Vector a, Vector b) { return _mm256_max_pd(a, b); }
    MGDT_ALWAYS_INLINE static Mask above(Vector a, Vector b) {
        return _mm256_cmp_pd(a, b, _CMP_GT_OQ);
    }
    // Numbers whose upper halves are these rounded to nearest.
    MGDT_ALWAYS_INLINE static Vector to_upper_half(Vector a) {
        return _mm256_castsi256_pd(
            _mm256_add_epi64(_mm256_castpd_si256(a), _mm256_set1_epi64x(0x80000000)));
    }

  private:
    MGDT_ALWAYS_INLINE static Mask equal(__m128i numbers, std::uint32_t number) {
        const __m128i same = _mm_cmpeq_epi32(numbers, _mm_set1_epi32(static_cast<int>(number)));
        return _mm256_castsi256_pd(_mm256_cvtepi32_epi64(same));
    }
};

#if defined(__AVX512F__) && defined(__AVX512VL__) && defined(__AVX512DQ__) && defined(__AVX512BW__)
#define MGDT_HAVE_EIGHT_ROWS 1

struct Eight {
    using Vector = __m512d;
    using Mask = __mmask8;
    MGDT_ALWAYS_INLINE static Mask either(Mask a, Mask b) { return static_cast<Mask>(a | b); }
    MGDT_ALWAYS_INLINE static Vector where(Mask mask, Vector x, Vector y) {
        return _mm512_mask_blend_pd(mask, y, x);
    }
    MGDT_ALWAYS_INLINE static Vector zero_where(Mask mask, Vector x) {
        return _mm512_maskz_mov_pd(static_cast<Mask>(~mask), x);
    }
    MGDT_ALWAYS_INLINE static Mask equal(const std::uint8_t* numbers, std::uint32_t number) {
        return static_cast<Mask>(
            _mm_cmpeq_epi8_mask(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(numbers)),
                                _mm_set1_epi8(static_cast<char>(number))));
    }
    MGDT_ALWAYS_INLINE static Mask equal(const std::uint32_t* numbers, std::uint32_t number) {
        return _mm256_cmpeq_epi32_mask(
            _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers)),
            _mm256_set1_epi32(static_cast<int>(number)));
    }
    MGDT_ALWAYS_INLINE static Vector all(double x) { return _mm512_set1_pd(x); }
    MGDT_ALWAYS_INLINE static Vector multiply(Vector a, Vector b) { return _mm512_mul_pd(a, b); }
    MGDT_ALWAYS_INLINE static Vector divide(Vector a, Vector b) { return _mm512_div_pd(a, b); }
    MGDT_ALWAYS_INLINE static Vector multiply_add(Vector a, Vector b, Vector c) {
        return _mm512_fmadd_pd(a, b, c);
    }
    MGDT_ALWAYS_INLINE static Vector multiply_subtract(Vector a, Vector b, Vector c) {
        return _mm512_fmsub_pd(a, b, c);
    }
    MGDT_ALWAYS_INLINE static Vector magnitude(Vector a) { return _mm512_abs_pd(a); }
    MGDT_ALWAYS_INLINE static Vector larger(Vector a, Vector b) { return _mm512_max_pd(a, b); }
    MGDT_ALWAYS_INLINE static Mask above(Vector a, Vector b) {
        return _mm512_cmp_pd_mask(a, b, _CMP_GT_OQ);
    }
    MGDT_ALWAYS_INLINE static Vector to_upper_half(Vector a) {
        return _mm512_castsi512_pd(
            _mm512_add_epi64(_mm512_castpd_si512(a), _mm512_set1_epi64(0x80000000)));
    }
};

#endif

// Points as columns of coordinates.
template <class R>
struct PointColumns {
    typename R::Vector x, y, z;
};

// w and e of spheres as columns.
template <class R>
struct SphereColumns {
    typename R::Vector x, y, z, e;
};

// Vertices relative to the base vertex, with what LocalVertex has.
template <class R>
struct LocalColumns : PointColumns<R> {
    using Vector = typename R::Vector;
    MGDT_ALWAYS_INLINE LocalColumns(const PointColumns<R>& v, Vector s, Vector l)
        : PointColumns<R>(v), square(s), largest(l) {}
    MGDT_ALWAYS_INLINE explicit LocalColumns(const PointColumns<R>& v) : PointColumns<R>(v) {
        square = R::multiply_add(v.z, v.z, R::multiply_add(v.y, v.y, R::multiply(v.x, v.x)));
        largest = R::larger(R::magnitude(v.x), R::larger(R::magnitude(v.y), R::magnitude(v.z)));
    }
    // The vertex at infinity, as spheres_through() wants it.
    MGDT_ALWAYS_INLINE LocalColumns infinite_where(typename R::Mask mask) const {
        return {{R::zero_where(mask, this->x), R::zero_where(mask, this->y),
                 R::zero_where(mask, this->z)},
                R::where(mask, R::all(1.0), square),
                R::zero_where(mask, largest)};
    }
    Vector square, largest;
};

// Where there are no ghosts, and none are looked for.
struct NoGhosts {};

// The spheres through the base vertex and three others; with what rounding adds if they are to be
// kept, as upper halves. Where one of the three is the vertex at infinity, with coordinates of 0
// and a square of 1, and the determinant is taken for 1, the same formulas give the normal of the
// ghost's facet, with twice the bound that it wants.
template <bool to_keep, class R, class Ghosts = NoGhosts>
MGDT_ALWAYS_INLINE SphereColumns<R> spheres_through(const LocalColumns<R>& a,
                                                    const LocalColumns<R>& b,
                                                    const LocalColumns<R>& c, Ghosts ghosts = {}) {
    constexpr bool has_ghosts = !std::is_same_v<Ghosts, NoGhosts>;
    using Vector = typename R::Vector;
    const auto minor = [](Vector p, Vector q, Vector r, Vector s) {
        return R::multiply_subtract(p, q, R::multiply(r, s));
    };
    const auto dot = [](Vector p, Vector q, Vector r, Vector s, Vector t, Vector u) {
        return R::multiply_add(t, u, R::multiply_add(r, s, R::multiply(p, q)));
    };
    const Vector bcx = minor(b.y, c.z, b.z, c.y), bcy = minor(b.z, c.x, b.x, c.z),
                 bcz = minor(b.x, c.y, b.y, c.x);
    const Vector cax = minor(c.y, a.z, c.z, a.y), cay = minor(c.z, a.x, c.x, a.z),
                 caz = minor(c.x, a.y, c.y, a.x);
    const Vector abx = minor(a.y, b.z, a.z, b.y), aby = minor(a.z, b.x, a.x, b.z),
                 abz = minor(a.x, b.y, a.y, b.x);
    Vector det = dot(a.x, bcx, a.y, bcy, a.z, bcz);
    if constexpr (has_ghosts) det = R::where(ghosts, R::all(1.0), det);
    const Vector inverse = R::divide(R::all(1.0), det);
    SphereColumns<R> s;
    s.x = R::multiply(inverse, dot(a.square, bcx, b.square, cax, c.square, abx));
    s.y = R::multiply(inverse, dot(a.square, bcy, b.square, cay, c.square, aby));
    s.z = R::multiply(inverse, dot(a.square, bcz, b.square, caz, c.square, abz));

    const Vector lbc = R::multiply(b.largest, c.largest), lca = R::multiply(c.largest, a.largest),
                 lab = R::multiply(a.largest, b.largest);
    const Vector sum = dot(a.square, lbc, b.square, lca, c.square, lab);
    const Vector product =
        R::multiply(R::all(proved_bounds.sphere_det * unit_roundoff), R::multiply(a.largest, lbc));
    const Vector largest =
        R::larger(R::magnitude(s.x), R::larger(R::magnitude(s.y), R::magnitude(s.z)));
    const Vector numerator = R::multiply_add(
        product, largest, R::multiply(R::all(proved_bounds.sphere_sum * unit_roundoff), sum));
    if constexpr (to_keep) {
        s.e = R::multiply_add(inverse, numerator, R::multiply(largest, R::all(kept_roundoff)));
        s.x = R::to_upper_half(s.x);
        s.y = R::to_upper_half(s.y);
        s.z = R::to_upper_half(s.z);
    } else {
        s.e = R::multiply(inverse, numerator);
    }
    s.e = R::where(R::above(det, product), s.e, R::all(infinity));
    if constexpr (has_ghosts) s.e = R::where(ghosts, R::multiply(R::all(-1.0), s.e), s.e);
    return s;
}

}  // namespace MGDT_ISA
}  // namespace mgdt

#endif
