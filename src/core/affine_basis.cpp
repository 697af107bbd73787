// SPDX-License-Identifier: MIT
#include "core/affine_basis.hpp"

#include "mesh/scale.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

bool AffineBasis::add(const double* p) {
    bool independent = false;
    switch (size_) {
        case 0:
            independent = true;
            break;
        case 1:
            independent = compare_lexicographic(points_[0], p) != 0;
            break;
        case 2:
            independent = !collinear(points_[0], points_[1], p);
            break;
        case 3:
            independent = orientation(points_[0], points_[1], points_[2], p) != 0;
            break;
        default:
            break;
    }
    if (!independent) return false;
    for (int k = 0; k < 3; ++k) points_[size_][k] = p[k];
    ++size_;
    return true;
}

void AffineBasis::scale(int change) {
    for (int i = 0; i < size_; ++i)
        for (double& x : points_[i]) x = scaled(x, change);
}

}  // namespace mgdt
