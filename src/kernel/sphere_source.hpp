// SPDX-License-Identifier: MIT
// The sources from which the kernel gets the spheres of tetrahedra.
#pragma once

#include "kernel/circumsphere.hpp"
#include "mesh/mesh.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// Spheres that the mesh stores.
struct KeptSpheres {
    static constexpr bool are_kept = true;
    MGDT_ALWAYS_INLINE explicit KeptSpheres(const Mesh& mesh)
        : tetrahedra(mesh.tetrahedra.view<true>()), vertices(mesh.vertices.data()) {}
    MGDT_ALWAYS_INLINE Sphere sphere(TetId t) const { return tetrahedra.sphere(t).in_doubles(); }
    template <class Tetrahedra>
    MGDT_ALWAYS_INLINE Sphere sphere(const Tetrahedra& four, unsigned k) const {
        return four.sphere(k).in_doubles();
    }

    const TetrahedronView<const TetrahedronAndSphere> tetrahedra;
    const Vertex* const vertices;
};

// Spheres that are computed from the vertices each time, for compact storage.
struct ComputedSpheres {
    static constexpr bool are_kept = false;
    MGDT_ALWAYS_INLINE explicit ComputedSpheres(const Mesh& mesh)
        : tetrahedra(mesh.tetrahedra.view<false>()),
          vertices(mesh.vertices.data()),
          has_extremes(mesh.has_extremes) {}
    Sphere sphere(TetId t) const { return circumsphere(tetrahedra[t], vertices); }
    template <class Tetrahedra>
    Sphere sphere(const Tetrahedra& four, unsigned k) const {
        return circumsphere(four[k], vertices);
    }

    const TetrahedronView<const TetrahedronAlone> tetrahedra;
    const Vertex* const vertices;
    const bool has_extremes;
};

template <class Spheres>
MGDT_ALWAYS_INLINE Power power(const Spheres& from, TetId t, const Query& q) {
    return power(from.sphere(t), from.vertices[from.tetrahedra[t].v[0]].x, q);
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
