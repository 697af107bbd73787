// SPDX-License-Identifier: MIT
// The circumspheres of a star, for eight facets at a time: see kernel/spheres.hpp.
#pragma once

#include "kernel/avx512/transpose.hpp"
#include "kernel/four/star_spheres.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

using EightVertices = PointColumns<Eight>;

// Loads the eight vertices with these numbers, relative to q.
MGDT_ALWAYS_INLINE EightVertices load_vertices(const Vertex* vertices, const VertexId* ids,
                                               VertexId q) {
    const auto [x, y, z] = first_columns([&](unsigned k) { return vertices[ids[k]].x; });
    const double* const base = vertices[q].x;
    return {x - base[0], y - base[1], z - base[2]};
}

// Up to 16 vertices in registers, with the members of LocalVertex. One permutation selects eight
// vertices by local number.
class SixteenVertices {
  public:
    MGDT_ALWAYS_INLINE SixteenVertices(const Vertex* vertices, const VertexId* ids, VertexId q)
        : v0_(load_vertices(vertices, ids, q)), v1_(load_vertices(vertices, ids + 8, q)) {}
    MGDT_ALWAYS_INLINE LocalColumns<Eight> pick(const std::uint8_t* numbers) const {
        const EightNumbers n(numbers);
        return {{elements(n, v0_.x, v1_.x), elements(n, v0_.y, v1_.y), elements(n, v0_.z, v1_.z)},
                elements(n, v0_.square, v1_.square),
                elements(n, v0_.largest, v1_.largest)};
    }

  private:
    LocalColumns<Eight> v0_, v1_;
};

// Up to 32 vertices in registers. A selection takes two permutations and a blend, so only
// coordinates are selected, and the other members of LocalVertex are computed.
class ThirtyTwoVertices {
  public:
    MGDT_ALWAYS_INLINE ThirtyTwoVertices(const Vertex* vertices, const VertexId* ids, VertexId q)
        : v0_(load_vertices(vertices, ids, q)),
          v1_(load_vertices(vertices, ids + 8, q)),
          v2_(load_vertices(vertices, ids + 16, q)),
          v3_(load_vertices(vertices, ids + 24, q)) {}
    MGDT_ALWAYS_INLINE LocalColumns<Eight> pick(const std::uint8_t* numbers) const {
        const EightNumbers n(numbers);
        const EightMask upper = n.have(16);
        const auto one = [&](Eight a, Eight b, Eight c, Eight d) {
            return where(upper, elements(n, c, d), elements(n, a, b));
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
        return LocalColumns<Eight>(
            {Eight::gather(x_, numbers), Eight::gather(y_, numbers), Eight::gather(z_, numbers)});
    }

  private:
    const double *x_, *y_, *z_;
};

// Computes the spheres of eight facets at a time, and the normals of ghosts. `link` does the rest
// of the work for their tetrahedra, since the processor has time for it while it computes spheres.
// The arrays of numbers may be read past their ends.
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
        store_upper_halves(s, [&](std::size_t k, FourWords sphere) {
            return finish(slots, size, spheres, begin + k, sphere, link);
        });
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
