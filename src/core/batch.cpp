// SPDX-License-Identifier: MIT
#include "core/batch.hpp"

#include <algorithm>

#include "kernel/circumsphere.hpp"

namespace mgdt {

void Batch::use(const PointScan& scan, std::size_t n, const double* const axis[3],
                std::ptrdiff_t stride, int scale_exponent, std::size_t first) {
    exponent = scale_exponent;
    is_normal = scan.greatest == 0 || (in_normal_range(scaled(scan.least, exponent)) &&
                                       in_normal_range(scaled(scan.greatest, exponent)));
    first_index = first;
    // Schedules need no exact coordinates: a scale beyond the range of doubles is clamped.
    points = scan.point_set(n, axis, stride,
                            scaled(1.0, std::min(std::max(scale_exponent, -1022), 1023)));
}

void Batch::begin_gathering(std::size_t most) {
    gathered.reserve(3 * std::max<std::size_t>(most, 1));  // an empty batch needs an address, too
    indices.reserve(most);
    gathered.clear();
    indices.clear();
}

void Batch::gather(const double* p, std::uint32_t index) noexcept {
    const std::size_t size = indices.size();
    gathered.resize_within_capacity(3 * (size + 1));
    std::copy_n(p, 3, &gathered[3 * size]);
    indices.resize_within_capacity(size + 1);
    indices[size] = index;
}

void Batch::end_gathering() {
    const double* const axis[3] = {gathered.data(), gathered.data() + 1, gathered.data() + 2};
    Team alone;
    const PointScan scan(alone, indices.size(), axis, 3, 0);
    use(scan, indices.size(), axis, 3, 0, 0);
}

void Batch::gather(const Mesh& mesh, const Buffer<VertexId>& point_map, const Batch& added,
                   std::size_t count) {
    const std::size_t before = added.first_index;
    begin_gathering(before + count);
    // Points that a cancelled call left out have no vertex in the map. They stay out.
    for (std::size_t i = 0; i < before; ++i)
        if (point_map[i] != infinite_vertex)
            gather(mesh.point(point_map[i]), static_cast<std::uint32_t>(i));
    for (std::size_t i = 0; i < count; ++i) {
        double p[3];
        added.get(i, p);
        gather(p, added.index(i));
    }
    end_gathering();
}

void Batch::drop_front(std::size_t count) {
    for (const double*& axis : points.axis)
        axis += static_cast<std::ptrdiff_t>(count) * points.stride;
    points.size -= count;
    first_index += count;
}

}  // namespace mgdt
