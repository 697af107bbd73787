// SPDX-License-Identifier: MIT
#include "boundary/boundary.hpp"

#include "platform/error.hpp"

namespace mgdt {

Simplex Boundary::simplex(std::size_t i) const noexcept {
    Simplex s = {};
    const auto set = [&](int size, const Buffer<std::uint32_t>& from) {
        s.size = size;
        for (int k = 0; k < size; ++k) {
            const std::uint32_t number =
                from[static_cast<std::size_t>(size) * i + static_cast<std::size_t>(k)];
            s.number[k] = number;
            s.x[k] = points.begin() + 3 * std::size_t{number};
        }
        return s;
    };
    if (i < triangles.size() / 3) return set(3, triangles);
    i -= triangles.size() / 3;
    if (i < segments.size() / 2) return set(2, segments);
    i -= segments.size() / 2;
    return set(1, lone_points);
}

BoundingBox Boundary::box(std::size_t i) const noexcept {
    return box_of(simplex(i));
}

Buffer<BoundingBox> boxes_of(const Boundary& boundary, double margin, Team& team,
                             Allocator& allocator) {
    const std::size_t n = boundary.size();
    constexpr std::size_t most = 0x7FFFFFFFu, simplices_per_thread = 4096;
    if (n > most)
        fail(MGDT_ERR_TOO_LARGE, "%zu facets and segments are more than can be numbered", n);
    Buffer<BoundingBox> boxes(allocator, n);
    team.split(n, simplices_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t i = begin; i < end; ++i) {
            boxes[i] = boundary.box(i);
            for (int k = 0; k < 3; ++k) {
                boxes[i].low[k] -= margin;
                boxes[i].high[k] += margin;
            }
        }
    });
    return boxes;
}

void find_lone_points(Boundary& boundary, Allocator& allocator) {
    Buffer<std::uint8_t> is_used(allocator);
    is_used.resize(boundary.points.size() / 3, std::uint8_t{0});
    for (const std::uint32_t v : boundary.triangles) is_used[v] = 1;
    for (const std::uint32_t v : boundary.segments) is_used[v] = 1;
    boundary.lone_points.clear();
    for (std::uint32_t v = 0; v < is_used.size(); ++v)
        if (is_used[v] == 0) boundary.lone_points.push_back(v);
}

BoundingBox box_of(const Simplex& s) noexcept {
    BoundingBox box(s.x[0]);
    for (int c = 1; c < s.size; ++c) box.include(BoundingBox(s.x[c]));
    return box;
}

}  // namespace mgdt
