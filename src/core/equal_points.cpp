// SPDX-License-Identifier: MIT
#include "core/equal_points.hpp"

#include <algorithm>
#include <cassert>

namespace mgdt {

void EqualPoints::find(const Buffer<VertexId>& point_map, const Buffer<std::uint32_t>& leaving) {
    Buffer<bool> is_affected(points_.allocator());
    is_affected.resize(vertices_, false);
    for (const std::uint32_t i : leaving) is_affected[point_map[i]] = true;
    for (std::size_t i = 0; i < point_map.size(); ++i) {
        const VertexId v = point_map[i];
        if (v != infinite_vertex && is_affected[v])
            points_.push_back({v, static_cast<std::uint32_t>(i)});
    }
    std::sort(points_.begin(), points_.end());
    first_.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) first_[i] = static_cast<std::uint32_t>(i);
}

std::uint32_t EqualPoints::least_other(const Buffer<VertexId>& point_map, VertexId v,
                                       std::uint32_t than) {
    assert(v != infinite_vertex && "a point that is not in has no vertex");
    assert(point_map[than] == v && "the point is at another vertex");
    std::uint32_t least = v < joined_.size() ? joined_[v] : no_index;
    const PointOfVertex key = {v, 0};
    const PointOfVertex* const begin = std::lower_bound(points_.begin(), points_.end(), key);
    if (begin == points_.end() || begin->vertex != v) return least;
    // Points that have left do not come back, so the scan passes each of them once.
    std::uint32_t& first = first_[static_cast<std::size_t>(begin - points_.begin())];
    const auto is_at_vertex = [&](std::size_t i) {
        return i < points_.size() && points_[i].vertex == v;
    };
    while (is_at_vertex(first) && point_map[points_[first].point] != v) ++first;
    std::size_t i = first;
    while (is_at_vertex(i) && (points_[i].point == than || point_map[points_[i].point] != v)) ++i;
    return is_at_vertex(i) ? std::min(least, points_[i].point) : least;
}

void EqualPoints::join(VertexId v, std::uint32_t point) {
    assert(v != infinite_vertex && point != no_index && "no point at no vertex");
    if (v >= vertices_) return;  // the vertex is new in this call: no point leaves it
    if (joined_.empty()) joined_.resize(vertices_, no_index);
    joined_[v] = std::min(joined_[v], point);
}

}  // namespace mgdt
