// SPDX-License-Identifier: MIT
// The triangulation of the points in a periodic box and of their halo. The halo consists of those
// images of points that the stars of the points need, so that these stars are the stars in the
// triangulation of the infinite periodic set.
//
// The first halo is a shell around the box. Each tetrahedron that has a point of the box as a
// corner and whose circumball leaves the shell is then checked: the halo has to contain all images
// that are in its ball. Missing images are inserted, until none is missing. If a tetrahedron has
// passed the check, its images need no check. docs/theory.md, "Periodic boxes", proves that this
// ends, and what the result is.
#pragma once

#include <optional>

#include "core/triangulation.hpp"
#include "periodic/image.hpp"
#include "periodic/image_grid.hpp"
#include "platform/number_table.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

class Halo {
  public:
    explicit Halo(Allocator& allocator)
        : allocator_(allocator), points_(allocator), images_(allocator), known_(allocator) {}

    // Triangulates the points and the halo that they need. The points are wrapped and on the grid,
    // three coordinates for each. `expected` lists the images of the first halo; any images may be
    // in it. Throws as Triangulation::insert().
    void build(const ImageGrid& grid, Buffer<double>&& points, const Buffer<Image>& expected,
               std::int32_t threads, StageProgress& progress);
    void clear() noexcept;

    // The vertices have the indices of the points of the box first, and then those of the images.
    const Triangulation& triangulation() const { return *triangulation_; }
    std::size_t own_count() const { return own_; }
    std::size_t point_count() const { return points_.size() / 3; }
    bool is_own(std::uint32_t index) const { return index < own_; }
    const double* point(std::uint32_t index) const {
        return points_.begin() + 3 * std::size_t{index};
    }
    // The first of the points of the box that are at the same place as this one.
    std::uint32_t vertex_of(std::uint32_t point) const {
        return triangulation_->mesh().vertices[triangulation_->point_map()[point]].index;
    }
    // The image that a point of the triangulation is. After a build, it is an image of the first of
    // equal points.
    Image image(std::uint32_t index) const {
        return index < own_ ? Image{index, {}} : images_[index - own_];
    }
    // An image that is a corner of a tetrahedron with a point of the box, and one such point.
    struct UsedImage {
        std::uint32_t by;
        Image image;
    };
    // Appends each of these images once.
    void list_used_images(Buffer<UsedImage>& used) const;
    // Memory that the allocator of the halo does not count.
    std::size_t bytes_elsewhere() const;
    // The width of the shell along vector k, as a share of the vector: the halo contains all images
    // whose coordinate along this vector exceeds the box by at most this much. The width is at most
    // `first_width` times the spacing that the same number of points would have if they filled the
    // box evenly.
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
    // The widths of the shell, see shell().
    double shell_[3] = {};
    std::size_t own_ = 0;
    unsigned rounds_ = 0;
    bool passes_through_ = false;  // whether the triangulation uses the allocator
};

}  // namespace mgdt
