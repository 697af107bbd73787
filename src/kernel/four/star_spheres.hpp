// SPDX-License-Identifier: MIT
// The computation of the spheres of a star, for vectors of four doubles and of eight.
#pragma once

#include "kernel/four.hpp"
#include "kernel/sphere_columns.hpp"
#include "kernel/star_records.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// Computes one sphere per element of a vector; bs and cs are the local numbers of b and c.
template <bool at_hull, class R, class Number>
MGDT_ALWAYS_INLINE SphereColumns<R> star_spheres(const LocalColumns<R>& a, const LocalColumns<R>& b,
                                                 const LocalColumns<R>& c, const Number* bs,
                                                 const Number* cs, std::uint32_t infinite) {
    if constexpr (at_hull) {
        const auto at_b = R::Mask::equal(bs, infinite), at_c = R::Mask::equal(cs, infinite);
        return spheres_through<true>(a, b.infinite_where(at_b), c.infinite_where(at_c),
                                     at_b | at_c);
    } else {
        return spheres_through<true>(a, b, c);
    }
}

// Sets the sphere of the i-th facet's tetrahedron and calls `link` for this tetrahedron. Returns
// false after the last facet. The processor mispredicts the branch that depends on the number of
// facets, so there is only one such branch.
template <class Link>
MGDT_ALWAYS_INLINE bool finish(const FacetCode* slots, std::size_t size, SphereStore spheres,
                               std::size_t i, FourWords sphere, Link link) {
    if (i == size) return false;
    TetrahedronAndSphere& to = *spheres.record(slots[i]);
    link(i, to.tetrahedron);
    sphere.store(to.sphere.w);
    return true;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
