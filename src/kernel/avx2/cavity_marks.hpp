// SPDX-License-Identifier: MIT
// Marks on four tetrahedra at a time: see kernel/cavity_marks.hpp.
#pragma once

#include <immintrin.h>

#include "kernel/mark_one_by_one.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

MGDT_ALWAYS_INLINE std::uint32_t put_four(const MarkTable::View& marks, const FacetCode* codes,
                                          std::uint32_t which) {
    const __m128i t = _mm_srli_epi32(_mm_load_si128(reinterpret_cast<const __m128i*>(codes)), 2);
    const auto entry = [&](unsigned k) {
        return marks.data + (tetrahedron_of(codes[k]) & marks.mask);
    };
    const auto there = [&](unsigned k) { return static_cast<int>(*entry(k)); };
    const __m128i before = _mm_setr_epi32(there(0), there(1), there(2), there(3));
    const __m128i keys =
        _mm_or_si128(_mm_srl_epi32(t, _mm_cvtsi32_si128(static_cast<int>(marks.place_bits))),
                     _mm_set1_epi32(static_cast<int>(marks.stamp)));

    const auto lanes = [](__m128i of_words) {
        return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(of_words)));
    };
    const __m128i zero = _mm_setzero_si128(), difference = _mm_xor_si128(before, keys);
    const std::uint32_t is_in = lanes(_mm_cmpeq_epi32(difference, zero));
    // Two entries with one stamp differ below it alone.
    const std::uint32_t has_stamp =
        lanes(_mm_cmpeq_epi32(_mm_srli_epi32(difference, MarkTable::stamp_shift), zero));
    const __m128i place = _mm_and_si128(t, _mm_set1_epi32(static_cast<int>(marks.mask)));
    // Whether two of the four have one place: (0 1 2 3) beside (1 2 3 0) and (2 3 0 1), which are
    // all six pairs.
    const std::uint32_t is_shared = lanes(
        _mm_or_si128(_mm_cmpeq_epi32(place, _mm_shuffle_epi32(place, _MM_SHUFFLE(0, 3, 2, 1))),
                     _mm_cmpeq_epi32(place, _mm_shuffle_epi32(place, _MM_SHUFFLE(1, 0, 3, 2)))));
    if (MGDT_UNLIKELY(((has_stamp & ~is_in & which) | is_shared) != 0))
        return put_one_by_one(marks, codes, which);

    const __m128i chosen =
        _mm_sllv_epi32(_mm_set1_epi32(static_cast<int>(which)), _mm_setr_epi32(31, 30, 29, 28));
    const __m128i after = _mm_castps_si128(
        _mm_blendv_ps(_mm_castsi128_ps(before), _mm_castsi128_ps(keys), _mm_castsi128_ps(chosen)));
    *entry(0) = static_cast<std::uint32_t>(_mm_extract_epi32(after, 0));
    *entry(1) = static_cast<std::uint32_t>(_mm_extract_epi32(after, 1));
    *entry(2) = static_cast<std::uint32_t>(_mm_extract_epi32(after, 2));
    *entry(3) = static_cast<std::uint32_t>(_mm_extract_epi32(after, 3));
    return which & ~is_in;
}

template <class Tetrahedra>
MGDT_ALWAYS_INLINE std::uint32_t mark_four(const Tetrahedra& four, std::uint32_t which) {
    const auto second = [&](unsigned k) { return static_cast<int>(four[k].v[1]); };
    const __m128i before = _mm_setr_epi32(second(0), second(1), second(2), second(3));
    const auto marked = static_cast<std::uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(before)));
    const __m128i on_top =
        _mm_sllv_epi32(_mm_set1_epi32(static_cast<int>(which)), _mm_setr_epi32(31, 30, 29, 28));
    const __m128i marks = _mm_and_si128(on_top, _mm_set1_epi32(static_cast<int>(in_cavity)));
    const __m128i after = _mm_or_si128(before, marks);
    four[0].v[1] = static_cast<VertexId>(_mm_extract_epi32(after, 0));
    four[1].v[1] = static_cast<VertexId>(_mm_extract_epi32(after, 1));
    four[2].v[1] = static_cast<VertexId>(_mm_extract_epi32(after, 2));
    four[3].v[1] = static_cast<VertexId>(_mm_extract_epi32(after, 3));
    return which & ~marked;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
