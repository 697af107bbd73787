// SPDX-License-Identifier: MIT
// The circumspheres of a star, for four facets at a time: see kernel/spheres.hpp.
#pragma once

#include "kernel/four.hpp"
#include "kernel/four/star_spheres.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// Computes the spheres of four facets at a time.
template <bool at_hull, class Number, class Link>
MGDT_ALWAYS_INLINE void set_spheres_vector(Workspace& w, const Vertex* vertices, VertexId q,
                                           std::uint32_t infinite, const Number* as,
                                           const Number* bs, const Number* cs, SphereStore spheres,
                                           Link link) {
    const double* const p = vertices[q].x;
    const PointColumns<Four> base = {p[0], p[1], p[2]};
    const auto pick = [&](const Number* numbers) {
        const Transpose4 rows([&](unsigned k) { return vertices[w.ids.data[numbers[k]]].x; });
        return LocalColumns<Four>(relative_to(rows, base));
    };
    const std::size_t size = w.boundary_size;
    const FacetCode* const slots = w.slots.data;
    for (std::size_t begin = 0; begin < size; begin += 4) {
        const SphereColumns<Four> s = star_spheres<at_hull>(
            pick(as + begin), pick(bs + begin), pick(cs + begin), bs + begin, cs + begin, infinite);
        const Transpose4 columns = {s.x, s.y, s.z, s.e};
        columns.store_upper_halves([&](std::size_t k, FourWords sphere) {
            return finish(slots, size, spheres, begin + k, sphere, link);
        });
    }
}

template <class Number, class Link>
inline void set_spheres_vector(Workspace& w, const Vertex* vertices, VertexId q,
                               std::uint32_t infinite, const Number* as, const Number* bs,
                               const Number* cs, SphereStore spheres, Link link) {
    if (infinite == no_index)
        set_spheres_vector<false>(w, vertices, q, infinite, as, bs, cs, spheres, link);
    else
        set_spheres_vector<true>(w, vertices, q, infinite, as, bs, cs, spheres, link);
}

template <class Link>
inline void set_spheres_small(Workspace& w, const Vertex* vertices, VertexId q, std::uint32_t,
                              std::uint32_t infinite, SphereStore spheres, Link link) {
    set_spheres_vector(w, vertices, q, infinite, w.small.a, w.small.b, w.small.c, spheres, link);
}

inline void set_spheres(Workspace& w, const Vertex* vertices, VertexId q, std::uint32_t,
                        std::uint32_t infinite, SphereStore spheres) {
    set_spheres_vector(w, vertices, q, infinite, w.a.data, w.b.data, w.c.data, spheres, NoLinks());
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
