// SPDX-License-Identifier: MIT
// Up to four affinely independent points, found one at a time by exact tests.
#pragma once

namespace mgdt {

class AffineBasis {
  public:
    // Adds the point if it is not in the affine hull of the points so far. Returns whether it did.
    bool add(const double* p);
    // -1 empty, 0 a point, 1 a line, 2 a plane, 3 space.
    int dimension() const { return size_ - 1; }
    void clear() { size_ = 0; }
    // Multiplies the points by 2^change.
    void scale(int change);

  private:
    double points_[4][3];
    int size_ = 0;
};

}  // namespace mgdt
