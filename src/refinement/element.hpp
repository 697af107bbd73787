// SPDX-License-Identifier: MIT
// What refinement asks of a tetrahedron: its circumsphere and its shortest edge.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "solid/rounded_volume.hpp"

namespace mgdt {

struct ElementShape {
    Vector<double> offset;  // of the circumcentre from the first corner
    double radius2;         // the square of the circumradius; infinite for a tetrahedron too flat
    double shortest2;       // the square of the shortest edge's length
    double volume;
};

// Computes an element of a positive tetrahedron from the edges at its first corner.
inline ElementShape element_of(const Vector<double>& u, const Vector<double>& v,
                               const Vector<double>& w) noexcept {
    const Vector<double> vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
    const double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
    const double volume = dot(u, vw);
    // |v - u|^2 and so on, by the same products.
    const double vu2 = std::max(uu + vv - 2 * dot(u, v), 0.0),
                 wv2 = std::max(vv + ww - 2 * dot(v, w), 0.0),
                 uw2 = std::max(ww + uu - 2 * dot(w, u), 0.0);
    ElementShape e;
    e.volume = volume / 6;
    e.shortest2 = std::min({uu, vv, ww, vu2, wv2, uw2});
    const double factor = volume > 0 ? 0.5 / volume : 0;
    e.offset = factor * ((uu * vw + vv * wu) + ww * uv);
    e.radius2 = factor > 0 ? dot(e.offset, e.offset) : std::numeric_limits<double>::infinity();
    if (!(e.radius2 >= 0)) e.radius2 = std::numeric_limits<double>::infinity();
    return e;
}
inline ElementShape element_of(const double* a, const double* b, const double* c,
                               const double* d) noexcept {
    return element_of(difference<double>(b, a), difference<double>(c, a), difference<double>(d, a));
}

// When a tetrahedron is to be divided.
class ElementBounds {
  public:
    double radius_edge = 1.4;  // the most that the circumradius may be, in shortest edges
    double radius_size = 0.8;  // and in sizes
    double least_edge = 0.4;   // the least distance of a new vertex from others, in sizes

    double volume = std::numeric_limits<double>::infinity();  // the most that it may be

    // The distance from walls, in sizes, below which a vertex has to make the mesh better.
    double from_wall = 0.45;

    // By how much an element exceeds the bounds, squared; it is within them if this is at most 1.
    double excess(const ElementShape& e, double size) const noexcept {
        const double by_size = radius_size * size;
        return std::max({share(e.radius2, by_size * by_size),
                         share(e.radius2, radius_edge * radius_edge * e.shortest2),
                         share(e.volume, volume)});
    }
    bool exceeds_size(const ElementShape& e, double size) const noexcept {
        const double by_size = radius_size * size;
        return e.radius2 > by_size * by_size;
    }
    bool exceeds_shape(const ElementShape& e) const noexcept {
        return share(e.radius2, radius_edge * radius_edge * e.shortest2) > 1;
    }

  private:
    // What may be infinite is nothing of an infinite bound.
    static double share(double x, double bound) noexcept {
        return bound < std::numeric_limits<double>::infinity() ? x / bound : 0;
    }
};

}  // namespace mgdt
