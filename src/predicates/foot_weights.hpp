// SPDX-License-Identifier: MIT
// The foot of the perpendicular from a point to a plane or a line. Its weights are ratios of exact
// determinants, for all finite doubles and every triangle, however thin.
#pragma once

namespace mgdt {

// The weights of a, b and c, which are not on one line, at the point of their plane that is nearest
// to q. Each has a relative error below 3.01 * 2^-53, plus 2^-1075 if it is subnormal
// (docs/theory.md, "Values between points"). So their signs are exact.
void foot_weights(const double* a, const double* b, const double* c, const double* q,
                  double (&w)[3]);
// The weights of two different points a and b at the point of the line ab that is nearest to q,
// with the same bound on the error.
void foot_weights(const double* a, const double* b, const double* q, double (&w)[2]);

}  // namespace mgdt
