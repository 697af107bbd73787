// SPDX-License-Identifier: MIT
#include "core/batch.hpp"

#include <algorithm>

namespace mgdt {

void Triangulation::Batch::use(const PointScan& scan, std::size_t n, const double* const axis[3],
                               std::ptrdiff_t stride, int scale_exponent, std::size_t first) {
    exponent = scale_exponent;
    first_index = first;
    points.size = n;
    points.stride = stride;
    // Schedules need no exactness: a scale that is no double itself is cut.
    points.scale = std::ldexp(1.0, std::min(std::max(scale_exponent, -1022), 1023));
    for (int k = 0; k < 3; ++k) {
        points.axis[k] = axis[k];
        points.low[k] = scan.low[k] * points.scale;
        points.high[k] = scan.high[k] * points.scale;
    }
}

void Triangulation::Batch::gather(const Mesh& mesh, const Buffer<VertexId>& point_map,
                                  const PointScan& scan, const double* const axis[3],
                                  std::ptrdiff_t stride, int scale_exponent) {
    const std::size_t total = point_map.size(), first = first_index;
    use(scan, total - first, axis, stride, scale_exponent, first);
    gathered.resize(3 * total);
    indices.resize(total);
    std::size_t size = 0;
    for (std::size_t i = 0; i < total; ++i) {
        // A point that a cancelled call left out stays out.
        if (i < first && point_map[i] == infinite_vertex) continue;
        double* p = &gathered[3 * size];
        if (i >= first)
            get(i - first, p);
        else
            std::copy_n(mesh.point(point_map[i]), 3, p);
        indices[size++] = static_cast<std::uint32_t>(i);
    }
    const double* const gathered_axis[3] = {&gathered[0], &gathered[1], &gathered[2]};
    const PointScan whole(size, gathered_axis, 3, 0);
    use(whole, size, gathered_axis, 3, 0, 0);
}

}  // namespace mgdt
