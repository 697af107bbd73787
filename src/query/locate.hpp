// SPDX-License-Identifier: MIT
// Point location and nearest vertices. The triangulation must not change meanwhile.
#pragma once

#include "kernel/kernel.hpp"
#include "query/location_tree.hpp"

namespace mgdt {

struct Locator {
    const Mesh& mesh;
    const KernelCalls& kernel;
    const LocationTree* tree;  // nullptr for a small mesh

    // The finite tetrahedron whose closure contains q (in the caller's scale), or no_tetrahedron if
    // q is outside the hull. The walk starts at `hint`; if `hint` is no_tetrahedron, the tree
    // chooses the start. The function sets `hint` to a tetrahedron near q or, if q is outside the
    // hull, to a ghost whose facet q sees. With `may_end_outside`, the walk may end at any such
    // ghost, even a distant one.
    TetId locate(const double* q, TetId& hint, bool may_end_outside = true) const;
    // Locates the points point_of(0) to point_of(n - 1), and calls found(k, tetrahedron, near) for
    // each, in any order; `near` is the hint that locate() returns. Several walks are interleaved
    // to hide memory latency: the sequence is divided into stretches, and each walk starts at the
    // last point of its stretch.
    template <class PointOf, class Found>
    void locate_sequence(std::size_t n, bool may_end_outside, PointOf point_of, Found found) const;
    // Barycentric coordinates of q in the order of the tetrahedron's stored vertices.
    void weights(TetId t, const double* q, double (&w)[4]) const;
    // The vertex nearest to q. Of several nearest vertices, the result is the one with the least
    // index. infinite_vertex if there is none.
    VertexId nearest_vertex(const double* q, Allocator& allocator) const;
    // The vertex nearest to q, searched from `near`, a tetrahedron near q, or no_tetrahedron if the
    // mesh has no tetrahedra.
    VertexId nearest_vertex(const double* q, TetId near, Allocator& allocator) const;
    // A tetrahedron of vertex v, found from its hint.
    TetId tetrahedron_of(VertexId v) const;
    // The coordinates of a vertex in the caller's scale.
    void unscaled(VertexId v, double* to) const;
    // Writes q in the mesh's scale. Returns false if the result is rounded.
    bool scale_exactly(const double* q, double* to) const;

  private:
    // Begins a walk. Returns false if q is not exact in the mesh's scale.
    bool begin(const double* q, TetId hint, LocationWalk& walk) const;
    // Takes a step of the walk. Returns false if the walk has ended.
    bool step(LocationWalk& walk) const {
        if (!kernel.locate_step(mesh, walk)) return false;
        constexpr std::size_t long_walk = 64;
        const std::size_t steps = ++walk.steps_taken;
        if (MGDT_UNLIKELY(steps >= long_walk && (steps & (steps - 1)) == 0))
            kernel.locate_jump(mesh, walk, steps);
        return true;
    }
    TetId end(const double* q, const LocationWalk& walk, TetId& hint) const;
};

template <class PointOf, class Found>
void Locator::locate_sequence(std::size_t n, bool may_end_outside, PointOf point_of,
                              Found found) const {
    constexpr std::size_t most_streams = 16;
    struct Stream {
        LocationWalk walk;
        std::size_t next, end;
        TetId hint = no_tetrahedron;
        bool walks = false;
    };
    Stream streams[most_streams];
    const std::size_t count = n < most_streams ? n : most_streams;
    for (std::size_t s = 0; s < count; ++s) {
        streams[s].next = n * s / count;
        streams[s].end = n * (s + 1) / count;
        streams[s].walk.may_end_outside = may_end_outside;
    }
    std::size_t left = n;
    while (left > 0) {
        for (std::size_t s = 0; s < count; ++s) {
            Stream& stream = streams[s];
            if (stream.next == stream.end) continue;
            if (!stream.walks) {
                if (stream.next + 2 < stream.end) prefetch(point_of(stream.next + 2));
                stream.walks = mesh.live_count() != 0 &&
                               begin(point_of(stream.next), stream.hint, stream.walk);
                if (stream.walks) continue;
            } else if (step(stream.walk)) {
                continue;
            }
            stream.walks = false;
            const std::size_t k = stream.next++;
            const TetId tetrahedron = mesh.live_count() == 0
                                          ? no_tetrahedron
                                          : end(point_of(k), stream.walk, stream.hint);
            found(k, tetrahedron, stream.hint);
            --left;
        }
    }
}

}  // namespace mgdt
