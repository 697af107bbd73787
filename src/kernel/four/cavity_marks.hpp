// SPDX-License-Identifier: MIT
// Marks on four tetrahedra at a time: see kernel/cavity_marks.hpp.
#pragma once

#include "kernel/four.hpp"
#include "kernel/mark_one_by_one.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

MGDT_ALWAYS_INLINE std::uint32_t put_four(const MarkTable::View& marks, const FacetCode* codes,
                                          std::uint32_t which) {
    const FourWords t = FourWords::load(codes) >> 2;  // tetrahedron_of()
    const auto entry = [&](unsigned k) {
        return marks.data + (tetrahedron_of(codes[k]) & marks.mask);
    };
    const FourWords before(*entry(0), *entry(1), *entry(2), *entry(3));
    const FourWords keys = (t >> marks.position_bits) | FourWords(marks.stamp);

    const FourWords zero(0u), difference = before ^ keys;
    const std::uint32_t is_in = (difference == zero).sign_bits();
    // Two entries with the same stamp differ only in bits below stamp_shift.
    const std::uint32_t has_stamp = ((difference >> MarkTable::stamp_shift) == zero).sign_bits();
    const FourWords position = t & FourWords(marks.mask);
    // Whether two of the four have the same position. Comparing (0 1 2 3) with (1 2 3 0) and (2 3 0
    // 1) covers all six pairs.
    const std::uint32_t is_shared =
        ((position == position.turned<1>()) | (position == position.turned<2>())).sign_bits();
    if (MGDT_UNLIKELY(((has_stamp & ~is_in & which) | is_shared) != 0))
        return put_one_by_one(marks, codes, which);

    const FourWords after = where(FourWords::with_sign_bits(which), keys, before);
    *entry(0) = after.element<0>();
    *entry(1) = after.element<1>();
    *entry(2) = after.element<2>();
    *entry(3) = after.element<3>();
    return which & ~is_in;
}

template <class Tetrahedra>
MGDT_ALWAYS_INLINE std::uint32_t mark_four(const Tetrahedra& four, std::uint32_t which) {
    const FourWords before(four[0].v[1], four[1].v[1], four[2].v[1], four[3].v[1]);
    // The mark is the sign bit.
    const FourWords after =
        before | (FourWords::with_sign_bits(which) & FourWords(std::uint32_t{in_cavity}));
    four[0].v[1] = after.element<0>();
    four[1].v[1] = after.element<1>();
    four[2].v[1] = after.element<2>();
    four[3].v[1] = after.element<3>();
    return which & ~before.sign_bits();
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
