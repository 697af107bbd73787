// SPDX-License-Identifier: MIT
// Points in a periodic box and their triangulation. A build rounds the points to the image_grid.hpp
// of the box_lattice.hpp and moves them into the box, and finds the halo.hpp that their stars need.
// One tetrahedron of each class is listed when it is asked for (periodic_tetrahedra.hpp).
#pragma once

#include <optional>

#include "periodic/periodic_tetrahedra.hpp"
#include "periodic/vertex_neighbors.hpp"
#include "platform/cached.hpp"

namespace mgdt {

struct PeriodicSettings : CallSettings {
    double merge_distance = 0;  // in units of the caller
};

class Periodic {
  public:
    Periodic(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user);

    // Sets one to three vectors, three finite coordinates each, and removes the triangulation. The
    // next build starts with the images that the last one needed, if the number of vectors is the
    // same. Throws MGDT_ERR_INVALID_ARGUMENT, with nothing changed, if the vectors do not span.
    void set_vectors(unsigned dimensions, const double* vectors);
    // Throws an Error if n more points are more than can be numbered.
    void require_room(std::size_t n) const;
    // Appends points, whose coordinates are finite. Every change of the points removes the
    // triangulation.
    void insert(std::size_t n, const double* xyz);
    // Moves points, with indices from 0, to n places. The next build starts with the images that
    // the last triangulation needed. Throws with nothing changed.
    void move(std::size_t n, const std::uint32_t* points, const double* xyz);
    // Triangulates the points. Throws MGDT_ERR_INVALID_ARGUMENT if there are no vectors or if a
    // point is too far from the box, and what Halo::build() throws. After an exception there is no
    // triangulation.
    void build();
    // Removes the points and the triangulation.
    void clear() noexcept;
    StopFlag& stop() const noexcept { return stop_; }

    Allocator& allocator() const noexcept { return allocator_; }
    PeriodicSettings& settings() noexcept { return settings_; }
    const PeriodicSettings& settings() const noexcept { return settings_; }
    // The number of vectors; 0 before they are set.
    unsigned dimensions() const noexcept { return lattice_ ? lattice_->dimensions() : 0; }
    // The unit of the lattice is 2^exponent() units of the caller.
    int exponent() const noexcept { return lattice_->exponent(); }
    // Converts a length in the unit of the lattice to that of the caller, or, with 2 or 3 powers,
    // an area or a volume.
    double to_callers(double x, unsigned powers = 1) const noexcept {
        for (unsigned i = 0; i < powers; ++i) x = lattice_->to_callers(x);
        return x;
    }
    std::size_t point_count() const noexcept { return given_.size() / 3; }
    // Memory that is held.
    std::size_t bytes() const { return allocator_.bytes() + halo_.bytes_elsewhere(); }
    bool has_triangulation() const noexcept { return has_triangulation_; }

    // The results of the last build.
    const ImageGrid& grid() const noexcept { return *grid_; }
    const Halo& halo() const noexcept { return halo_; }
    const PeriodicTetrahedra& tetrahedra() const { return tetrahedra_.get(halo_); }
    const VertexNeighbors& neighbors() const { return neighbors_.get(halo_); }
    // The number of points that are vertices; 0 if there is no triangulation.
    std::size_t vertex_count() const;
    // The least point with the same images.
    std::uint32_t vertex_of(std::uint32_t point) const { return halo_.vertex_of(point); }
    // Takes an image relative to the wrapped place of a point of the box. Returns its shift
    // relative to where the caller has put that point: how many times each of the caller's vectors
    // is added to the caller's place of the other point.
    std::array<std::int64_t, 3> shift_from(std::uint32_t point, const Image& image) const {
        return grid_->lattice().multiples_of_callers(
            has_one_wrap_ ? image.multiples()
                          : image.multiples() + taken_[point] - taken_[image.point]);
    }
    // Whether all points were moved into the box by the same multiples, so that shift_from() does
    // not depend on points.
    bool has_one_wrap() const { return has_one_wrap_; }
    // The multiples of the basis by which a point was moved into the box.
    const Multiples& wrap_of(std::uint32_t point) const { return taken_[point]; }
    // The rounded coordinates of a point where the caller has put it.
    void rounded(std::uint32_t point, double* x) const;
    // One of the caller's vectors after rounding.
    void rounded_vector(std::uint32_t k, double* x) const;
    // The rounded coordinates of a point where the caller has put it, in the unit of the lattice.
    void place_of(std::uint32_t point, double* x) const;

  private:
    void wrap(Buffer<double>& wrapped);
    void remember_images();
    void find_expected_images(Buffer<Image>& expected) const;
    void forget_results() noexcept;

    mutable Allocator allocator_;
    PeriodicSettings settings_;
    std::optional<BoxLattice> lattice_;
    Buffer<double> given_;
    Buffer<Multiples> taken_;  // the multiples by which each point was moved into the box
    // An image that the last triangulation needed, relative to the point that needed it: the shift
    // between the places where the caller had put the two points.
    struct NeededImage {
        std::uint32_t by, point;
        std::array<std::int64_t, 3> shift;
    };
    Buffer<NeededImage> needed_images_;
    std::optional<ImageGrid> grid_;
    Halo halo_;
    mutable Cached<PeriodicTetrahedra> tetrahedra_{allocator_};
    mutable Cached<VertexNeighbors> neighbors_{allocator_};
    bool has_triangulation_ = false, has_one_wrap_ = true;
    mutable StopFlag stop_;
};

}  // namespace mgdt
