// SPDX-License-Identifier: MIT
// The gradient at a vertex, estimated from the neighbours: the gradient of the linear function that
// has the vertex's value there and fits the neighbours' values best. The fit is by least squares of
// differences divided by distances.
#pragma once

#include "mesh/numbers.hpp"
#include "predicates/vector.hpp"
#include "query/locate.hpp"

namespace mgdt {

// Computes one gradient at a time and reuses its memory for the next. Lengths are in the mesh's
// scale.
class Gradient {
  public:
    explicit Gradient(Allocator& allocator)
        : tetrahedra_(allocator),
          vertices_(allocator),
          neighbors_(allocator),
          rows_(allocator),
          columns_(allocator),
          twofold_columns_(allocator) {}

    void find(const Locator& where, VertexId v);

    // The gradient is the sum over the neighbours j of direction(j) times the difference between
    // the values of the neighbour and the vertex, divided by distance(j).
    std::size_t size() const noexcept { return neighbors_.size(); }
    VertexId neighbor(std::size_t j) const noexcept { return neighbors_[j]; }
    const Vector<Twofold>& direction(std::size_t j) const noexcept { return rows_[j].direction; }
    double distance(std::size_t j) const noexcept { return rows_[j].distance; }
    // Whether the neighbours are nearly in one plane or on one line, or one neighbour is much
    // closer than another. Then directions or slopes are large and cancel, so the directions are
    // twofold numbers. Otherwise the low parts of the directions are 0.
    bool is_thin() const noexcept { return is_thin_; }

  private:
    struct Row {
        Vector<Twofold> direction;
        double distance;
    };
    void gather(const Locator& where, VertexId v);
    double nearness() const;
    // Sets the directions and distances. Returns the smallest extent of the neighbours divided by
    // the largest.
    template <class Real>
    double set_directions(const Mesh& mesh, VertexId v, Buffer<Real>& columns);

    Numbers tetrahedra_, vertices_;
    Buffer<VertexId> neighbors_;  // in the order of the caller's indices
    Buffer<Row> rows_;
    Buffer<double> columns_;
    Buffer<Twofold> twofold_columns_;
    bool is_thin_ = false;
};

}  // namespace mgdt
