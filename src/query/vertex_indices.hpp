// SPDX-License-Identifier: MIT
// The caller's index of each vertex, in an array of its own. This array fits into the cache in many
// cases where the records of the vertices do not.
#pragma once

#include <algorithm>

#include "mesh/mesh.hpp"
#include "parallel/team.hpp"

namespace mgdt {

class VertexIndices {
  public:
    VertexIndices(Team& team, const Mesh& mesh, Allocator& allocator)
        : indices_(allocator, mesh.vertices.size()) {
        std::uint32_t ends[Team::most];
        std::fill_n(ends, team.size(), 0u);
        constexpr std::size_t min_items_per_thread = 65536;
        team.split(indices_.size(), min_items_per_thread,
                   [&](std::size_t begin, std::size_t end, unsigned m) {
                       std::uint32_t last = 0;
                       for (std::size_t v = begin; v < end; ++v) {
                           indices_[v] = mesh.vertices[v].index;
                           if (v != infinite_vertex) last = std::max(last, indices_[v] + 1);
                       }
                       ends[m] = last;
                   });
        end_ = *std::max_element(ends, ends + team.size());
    }

    std::uint32_t operator[](VertexId v) const noexcept { return indices_[v]; }
    const std::uint32_t* data() const noexcept { return indices_.data(); }
    // One past the greatest index.
    std::size_t end() const noexcept { return end_; }

  private:
    Buffer<std::uint32_t> indices_;
    std::size_t end_;
};

}  // namespace mgdt
