// SPDX-License-Identifier: MIT
// Point location and nearest vertices on a triangulation that is not changed meanwhile.
#pragma once

#include "kernel/kernel.hpp"

namespace mgdt {

struct Locator {
    const Mesh& mesh;
    const Kernel& kernel;

    // The finite tetrahedron whose closure contains q (unscaled), or no_tetrahedron outside the
    // hull. The walk starts at `hint`, or at a jump where there is none; `hint` becomes a
    // tetrahedron near q.
    TetId locate(const double* q, TetId& hint) const;
    // Barycentric coordinates of q in the order of the tetrahedron's stored vertices.
    void weights(TetId t, const double* q, double w[4]) const;
    // The vertex nearest to q, the lowest index of several; infinite_vertex if there is none.
    VertexId nearest_vertex(const double* q, Allocator& allocator) const;

  private:
    int compare(VertexId a, VertexId b, const double* q) const;
    bool scale_exactly(const double* q, double* to) const;
    void unscaled(VertexId v, double* to) const;
};

}  // namespace mgdt
