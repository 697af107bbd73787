// SPDX-License-Identifier: MIT
// Merges points of a box that have images near to each other.
#pragma once

#include "periodic/image_grid.hpp"
#include "platform/memory.hpp"

namespace mgdt {

// Merges points whose images are within `distance` of each other, in the unit of the lattice.
// `wrapped` has the points in the box, three coordinates each, and `taken` the multiples of the
// basis by which they were moved there. Points are processed in their order. A point is merged with
// the first earlier, unmerged point that has an image within the distance: it gets the coordinates
// of that point, and the multiples of that image. Distances are rounded. Throws
// MGDT_ERR_INVALID_ARGUMENT if the distance is more than an eighth of the least distance between
// opposite faces of the box.
void merge_points(const ImageGrid& grid, double distance, Buffer<double>& wrapped,
                  Buffer<Multiples>& taken, Allocator& allocator);

}  // namespace mgdt
