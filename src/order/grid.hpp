// SPDX-License-Identifier: MIT
// A regular grid over a box and the serpentine path through its cells.
#pragma once

#include <cstddef>
#include <cstdint>

#include "order/cell_numbers.hpp"

namespace mgdt {

// S.H. Lo (2014), section 4.1: for N points with n points per cell, in a box with sides R, alpha =
// cbrt(N / (n Rx Ry Rz)), and each axis has NINT(alpha R) divisions. If this number is 0 for an
// axis, the axis is left undivided and alpha is computed again for the other axes alone. So flat
// and thin boxes also have about N / n cells (at most 4 N / n, and 2^31).
class Grid {
  public:
    // The path begins at the corner cell nearest to the point `from`, or at the low corner if
    // `from` is null.
    Grid(const PointSet& points, const Box& box, std::size_t n, double points_per_cell,
         const double* from = nullptr) noexcept;

    std::size_t cells() const noexcept {
        return static_cast<std::size_t>(count_[0]) * count_[1] * count_[2];
    }
    const std::uint32_t* count() const noexcept { return count_; }

    // The cell of a point along each axis.
    void locate(const PointSet& points, std::size_t i, std::uint32_t cell[3]) const noexcept {
        for (int k = 0; k < 3; ++k) cell[k] = lattice_.step(points, i, k);
    }

    // The position of a point's cell on the path, 0..cells-1. The path follows a row in x and the
    // next row backwards, and continues in the layer above where the layer below ended (Figure 13).
    // Consecutive cells share a face.
    std::uint32_t path(const PointSet& points, std::size_t i) const noexcept {
        std::uint32_t c[3];
        locate(points, i, c);
        for (int k = 0; k < 3; ++k) {
            if (reversed_[k]) c[k] = count_[k] - 1 - c[k];
        }
        const std::uint32_t row = c[2] & 1 ? count_[1] - 1 - c[1] : c[1];
        const std::uint32_t line = c[2] * count_[1] + row;
        const std::uint32_t column = line & 1 ? count_[0] - 1 - c[0] : c[0];
        return line * count_[0] + column;
    }

  private:
    std::uint32_t count_[3] = {1, 1, 1};
    bool reversed_[3] = {false, false, false};
    Lattice lattice_;
};

// Sorts n points, of which index(j) is the j-th, along the path of a grid, into `order`. Points of
// one cell keep their order. path[j] becomes the position of the cell of point j on the path.
// ends[c] becomes the end, in `order`, of the points of the cell at position c.
template <class Index>
void sort_along_path(const Grid& grid, const PointSet& points, std::size_t n, Index index,
                     std::uint32_t* path, Buffer<std::uint32_t>& ends, std::uint32_t* order) {
    ends.clear();
    ends.resize(grid.cells() + 1, 0);
    for (std::size_t j = 0; j < n; ++j) {
        path[j] = grid.path(points, index(j));
        ++ends[path[j] + std::size_t{1}];
    }
    for (std::size_t c = 1; c < ends.size(); ++c) ends[c] += ends[c - 1];
    // At this point, ends[c] is where the points at position c begin. Writing the points moves
    // ends[c] to where they end.
    for (std::size_t j = 0; j < n; ++j) order[ends[path[j]]++] = index(j);
}

}  // namespace mgdt
