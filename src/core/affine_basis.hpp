// SPDX-License-Identifier: MIT
// Up to four affinely independent points, found one at a time by exact tests.
#pragma once

namespace mgdt {

class AffineBasis {
  public:
    // Adds the point if it is not in the affine hull of the points so far. Returns whether the
    // point was added.
    bool add(const double* p);
    // The dimension of the affine hull: -1 if it is empty, 0 for a point, 1 for a line, 2 for a
    // plane, 3 for space.
    int dimension() const { return size_ - 1; }
    void clear() { size_ = 0; }
    // Multiplies the points by 2^change.
    void scale(int change);

  private:
    double points_[4][3];
    int size_ = 0;
};

}  // namespace mgdt
