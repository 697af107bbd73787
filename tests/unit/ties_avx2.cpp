// SPDX-License-Identifier: MIT
#define MGDT_ISLAND avx2
#include "kernel/ties.hpp"
#include "ties.hpp"

int modulo_avx2(const mgdt::Tetrahedron& t, const mgdt::Vertex* vertices, const double* q) {
    const mgdt::Transpose4 rows([&](unsigned k) { return vertices[t.v[k]].x; });
    using mgdt::Four;
    const auto [x, y, z] =
        mgdt::relative_to(rows, {Four::all(q[0]), Four::all(q[1]), Four::all(q[2])});
    constexpr double units = 1.5 * 0x1p52;
    return mgdt::decided_modulo(x, y, z, units);
}

int ties_avx2(const mgdt::Tetrahedron& t, const mgdt::Vertex* vertices, const double* q) {
    return mgdt::perturbed_doubles(t, vertices, mgdt::Query(q));
}
