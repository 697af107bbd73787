// SPDX-License-Identifier: MIT
#include "core/equal_point_lists.hpp"

namespace mgdt {

void EqualPointLists::update(const Buffer<VertexId>& point_map, const Buffer<Vertex>& vertices) {
    const std::size_t known = next_.size(), size = point_map.size();
    if (known == size) return;
    if (known == 0 || known > size) return make_anew(point_map, vertices);
    next_.grow(size);
    next_.resize(size, no_index);
    // Many points at one vertex make long ways to the end of its list.
    std::size_t steps = 0;
    for (std::size_t i = known; i < size; ++i) {
        const VertexId v = point_map[i];
        if (v == infinite_vertex || vertices[v].moved_to != has_equals) continue;
        std::uint32_t last = vertices[v].index;
        if (last == i) continue;
        for (; next_[last] != no_index; last = next_[last])
            if (++steps > size) return make_anew(point_map, vertices);
        next_[last] = static_cast<std::uint32_t>(i);
    }
}

void EqualPointLists::make_anew(const Buffer<VertexId>& point_map, const Buffer<Vertex>& vertices) {
    next_.clear();
    Buffer<std::uint32_t> last(next_.allocator());
    last.resize(vertices.size(), no_index);
    next_.reserve(point_map.size());
    next_.resize(point_map.size(), no_index);
    for (std::uint32_t i = 0; i < point_map.size(); ++i) {
        const VertexId v = point_map[i];
        if (v == infinite_vertex) continue;
        if (last[v] != no_index) next_[last[v]] = i;
        last[v] = i;
    }
}

}  // namespace mgdt
