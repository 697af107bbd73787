// SPDX-License-Identifier: MIT
// Makes points of a box equal that have images near to each other.
#pragma once

#include "periodic/image_grid.hpp"
#include "platform/memory.hpp"

namespace mgdt {

// `wrapped` has the points in the box, three coordinates each, and `taken` the multiples of the
// basis that were taken from them. A point of which an image is within `distance`, in the unit of
// the lattice, of an earlier point that stays, moves onto the first such image in the order of the
// points and multiples: it gets the coordinates of that point and the multiples that fit.
// Distances are rounded. Throws MGDT_ERR_INVALID_ARGUMENT if the distance is more than an eighth of
// the least distance between the box's faces.
void merge_points(const ImageGrid& grid, double distance, Buffer<double>& wrapped,
                  Buffer<Multiples>& taken, Allocator& allocator);

}  // namespace mgdt
