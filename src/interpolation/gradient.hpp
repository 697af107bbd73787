// SPDX-License-Identifier: MIT
// The gradient of values at a vertex: the linear function through its value that is nearest to
// those of its neighbours, in the sense of least squares of differences over distances.
#pragma once

#include "mesh/numbers.hpp"
#include "predicates/vector.hpp"
#include "query/locate.hpp"

namespace mgdt {

// One vertex after another, in the same memory. Lengths are those of the mesh's scale.
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

    // The gradient is the sum over neighbours of direction(j) times the difference of their value
    // from the vertex's, divided by distance(j).
    std::size_t size() const noexcept { return neighbors_.size(); }
    VertexId neighbor(std::size_t j) const noexcept { return neighbors_[j]; }
    const Vector<Twofold>& direction(std::size_t j) const noexcept { return rows_[j].direction; }
    double distance(std::size_t j) const noexcept { return rows_[j].distance; }
    // Whether neighbours are nearly in one plane or on one line, or one is far nearer than another:
    // then directions or slopes are long, cancel, and have a lower part, which else is 0.
    bool is_thin() const noexcept { return is_thin_; }

  private:
    struct Row {
        Vector<Twofold> direction;
        double distance;
    };
    void gather(const Locator& where, VertexId v);
    double nearness() const;
    // Sets the directions and distances; returns the least extent of the neighbours over the
    // largest.
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
