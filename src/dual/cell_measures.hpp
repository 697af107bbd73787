// SPDX-License-Identifier: MIT
// Volume, area, centroid and number of faces of a cell.
#pragma once

#include "dual/cell.hpp"
#include "dual/order_free_sum.hpp"
#include "dual/region.hpp"

namespace mgdt {

// A face that planes cut is what they leave of the polygon of its corners, or of a triangle as
// large as the region, which all neighbours cut then: for corners that are far out, or no points.
enum class FacesFrom { corners, triangles };

enum class Measure { volume, area, centroid, faces };

// One cell after the other, in the same memory.
template <class Real>
class CellMeasures {
  public:
    explicit CellMeasures(Allocator& allocator)
        : cell_(allocator),
          polygon_(allocator),
          sums_{Sum(allocator), Sum(allocator), Sum(allocator), Sum(allocator)},
          order_(allocator),
          first_(allocator),
          edges_(allocator),
          cutting_(allocator) {}

    // Of vertex v, whose link is given, within the region: one double, or the three of a centroid.
    // Returns whether the error is below measure_error for sure.
    bool measure(const Mesh& mesh, VertexId v, const Link& link, const Region& region,
                 Measure measure, Centers centers, FacesFrom faces_from, double* x);

  private:
    // Terms, and a bound of the error of each.
    class Sum {
      public:
        explicit Sum(Allocator& allocator) : terms_(allocator), errors_(allocator) {}
        void clear() noexcept;
        void add(const Real& term, double error);
        double value() const { return order_free_sum(terms_.data(), terms_.size(), largest_); }
        double error() const {
            return order_free_sum(errors_.data(), errors_.size(), largest_error_);
        }

      private:
        Buffer<double> terms_, errors_;
        double largest_ = 0, largest_error_ = 0;
    };
    // A plane of the region that cuts the cell.
    struct Cut {
        std::size_t plane;
        Side<Real> side;
    };

    void find_cuts(const Link& link, const Region& region);
    template <class Visit>
    void for_face(const Link& link, std::uint32_t b, Visit visit) const;
    bool is_face_inside(const Link& link, std::uint32_t b) const;
    void set_face(const Link& link, const Region& region, std::uint32_t b);
    void settle(const Side<Real>& plane, const Link& link, const Region& region);
    template <Measure M>
    bool measure_as(const Mesh& mesh, VertexId v, const Link& link, const Region& region);
    template <Measure M>
    void add_whole(const Link& link);
    template <Measure M>
    void add_clipped(const Link& link, const Region& region);
    // A face's side, and twice the multiple of its normal that lies in the face.
    struct Face {
        const Side<Real>& side;
        Real weight;
        double error;  // of the weight
    };
    template <Measure M>
    void add_edge(const Face& face, const Corner<Real>& a, const Corner<Real>& b,
                  const Vector<Real>& a_cross_b);
    template <Measure M>
    void add_polygon(const Face& face);
    void count_edges(const Mesh& mesh, VertexId v, const Link& link);
    bool is_one_corner(const Mesh& mesh, VertexId v, const Link& link, std::size_t triangle,
                       unsigned beyond) const;

    Cell<Real> cell_;
    Polygon<Real> polygon_;
    Sum sums_[4];
    Buffer<std::uint32_t> order_, first_, edges_;
    Buffer<Cut> cutting_;
    FacesFrom faces_from_ = FacesFrom::corners;
    double extent_ = 0;  // of corners from the vertex
    std::size_t faces_ = 0;
    bool is_known_ = true;           // faces are faces for sure, and all corners are points
    const double* point_ = nullptr;  // of the vertex
};

// Relative error of volumes and areas, and that of centroids in units of the distance of the
// farthest corner.
constexpr double measure_error = 1e-12;

}  // namespace mgdt
