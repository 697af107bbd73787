// SPDX-License-Identifier: MIT
// Point location and nearest vertices on a triangulation that is not changed meanwhile.
#pragma once

#include "kernel/kernel.hpp"
#include "query/location_tree.hpp"

namespace mgdt {

struct Locator {
    const Mesh& mesh;
    const KernelCalls& kernel;
    const LocationTree* tree;  // nullptr for a small mesh

    // The finite tetrahedron whose closure contains q (unscaled), or no_tetrahedron outside the
    // hull. The walk starts at `hint`, or where the tree says if there is none; `hint` becomes a
    // tetrahedron near q, or for q outside a ghost that q is beyond: any such, if it
    // `may_end_outside`.
    TetId locate(const double* q, TetId& hint, bool may_end_outside = true) const;
    // Locates n points, the k-th of them point_of(k), and calls found(k, tetrahedron, near) for
    // each, in any order; `near` is what locate() makes of its hint. Several are on their way at a
    // time, each stretch of the sequence from its own last place.
    template <class PointOf, class Found>
    void locate_sequence(std::size_t n, bool may_end_outside, PointOf point_of, Found found) const;
    // Barycentric coordinates of q in the order of the tetrahedron's stored vertices.
    void weights(TetId t, const double* q, double (&w)[4]) const;
    // The vertex nearest to q, the lowest index of several; infinite_vertex if there is none.
    VertexId nearest_vertex(const double* q, Allocator& allocator) const;
    // The same from a tetrahedron near q, which only a mesh that has none does without.
    VertexId nearest_vertex(const double* q, TetId near, Allocator& allocator) const;
    // A tetrahedron of vertex v, near whose hint there is one.
    TetId tetrahedron_of(VertexId v) const;
    // A vertex as the caller gave it.
    void unscaled(VertexId v, double* to) const;
    // q in the mesh's scale; false if it has no exact place there, and `to` is rounded.
    bool scale_exactly(const double* q, double* to) const;

  private:
    // False if there are no steps to take.
    bool begin(const double* q, TetId hint, LocationWalk& walk) const;
    // False if that was the last step.
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
