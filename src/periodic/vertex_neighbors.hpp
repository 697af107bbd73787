// SPDX-License-Identifier: MIT
// The neighbours of each vertex of a periodic triangulation: the images of points at the other ends
// of its edges.
#pragma once

#include "periodic/halo.hpp"

namespace mgdt {

struct VertexNeighbors {
    VertexNeighbors(Allocator& allocator, const Halo& halo);

    Buffer<std::uint64_t> begin;  // where the neighbours of each point begin, and the end
    // The neighbours of each point are sorted by point, and then by multiples. Multiples are
    // relative to the vertex in the box.
    Buffer<Image> images;
};

}  // namespace mgdt
