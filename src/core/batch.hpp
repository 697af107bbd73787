// SPDX-License-Identifier: MIT
// A batch: the points of one insertion, in the caller's array or gathered in an array of its own.
#pragma once

#include "core/point_scan.hpp"
#include "mesh/mesh.hpp"

namespace mgdt {

struct Batch {
    explicit Batch(Allocator& allocator) : gathered(allocator), indices(allocator) {}
    // A batch of n points in the caller's array. `first` is the index of the first point, counted
    // from 0.
    Batch(Allocator& allocator, const PointScan& scan, std::size_t n, const double* const axis[3],
          std::ptrdiff_t stride, int scale_exponent, std::size_t first)
        : Batch(allocator) {
        use(scan, n, axis, stride, scale_exponent, first);
    }

    // These functions collect scaled points one by one. begin_gathering() makes room for `most`
    // points; the batch may be used after end_gathering().
    void begin_gathering(std::size_t most);
    void gather(const double* p, std::uint32_t index) noexcept;
    void end_gathering();
    // Gathers the points before those of `added` that have a vertex in `point_map`, and the first
    // `count` points of `added`.
    void gather(const Mesh& mesh, const Buffer<VertexId>& point_map, const Batch& added,
                std::size_t count);
    // Removes the first `count` points from the batch.
    void drop_front(std::size_t count);

    // Point i as the mesh stores it: scaled, with -0 replaced by 0.
    void get(std::size_t i, double p[3]) const {
        for (int k = 0; k < 3; ++k) {
            const double x = points.axis[k][static_cast<std::ptrdiff_t>(i) * points.stride];
            p[k] = scaled(x, exponent) + 0.0;
        }
    }

    // The caller's index of point i, counted from 0.
    std::uint32_t index(std::size_t i) const {
        return indices.empty() ? static_cast<std::uint32_t>(first_index + i) : indices[i];
    }

    PointSet points;
    int exponent;
    bool is_normal;                 // all coordinates are in the range where filters are proved
    std::size_t first_index;        // the index of point 0, if `indices` is empty
    Buffer<double> gathered;        // coordinates of gathered points
    Buffer<std::uint32_t> indices;  // the index of each gathered point

  private:
    void use(const PointScan& scan, std::size_t n, const double* const axis[3],
             std::ptrdiff_t stride, int scale_exponent, std::size_t first);
};

}  // namespace mgdt
