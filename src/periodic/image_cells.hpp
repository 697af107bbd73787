// SPDX-License-Identifier: MIT
// A grid of cells in a periodic box, of which those are marked whose points have images that may be
// wanted. Ranges of coordinates are those of images, and cells repeat with the periods.
#pragma once

#include <cstdint>

#include "platform/memory.hpp"

namespace mgdt {

class ImageCells {
  public:
    explicit ImageCells(Allocator& allocator) : sums_(allocator), marks_(allocator) {}

    // Cells of which none is marked, for n points. Directions without periods are not divided.
    void make(unsigned dimensions, std::size_t n);
    // Gives the memory back.
    void reset() noexcept {
        sums_.reset();
        marks_.reset();
    }
    // Whether all cells with places in a range are marked. add() may not have been called since
    // mark().
    bool has_all(const double (&low)[3], const double (&high)[3]) const;
    // Adds the cells with places in a range, and those that are very near to it, to the cells that
    // mark() marks. What was marked stays so.
    void add(const double (&low)[3], const double (&high)[3]);
    void mark();
    // Whether the cell of a point is marked, whose coordinates are from 0 to 1, or a little less or
    // more.
    bool has(const double (&s)[3]) const;

  private:
    // Cells from `first`, which is in the box, to `last`, which may be in the next one.
    struct Block {
        std::uint32_t first[3], last[3];
    };
    Block block_of(const double (&low)[3], const double (&high)[3], double distance) const;
    // Calls visit(at, sign) for the places of a block's eight corners in sums_. The sign is 1 at
    // the first cell and changes with each direction in which the corner is behind the last cell.
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
    // For the cells of two boxes along each direction, and one more: if blocks were added since
    // mark(), the differences of the number of blocks that have the cells; otherwise the number of
    // marked cells below.
    Buffer<std::int32_t> sums_;
    Buffer<std::uint8_t> marks_;
    std::int32_t added_ = 0;  // blocks since mark()
};

}  // namespace mgdt
