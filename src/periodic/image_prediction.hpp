// SPDX-License-Identifier: MIT
// Predicts which images the halo of many points will have, from samples of the points.
#pragma once

#include "periodic/halo.hpp"

namespace mgdt {

// Appends images to `expected` if the points will need many more images than a shell around the box
// has. Points on lines and surfaces do; without a prediction, their halo takes many rounds. The
// points are wrapped and on the grid. Throws as Halo::build().
void predict_images(const ImageGrid& grid, const Buffer<double>& points, std::int32_t threads,
                    StageProgress& progress, Buffer<Image>& expected);

}  // namespace mgdt
