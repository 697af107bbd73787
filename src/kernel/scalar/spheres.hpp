// SPDX-License-Identifier: MIT
// The circumspheres of a star, one by one: see kernel/spheres.hpp.
#pragma once

#include "kernel/circumsphere.hpp"
#include "kernel/star_records.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

template <class Number>
void set_spheres_scalar(Workspace& w, const Vertex* vertices, VertexId q, std::uint32_t count,
                        std::uint32_t infinite, const Number* a, const Number* b, const Number* c,
                        SphereStore spheres) {
    set_coordinates(w, vertices, q, count);
    const auto vertex = [&](std::size_t i) {
        return local_vertex(w.x.data[i], w.y.data[i], w.z.data[i]);
    };
    for (std::size_t i = 0; i < w.boundary_size; ++i) {
        Sphere s;
        if (b[i] == infinite)
            set_normal(vertex(c[i]), vertex(a[i]), s);
        else if (c[i] == infinite)
            set_normal(vertex(a[i]), vertex(b[i]), s);
        else
            set_sphere(vertex(a[i]), vertex(b[i]), vertex(c[i]), s);
        spheres.record(w.slots.data[i])->sphere = rounded(s);
    }
}

template <class Link>
inline void set_spheres_small(Workspace& w, const Vertex* vertices, VertexId q, std::uint32_t count,
                              std::uint32_t infinite, SphereStore spheres, Link link) {
    link_each(spheres, w, link);
    set_spheres_scalar(w, vertices, q, count, infinite, w.small.a, w.small.b, w.small.c, spheres);
}

inline void set_spheres(Workspace& w, const Vertex* vertices, VertexId q, std::uint32_t count,
                        std::uint32_t infinite, SphereStore spheres) {
    set_spheres_scalar(w, vertices, q, count, infinite, w.a.data, w.b.data, w.c.data, spheres);
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
