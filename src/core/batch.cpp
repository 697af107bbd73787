// SPDX-License-Identifier: MIT
#include "core/batch.hpp"

#include <algorithm>

namespace mgdt {

void Triangulation::Batch::use(const PointScan& scan, std::size_t n, const double* const axis[3],
                               std::ptrdiff_t stride, int scale_exponent, std::size_t first) {
    exponent = scale_exponent;
    is_normal = scan.greatest == 0 || (in_normal_range(scaled(scan.least, exponent)) &&
                                       in_normal_range(scaled(scan.greatest, exponent)));
    first_index = first;
    // Schedules need no exactness: a scale that is no double itself is cut.
    points = scan.point_set(n, axis, stride,
                            scaled(1.0, std::min(std::max(scale_exponent, -1022), 1023)));
}

void Triangulation::Batch::gather(const Mesh& mesh, const Buffer<VertexId>& point_map,
                                  const Batch& added, std::size_t count) {
    const std::size_t before = added.first_index;
    gathered.resize(3 * (before + count));
    indices.resize(before + count);
    std::size_t size = 0;
    for (std::size_t i = 0; i < before; ++i) {
        // A point that a cancelled call left out stays out.
        if (point_map[i] == infinite_vertex) continue;
        std::copy_n(mesh.point(point_map[i]), 3, &gathered[3 * size]);
        indices[size++] = static_cast<std::uint32_t>(i);
    }
    for (std::size_t i = 0; i < count; ++i) {
        added.get(i, &gathered[3 * size]);
        indices[size++] = added.index(i);
    }
    const double* const axis[3] = {&gathered[0], &gathered[1], &gathered[2]};
    Team alone;
    const PointScan scan(alone, size, axis, 3, 0);
    use(scan, size, axis, 3, 0, 0);
}

void Triangulation::Batch::drop_front(std::size_t count) {
    for (const double*& axis : points.axis)
        axis += static_cast<std::ptrdiff_t>(count) * points.stride;
    points.size -= count;
    first_index += count;
}

}  // namespace mgdt
