// SPDX-License-Identifier: MIT
// The triangulation of the points in a periodic box and of their halo: the images of points that
// the stars of these points need to be those of the infinite periodic set.
//
// The first halo is a shell around the box. Then every tetrahedron at a point of the box whose
// circumball leaves the shell is looked at: the images in its ball have to be known. Those that are
// not are inserted, until there are none. A tetrahedron that was found right is right at all its
// images too. docs/theory.md, "Periodic boxes", proves that this ends and what the result is.
#pragma once

#include <optional>

#include "core/triangulation.hpp"
#include "periodic/image_cells.hpp"
#include "periodic/image_grid.hpp"
#include "periodic/point_tree.hpp"
#include "platform/number_table.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

// The image of a point of the box: the point plus multiples of the lattice's basis.
struct Image {
    std::uint32_t point;
    std::int8_t of[4];  // three multiples and 0

    Multiples multiples() const { return {of[0], of[1], of[2]}; }
};

// The multiples are at most 127.
inline Image image_of(std::uint32_t point, const Multiples& k) {
    return {point,
            {static_cast<std::int8_t>(k[0]), static_cast<std::int8_t>(k[1]),
             static_cast<std::int8_t>(k[2]), 0}};
}

// A number for each image. Numbers have the order by points, then by multiples.
inline std::uint64_t order_of(const Image& image) {
    const auto part = [&](unsigned c) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(image.of[c]) + 128);
    };
    return std::uint64_t{image.point} << 24 | part(0) << 16 | part(1) << 8 | part(2);
}
inline Image image_of_order(std::uint64_t order) {
    const auto multiple = [&](unsigned shift) {
        return static_cast<std::int32_t>(order >> shift & 0xFF) - 128;
    };
    return image_of(static_cast<std::uint32_t>(order >> 24),
                    {multiple(16), multiple(8), multiple(0)});
}
inline bool is_before(const Image& a, const Image& b) {
    return order_of(a) < order_of(b);
}

class Halo {
  public:
    explicit Halo(Allocator& allocator)
        : allocator_(allocator),
          points_(allocator),
          images_(allocator),
          known_(allocator),
          basic_round_(allocator),
          candidate_cells_(allocator),
          candidates_(allocator),
          classes_(allocator),
          class_numbers_(allocator) {}

    // Triangulates points that are wrapped and on the grid, three coordinates each, and what halo
    // they need. The first halo has the images that are expected, which may be any. Throws as
    // Triangulation::insert().
    void build(const ImageGrid& grid, Buffer<double>&& points, const Buffer<Image>& expected,
               std::int32_t threads, StageProgress& progress, const StopRequest& stop);
    void clear() noexcept;

    // The points of the box come first, then the images, in the order of their indices in the
    // triangulation.
    const Triangulation& triangulation() const { return *triangulation_; }
    std::size_t own_count() const { return own_; }
    std::size_t point_count() const { return points_.size() / 3; }
    bool is_own(std::uint32_t index) const { return index < own_; }
    const double* point(std::uint32_t index) const {
        return points_.begin() + 3 * std::size_t{index};
    }
    // The least point of the box at the place of one.
    std::uint32_t vertex_of(std::uint32_t point) const {
        return triangulation_->mesh().vertices[triangulation_->point_map()[point]].index;
    }
    // What a point of the triangulation is an image of. Once the halo is built, that is the least
    // of equal points.
    Image image(std::uint32_t index) const {
        return index < own_ ? Image{index, {}} : images_[index - own_];
    }
    // An image that is a corner of a tetrahedron with a point of the box.
    struct UsedImage {
        std::uint32_t by;
        Image image;
    };
    // Appends each such image once, with one of these points.
    void list_used_images(Buffer<UsedImage>& used) const;
    // Memory that the allocator of the halo does not count.
    std::size_t bytes_elsewhere() const;
    // Of the points of the box, all images are in the halo whose coordinate along vector k exceeds
    // the box by no more than this, which is first_width times the distance of points that fill the
    // box evenly, or less.
    double shell(unsigned k) const { return shell_[k]; }
    static constexpr double first_width = 1.6;
    // The number of rounds in which images were added to the first halo.
    unsigned rounds() const { return rounds_; }

  private:
    class Round;
    friend class Round;
    void add_first_halo();
    std::uint32_t number_of(const Image& image) const;
    bool add(const Image& image);
    void insert(std::size_t first, StageProgress& progress);

    Allocator& allocator_;
    const ImageGrid* grid_ = nullptr;
    std::optional<Triangulation> triangulation_;
    Buffer<double> points_;
    Buffer<Image> images_;
    NumberTable known_;  // of images_
    // For each point of the box, the round in which the images were added that bound the cell of a
    // lattice point, counted from 1, or 0.
    Buffer<std::uint32_t> basic_round_;
    // All images are known whose coordinates exceed the box by no more.
    double shell_[3] = {};
    // Points of the box with images that may be needed: those in the marked cells.
    ImageCells candidate_cells_;
    PointTree candidates_;
    // Classes of tetrahedra, up to multiples of the lattice, whose balls are not in the shell.
    // Their memory is given back at the end of a build.
    struct Class {
        Image corners[4];     // sorted, and moved such that the multiples of the first are 0
        std::uint32_t round;  // in which its ball was looked at, counted from 1; or 0
        bool is_right;        // whether it is one of the infinite set's
    };
    std::uint32_t class_of(const Tetrahedron& tetrahedron);
    Buffer<Class> classes_;
    NumberTable class_numbers_;
    std::size_t own_ = 0;
    unsigned rounds_ = 0;
    bool passes_through_ = false;  // whether the triangulation uses the allocator
};

}  // namespace mgdt
