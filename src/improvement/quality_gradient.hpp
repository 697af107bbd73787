// SPDX-License-Identifier: MIT
// How the quality of a tetrahedron changes while one of its corners moves.
#pragma once

namespace mgdt {

// The quality of a tetrahedron abcd, as quality_of() gives it, and its gradient with respect to the
// position of a. Where several dihedral angles are the worst, the gradient is that of one of them.
struct QualityGradient {
    double quality;
    double by[3];
};
QualityGradient quality_gradient(const double* a, const double* b, const double* c,
                                 const double* d) noexcept;

}  // namespace mgdt
