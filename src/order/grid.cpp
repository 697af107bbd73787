// SPDX-License-Identifier: MIT
#include "order/grid.hpp"

#include <cmath>
#include <utility>

namespace mgdt {
namespace {

// Scales the extents so that all are finite and can be compared.
void comparable_extents(const Box& box, double extent[3]) noexcept {
    const double unit = box.longest() > 0x1p1023 ? 0.5 : 1.0;
    for (int k = 0; k < 3; ++k) extent[k] = box.high[k] * unit - box.low[k] * unit;
}

// C libraries round cbrt differently in the last bit; rounding to float hides that.
double cube_root(double x) noexcept {
    return static_cast<float>(std::cbrt(x));
}

void divide(const Box& box, double cells, std::uint32_t count[3]) noexcept {
    double extent[3];
    comparable_extents(box, extent);
    int axis[3] = {0, 1, 2};  // from the longest to the shortest
    if (extent[axis[0]] < extent[axis[1]]) std::swap(axis[0], axis[1]);
    if (extent[axis[1]] < extent[axis[2]]) std::swap(axis[1], axis[2]);
    if (extent[axis[0]] < extent[axis[1]]) std::swap(axis[0], axis[1]);
    const double a = extent[axis[0]], b = extent[axis[1]], c = extent[axis[2]];

    double divisions[3] = {1, 1, 1};
    // The formulas use ratios, since the product of the extents may overflow.
    const double shortest = b > 0 ? cube_root(cells * (c / a) * (c / b)) : 0;
    const double middle = a > 0 ? std::sqrt(cells * (b / a)) : 0;
    if (shortest >= 0.5) {
        divisions[2] = shortest;
        divisions[1] = shortest * (b / c);
        divisions[0] = shortest * (a / c);
    } else if (middle >= 0.5) {
        divisions[1] = middle;
        divisions[0] = middle * (a / b);
    } else if (a > 0) {
        divisions[0] = cells;
    }
    for (int k = 0; k < 3; ++k) {
        count[axis[k]] = static_cast<std::uint32_t>(std::floor(divisions[k] + 0.5));
    }
}

}  // namespace

Grid::Grid(const PointSet& points, const Box& box, std::size_t n, double points_per_cell,
           const double* from) noexcept {
    constexpr double most_cells = 0x1p29;
    double cells = static_cast<double>(n) / points_per_cell;
    if (cells > most_cells) cells = most_cells;
    if (cells > 1) divide(box, cells, count_);
    lattice_ = Lattice::divide(points, box, count_);
    for (int k = 0; from && k < 3; ++k) {
        reversed_[k] = from[k] * 0.5 - box.low[k] * 0.5 > box.high[k] * 0.5 - from[k] * 0.5;
    }
}

}  // namespace mgdt
