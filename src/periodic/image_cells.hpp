// SPDX-License-Identifier: MIT
// A grid of cells in a periodic box. Some cells are marked: their points have images that may be
// wanted. The ranges of coordinates that functions take are those of images; the cells repeat with
// the periods.
#pragma once

#include <cstdint>

#include "platform/memory.hpp"

namespace mgdt {

class ImageCells {
  public:
    explicit ImageCells(Allocator& allocator) : sums_(allocator), marks_(allocator) {}

    // Makes a grid for n points, without marked cells. Directions without periods are not divided.
    void make(unsigned dimensions, std::size_t n);
    // Gives the memory back.
    void reset() noexcept {
        sums_.reset();
        marks_.reset();
    }
    // Whether all cells that meet a range are marked. mark() has been called since the last add().
    bool has_all(const double (&low)[3], const double (&high)[3]) const;
    // Adds the cells that meet a range, or are very near to it, to those that the next mark()
    // marks. Marked cells stay marked.
    void add(const double (&low)[3], const double (&high)[3]);
    void mark();
    // Whether the cell of a point is marked. The coordinates of the point are from 0 to 1, within
    // rounding.
    bool has(const double (&s)[3]) const;

  private:
    // The cells from `first` to `last`. `first` is in the box, and `last` may be in the next box.
    struct Block {
        std::uint32_t first[3], last[3];
    };
    Block block_of(const double (&low)[3], const double (&high)[3], double distance) const;
    // Calls visit(at, sign) for the positions in sums_ of the eight corners of a block. The sign is
    // 1 at the first cell, and changes with each direction in which the corner is behind the last
    // cell.
    template <class Visit>
    void each_corner(const Block& block, const Visit& visit) const;
    std::uint32_t cell_of(double s, unsigned k) const;
    std::size_t sum_at(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
        return (std::size_t{i} * width(1) + j) * width(2) + k;
    }
    std::size_t mark_at(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
        return (std::size_t{i} * cells_[1] + j) * cells_[2] + k;
    }
    std::uint32_t width(unsigned k) const { return 2 * cells_[k] + 1; }
    void clear_sums();
    void sum_up();

    std::uint32_t cells_[3] = {1, 1, 1};
    // For the cells of two boxes along each direction, and one more cell: after add(), the
    // differences of the number of blocks that contain a cell; after mark(), the number of marked
    // cells below a cell.
    Buffer<std::int32_t> sums_;
    Buffer<std::uint8_t> marks_;
    std::int32_t added_ = 0;  // blocks since mark()
};

}  // namespace mgdt
