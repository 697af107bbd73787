// SPDX-License-Identifier: MIT
// Powers with respect to four tetrahedra: see kernel/powers.hpp. The records and base vertices are
// transposed in registers. So a test takes about fifteen instructions, and the four cache lines are
// loaded in parallel. Spheres that are not stored are computed for all four tetrahedra together.
#pragma once

#include "kernel/four.hpp"
#include "kernel/sphere_source.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// Four copies of a point.
struct QueryRows {
    MGDT_ALWAYS_INLINE explicit QueryRows(const Query& q)
        : x(q.x), y(q.y), z(q.z), quadratic(q.quadratic) {}
    Four x, y, z, quadratic;
};

class FourPowers {
  public:
    template <class Spheres, class Tetrahedra>
    MGDT_ALWAYS_INLINE FourPowers(const Spheres& from, const Tetrahedra& four, const Query& q)
        : FourPowers(from, four, QueryRows(q)) {}
    template <class Tetrahedra>
    MGDT_ALWAYS_INLINE FourPowers(const KeptSpheres& from, const Tetrahedra& four,
                                  const QueryRows& q) {
        set(Transpose4::of_upper_halves([&](unsigned k) { return four.sphere(k).w; }),
            vertices(from, four, 0), q);
    }
    template <class Tetrahedra>
    FourPowers(const ComputedSpheres& from, const Tetrahedra& four, const QueryRows& q) {
        const Transpose4 bases = vertices(from, four, 0);
        const auto local = [&](unsigned i) {
            return LocalColumns<Four>(
                relative_to(vertices(from, four, i), {bases.first, bases.second, bases.third}));
        };
        const SphereColumns<Four> s = spheres_through<false>(local(1), local(2), local(3));
        Transpose4 spheres = {s.x, s.y, s.z, s.e};
        std::uint32_t special = from.has_extremes ? 0xFu : 0u;
        for (unsigned k = 0; k < 4; ++k)
            special |= static_cast<std::uint32_t>(four[k].is_ghost()) << k;
        if (MGDT_UNLIKELY(special != 0)) replace(spheres, special, from, four);
        set(spheres, bases, q);
    }

    // The next three functions return bits, with the first tetrahedron in the lowest bit: where the
    // power is negative, where its sign is certain, and which tetrahedra are ghosts.
    MGDT_ALWAYS_INLINE std::uint32_t negative() const { return value_.signs().bits(); }
    MGDT_ALWAYS_INLINE std::uint32_t decided() const { return (magnitude(value_) > error_).bits(); }
    MGDT_ALWAYS_INLINE std::uint32_t ghosts() const { return ghosts_.bits(); }
    MGDT_ALWAYS_INLINE Power operator[](unsigned k) const {
        return {element(value_, k), element(error_, k)};
    }
    // Where the power is certainly greater than that of another tetrahedron; for a ghost, where its
    // value is certainly positive.
    MGDT_ALWAYS_INLINE std::uint32_t above(Power other) const {
        const Four floor = where(ghosts_, 0.0, other.value + other.error);
        return (value_ - floor > error_).bits();
    }
    // The finite tetrahedron of least power, if that power is below the bound; otherwise 4.
    MGDT_ALWAYS_INLINE unsigned least_finite(double bound) const {
        const Four finite = where(ghosts_, infinity, value_);
        const Four least = least_everywhere(finite);
        return least.first() < bound ? lowest_bit((finite == least).bits() | 16u) : 4;
    }

  private:
    // The i-th vertex of each tetrahedron. The second one may have a mark.
    template <class Spheres, class Tetrahedra>
    MGDT_ALWAYS_INLINE static Transpose4 vertices(const Spheres& from, const Tetrahedra& four,
                                                  unsigned i) {
        const VertexId mask = i == 1 ? ~in_cavity : ~VertexId{0};
        return Transpose4([&](unsigned k) { return from.vertices[four[k].v[i] & mask].x; });
    }
    // Replaces the spheres of special tetrahedra: of ghosts, and of all if the mesh has extreme
    // vertices. These cases are rare enough to compute the spheres one by one. The choice does not
    // depend on the other three tetrahedra, so each tetrahedron has one computed power.
    template <class Tetrahedra>
    static void replace(Transpose4& spheres, std::uint32_t special, const ComputedSpheres& from,
                        const Tetrahedra& four) {
        alignas(32) double columns[4][4];
        Four* const column[4] = {&spheres.first, &spheres.second, &spheres.third, &spheres.fourth};
        for (unsigned i = 0; i < 4; ++i) column[i]->store(columns[i]);
        for (unsigned k = 0; k < 4; ++k) {
            if (!(special >> k & 1)) continue;
            const Sphere s = from.sphere(four, k);
            for (unsigned i = 0; i < 3; ++i) columns[i][k] = s.w[i];
            columns[3][k] = s.e;
        }
        for (unsigned i = 0; i < 4; ++i) *column[i] = Four::load(columns[i]);
    }
    MGDT_ALWAYS_INLINE void set(const Transpose4& spheres, const Transpose4& bases,
                                const QueryRows& q) {
        // u = q - p, value = |u|^2 - w . u, error = |e| (|u.x| + |u.y| + |u.z|) + quadratic |u|^2
        const auto [ux, uy, uz] =
            PointColumns<Four>{q.x - bases.first, q.y - bases.second, q.z - bases.third};
        const auto& [wx, wy, wz, e] = spheres;
        ghosts_ = e.signs();
        // A ghost has no quadratic term.
        const Four square =
            zero_where(FourMask(ghosts_), multiply_add(uz, uz, multiply_add(uy, uy, ux * ux)));
        value_ = square - multiply_add(wz, uz, multiply_add(wy, uy, wx * ux));
        const Four length = magnitude(uz) + (magnitude(uy) + magnitude(ux));
        error_ = multiply_add(magnitude(e), length, q.quadratic * square);
    }
    MGDT_ALWAYS_INLINE static double element(Four of, unsigned k) {
        alignas(32) double all[4];
        of.store(all);
        return all[k];
    }

    Four value_, error_;
    FourSigns ghosts_;  // the sign bits of e
};

}  // namespace MGDT_ISLAND
}  // namespace mgdt
