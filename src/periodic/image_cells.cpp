// SPDX-License-Identifier: MIT
#include "periodic/image_cells.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace mgdt {
namespace {

// The number of cells per point. If points are spread evenly, a cell has a few of them; with more
// cells, the cells would take more time than the points.
constexpr double cells_per_point = 0.25;
constexpr double most_cells = 64;  // along a vector
// Ranges are widened by this much, which exceeds the rounding errors of coordinates of a few boxes.
constexpr double slack = 0x1p-40;
// Cells within this distance of a range, in sides of a cell, are marked too, because later rounds
// are likely to need them.
constexpr double margin = 0.25;
// With at most this many blocks, the sums are below 2^31.
constexpr std::int32_t most_blocks = std::int32_t{1} << 30;

}  // namespace

void ImageCells::make(unsigned dimensions, std::size_t n) {
    const double cells = std::cbrt(cells_per_point * static_cast<double>(n));
    for (unsigned k = 0; k < 3; ++k)
        cells_[k] = k < dimensions
                        ? static_cast<std::uint32_t>(std::min(std::max(cells, 1.0), most_cells))
                        : 1;
    added_ = 0;
    marks_.clear();
    marks_.resize(std::size_t{cells_[0]} * cells_[1] * cells_[2], std::uint8_t{0});
    clear_sums();
}

void ImageCells::clear_sums() {
    sums_.clear();
    sums_.resize(std::size_t{width(0)} * width(1) * width(2), 0);
}

ImageCells::Block ImageCells::block_of(const double (&low)[3], const double (&high)[3],
                                       double distance) const {
    Block block = {};
    for (unsigned k = 0; k < 3; ++k) {
        if (cells_[k] == 1) continue;
        const double n = cells_[k];
        const double first = std::floor((low[k] - slack) * n - distance);
        const double last = std::floor((high[k] + slack) * n + distance);
        const double box = std::floor(first / n) * n;
        const bool is_all = !(last - first < n);
        block.first[k] = is_all ? 0 : static_cast<std::uint32_t>(first - box);
        block.last[k] = is_all ? cells_[k] - 1 : static_cast<std::uint32_t>(last - box);
    }
    return block;
}

std::uint32_t ImageCells::cell_of(double s, unsigned k) const {
    const std::uint32_t n = cells_[k];
    if (n == 1) return 0;
    // Because of rounding, s may be in the previous or in the next box.
    const auto cell = static_cast<std::uint32_t>((s + 1) * n);
    return cell < n ? cell : cell < 2 * n ? cell - n : cell - 2 * n;
}

bool ImageCells::has(const double (&s)[3]) const {
    return marks_[mark_at(cell_of(s[0], 0), cell_of(s[1], 1), cell_of(s[2], 2))] != 0;
}

template <class Visit>
void ImageCells::each_corner(const Block& block, const Visit& visit) const {
    for (unsigned end = 0; end < 8; ++end) {
        std::uint32_t at[3];
        std::int32_t sign = 1;
        for (unsigned k = 0; k < 3; ++k) {
            const bool is_last = (end >> k & 1) != 0;
            at[k] = is_last ? block.last[k] + 1 : block.first[k];
            if (is_last) sign = -sign;
        }
        visit(sum_at(at[0], at[1], at[2]), sign);
    }
}

bool ImageCells::has_all(const double (&low)[3], const double (&high)[3]) const {
    assert(added_ == 0 && "cells that were added are to be marked first");
    const Block block = block_of(low, high, 0);
    std::int32_t marked = 0, size = 1;
    for (unsigned k = 0; k < 3; ++k)
        size *= static_cast<std::int32_t>(block.last[k] - block.first[k] + 1);
    each_corner(block, [&](std::size_t at, std::int32_t sign) { marked -= sign * sums_[at]; });
    return marked == size;
}

void ImageCells::add(const double (&low)[3], const double (&high)[3]) {
    if (added_ == most_blocks) mark();
    if (added_++ == 0) clear_sums();
    each_corner(block_of(low, high, margin),
                [&](std::size_t at, std::int32_t sign) { sums_[at] += sign; });
}

// Replaces each number by the sum of all numbers up to it.
void ImageCells::sum_up() {
    const std::size_t steps[3] = {sum_at(1, 0, 0), sum_at(0, 1, 0), 1};
    for (unsigned axis = 0; axis < 3; ++axis)
        for (std::uint32_t i = axis == 0 ? 1 : 0; i < width(0); ++i)
            for (std::uint32_t j = axis == 1 ? 1 : 0; j < width(1); ++j)
                for (std::uint32_t k = axis == 2 ? 1 : 0; k < width(2); ++k)
                    sums_[sum_at(i, j, k)] += sums_[sum_at(i, j, k) - steps[axis]];
}

void ImageCells::mark() {
    sum_up();
    const auto mark_below = [&](std::uint32_t i, std::uint32_t j,
                                std::uint32_t k) -> std::uint8_t& {
        const auto in_box = [&](std::uint32_t at, unsigned axis) {
            return at < cells_[axis] ? at : at - cells_[axis];
        };
        return marks_[mark_at(in_box(i, 0), in_box(j, 1), in_box(k, 2))];
    };
    for (std::uint32_t i = 0; i + 1 < width(0); ++i)
        for (std::uint32_t j = 0; j + 1 < width(1); ++j)
            for (std::uint32_t k = 0; k + 1 < width(2); ++k)
                if (sums_[sum_at(i, j, k)] > 0) mark_below(i, j, k) = 1;
    added_ = 0;
    clear_sums();
    for (std::uint32_t i = 1; i < width(0); ++i)
        for (std::uint32_t j = 1; j < width(1); ++j)
            for (std::uint32_t k = 1; k < width(2); ++k)
                sums_[sum_at(i, j, k)] = mark_below(i - 1, j - 1, k - 1);
    sum_up();
}

}  // namespace mgdt
