// SPDX-License-Identifier: MIT
// Volume, area and centroid of a cell whose faces are known exactly, in as many digits as it takes.
#pragma once

#include "dual/cell_faces.hpp"
#include "dual/face_sums.hpp"

namespace mgdt {

class ExactMeasures {
  public:
    // Of a bounded cell of a vertex at `point`, of the mesh with this scale: one double, or the
    // three of a centroid. The error is below measure_error.
    static void measure(CellFaces& faces, const double* point, int scale, Measure measure,
                        double* x);

    // The stages, one by one; long numbers are cut off to a number of limbs. False where the error
    // may be above measure_error.
    enum class Stage { doubles, twofold, long_numbers };
    static bool measure_in(Stage stage, CellFaces& faces, const double* point, int scale,
                           Measure measure, double* x, std::size_t limbs = 256 / exact::limb_bits);
};

}  // namespace mgdt
