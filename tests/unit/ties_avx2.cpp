// SPDX-License-Identifier: MIT
#define MGDT_ISA avx2_test
#include "kernel/ties.hpp"
#include "ties.hpp"

int ties_avx2(const mgdt::Tetrahedron& t, const mgdt::Vertex* vertices, const double* q) {
    return mgdt::perturbed_doubles(t, vertices, mgdt::Query(q));
}
