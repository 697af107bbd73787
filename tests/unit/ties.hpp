// SPDX-License-Identifier: MIT
// perturbed_doubles() of kernel/ties.hpp as it is compiled for each instruction set.
#pragma once

namespace mgdt {
struct Tetrahedron;
struct Vertex;
}  // namespace mgdt

int ties_baseline(const mgdt::Tetrahedron& t, const mgdt::Vertex* vertices, const double* q);
// Any integers whose determinant is below 2^63.
int modulo_avx2(const mgdt::Tetrahedron& t, const mgdt::Vertex* vertices, const double* q);
int ties_avx2(const mgdt::Tetrahedron& t, const mgdt::Vertex* vertices, const double* q);
