// SPDX-License-Identifier: MIT
// Volume, area, centroid and number of faces of a cell, computed in doubles if doubles are accurate
// enough.
#pragma once

#include "dual/cell.hpp"
#include "dual/face_sums.hpp"
#include "dual/overlap.hpp"
#include "dual/region.hpp"

namespace mgdt {

// Measures one cell at a time and reuses its memory for the next.
class CellMeasures {
  public:
    explicit CellMeasures(Allocator& allocator)
        : cell_(allocator),
          polygon_(allocator),
          sums_(allocator),
          order_(allocator),
          first_(allocator),
          edges_(allocator),
          cutting_(allocator),
          touches_(allocator) {}

    // Measures the cell of vertex v, whose link is given, within the region. The result is
    // width_of(measure) doubles. Returns false if the error may exceed measure_error, or if
    // faces are to be counted and the region may cut the cell.
    bool measure(const Mesh& mesh, VertexId v, const Link& link, const Region& region,
                 Measure measure, Centers centers, double* x);
    // The cell of the last call of measure().
    const Cell& cell() const noexcept { return cell_; }

  private:
    using Sums = FaceSums;
    // A plane of the region that may cut the cell, and its half-space.
    struct Cut {
        std::size_t plane;
        Side side;
    };
    // The face of a neighbour that may reach a cutting plane, by indices into order_ and cutting_.
    struct Touch {
        std::size_t cut, neighbor;
    };

    void find_cuts(const Link& link, const Region& region);
    void set_face(const Link& link, std::size_t rank);
    void set_region_face(const Cut& cut, const Link& link, const Region& region, const Touch* begin,
                         const Touch* end);
    Overlap overlap_with_cell() const;
    void settle(const Side& plane, const Link& link, const Region& region);
    template <Measure M>
    bool measure_as(const Link& link, const Region& region);
    template <Measure M>
    void add_whole(const Link& link);
    template <Measure M>
    void add_clipped(const Link& link, const Region& region);
    template <Measure M>
    void add_polygon(const Sums::Face& face);
    std::size_t count_faces(const Mesh& mesh, VertexId v, const Link& link);
    bool is_one_corner(const Mesh& mesh, VertexId v, const Link& link, std::size_t triangle,
                       unsigned beyond) const;

    Cell cell_;
    Polygon polygon_;
    Sums sums_;
    Buffer<std::uint32_t> order_, first_, edges_;
    Buffer<Cut> cutting_;
    Buffer<Touch> touches_;
    bool is_known_ = true;           // all corners are finite
    const double* point_ = nullptr;  // the coordinates of the vertex
};

}  // namespace mgdt
