// SPDX-License-Identifier: MIT
#define MGDT_ISA avx2_test
#include "kernel/ties.hpp"
#include "ties.hpp"

int modulo_avx2(const mgdt::Tetrahedron& t, const mgdt::Vertex* vertices, const double* q) {
    const mgdt::FourRows rows([&](unsigned k) { return vertices[t.v[k]].x; });
    const auto relative = [](__m256d v, double x) { return _mm256_sub_pd(v, _mm256_set1_pd(x)); };
    constexpr double units = 1.5 * 0x1p52;
    return mgdt::decided_modulo(relative(rows.first, q[0]), relative(rows.second, q[1]),
                                relative(rows.third, q[2]), units);
}

int ties_avx2(const mgdt::Tetrahedron& t, const mgdt::Vertex* vertices, const double* q) {
    return mgdt::perturbed_doubles(t, vertices, mgdt::Query(q));
}
