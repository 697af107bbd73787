// SPDX-License-Identifier: MIT
// The points of one insertion.
#pragma once

#include "core/point_scan.hpp"
#include "mesh/mesh.hpp"

namespace mgdt {

struct Batch {
    explicit Batch(Allocator& allocator) : gathered(allocator), indices(allocator) {}
    // The caller's points; `first` is the index of the first, counted from 0.
    Batch(Allocator& allocator, const PointScan& scan, std::size_t n, const double* const axis[3],
          std::ptrdiff_t stride, int scale_exponent, std::size_t first)
        : Batch(allocator) {
        use(scan, n, axis, stride, scale_exponent, first);
    }

    // Makes this a batch of scaled points that come one by one.
    void begin_gathering(std::size_t most);
    void gather(const double* p, std::uint32_t index) noexcept;
    void end_gathering();
    // Makes this the batch of all points that are in (all held) and the first `count` of `added`.
    void gather(const Mesh& mesh, const Buffer<VertexId>& point_map, const Batch& added,
                std::size_t count);
    // Leaves out the first points.
    void drop_front(std::size_t count);

    // Point i as the mesh stores it: scaled, -0 made 0.
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
    bool is_normal;                 // all coordinates are in the range in which filters are proved
    std::size_t first_index;        // of point 0, where there are no indices
    Buffer<double> gathered;        // coordinates
    Buffer<std::uint32_t> indices;  // empty, or of each point

  private:
    void use(const PointScan& scan, std::size_t n, const double* const axis[3],
             std::ptrdiff_t stride, int scale_exponent, std::size_t first);
};

}  // namespace mgdt
