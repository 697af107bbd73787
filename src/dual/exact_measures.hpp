// SPDX-License-Identifier: MIT
// Volume, area and centroid of a cell whose faces are known exactly, computed in as many digits as
// the accuracy needs.
#pragma once

#include "dual/cell_faces.hpp"
#include "dual/face_sums.hpp"

namespace mgdt {

class ExactMeasures {
  public:
    // Measures the bounded cell of the vertex at `point`, where `scale` is the scale of the mesh.
    // The result is width_of(measure) doubles. The error is below measure_error.
    static void measure(CellFaces& faces, const double* point, int scale, Measure measure,
                        double* x);

    // The stages of measure(), which tests call one by one. A stage returns false if its error may
    // exceed measure_error. In the last stage, each long number is cut off to `limbs` limbs.
    enum class Stage { doubles, twofold, long_numbers };
    static bool measure_in(Stage stage, CellFaces& faces, const double* point, int scale,
                           Measure measure, double* x, std::size_t limbs = 256 / exact::limb_bits);
};

}  // namespace mgdt
