// SPDX-License-Identifier: MIT
// Volume, area and centroid of a cell whose faces are known exactly, in as many digits as it takes.
#pragma once

#include "dual/cell_faces.hpp"
#include "dual/face_sums.hpp"

namespace mgdt {

class ExactMeasures {
  public:
    explicit ExactMeasures(Allocator& allocator) : sums_(allocator), corners_(allocator) {}

    // Of a bounded cell of a vertex at `point`, of the mesh with this scale: one double, or the
    // three of a centroid. The error is below measure_error.
    void measure(CellFaces& faces, const double* point, int scale, Measure measure, double* x);

    // The stages, one by one: in twofold numbers, lengths being multiplied by 2^exponent; in long
    // ones, cut off to a number of limbs. False where the error may be above measure_error.
    bool in_twofold(CellFaces& faces, const double* point, int scale, int exponent, Measure measure,
                    double* x);
    bool in_long(CellFaces& faces, const double* point, int scale, std::size_t limbs,
                 Measure measure, double* x);

  private:
    template <Measure M>
    bool add_twofold(CellFaces& faces, int exponent);

    FaceSums<Twofold> sums_;
    Buffer<Corner<Twofold>> corners_;
};

}  // namespace mgdt
