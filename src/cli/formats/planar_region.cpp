// SPDX-License-Identifier: MIT
#include "cli/formats/planar_region.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace mgdt::cli {
namespace {

struct Place2 {
    double u, v;
};

double turn(Place2 a, Place2 b, Place2 c) {
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

// The polygons, projected to the plane of two coordinates.
class PlanarRegion {
  public:
    PlanarRegion(const std::vector<double>& points, std::vector<std::vector<std::int64_t>> polygons)
        : points_(points), polygons_(std::move(polygons)) {
        choose_axes();
        for (std::vector<std::int64_t>& p : polygons_)
            if (area(p) < 0) std::reverse(p.begin(), p.end());
        for (std::size_t i = 0; i < polygons_.size(); ++i) parents_.push_back(parent_of(i));
    }

    bool add_facets(const std::vector<std::array<double, 3>>& holes, std::int32_t marker,
                    FileFacets& facets) {
        std::vector<bool> is_hole(polygons_.size());
        for (const std::array<double, 3>& hole : holes)
            if (const std::size_t i = innermost({hole[axis_[0]], hole[axis_[1]]}, none); i != none)
                is_hole[i] = true;
        for (std::size_t i = 0; i < polygons_.size(); ++i) {
            if (is_hole[i]) continue;
            std::vector<std::int64_t> loop = polygons_[i];
            std::vector<std::size_t> inside;
            for (std::size_t k = 0; k < polygons_.size(); ++k)
                if (parents_[k] == i) inside.push_back(k);
            while (!inside.empty())
                if (!join(loop, inside)) return false;
            facets.corners.insert(facets.corners.end(), loop.begin(), loop.end());
            facets.end_facet(marker);
        }
        return true;
    }

  private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    Place2 at(std::int64_t point) const {
        const double* const p = points_.data() + 3 * static_cast<std::size_t>(point);
        return {p[axis_[0]], p[axis_[1]]};
    }

    // The axes are those across the largest component of the largest normal.
    void choose_axes() {
        double largest = -1;
        for (const std::vector<std::int64_t>& p : polygons_)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::array<std::size_t, 2> before = axis_;
                axis_ = {(k + 1) % 3, (k + 2) % 3};
                const double size = std::abs(area(p));
                if (size > largest)
                    largest = size;
                else
                    axis_ = before;
            }
    }

    double area(const std::vector<std::int64_t>& polygon) const {
        double sum = 0;
        const Place2 o = at(polygon[0]);
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
            sum += turn(o, at(polygon[i]), at(polygon[i + 1]));
        return sum;
    }

    bool contains(const std::vector<std::int64_t>& polygon, Place2 p) const {
        bool is_inside = false;
        for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
            const Place2 a = at(polygon[i]), b = at(polygon[j]);
            if ((a.v > p.v) != (b.v > p.v) && p.u < (b.u - a.u) * (p.v - a.v) / (b.v - a.v) + a.u)
                is_inside = !is_inside;
        }
        return is_inside;
    }

    // The smallest polygon other than `except` that contains a place.
    std::size_t innermost(Place2 p, std::size_t except) const {
        std::size_t best = none;
        for (std::size_t i = 0; i < polygons_.size(); ++i)
            if (i != except && contains(polygons_[i], p) &&
                (best == none || area(polygons_[i]) < area(polygons_[best])))
                best = i;
        return best;
    }

    // The smallest polygon around a polygon: around the middle of an ear of it.
    std::size_t parent_of(std::size_t i) const {
        const std::vector<std::int64_t>& p = polygons_[i];
        double u = 0, v = 0;
        for (std::size_t k = 0; k < p.size(); ++k) {
            const Place2 a = at(p[k]), b = at(p[(k + 1) % p.size()]), c = at(p[(k + 2) % p.size()]);
            u = (a.u + b.u + c.u) / 3;
            v = (a.v + b.v + c.v) / 3;
            if (contains(p, {u, v})) break;
        }
        std::size_t best = none;
        for (std::size_t k = 0; k < polygons_.size(); ++k)
            if (k != i && area(polygons_[k]) > area(p) && contains(polygons_[k], {u, v}) &&
                (best == none || area(polygons_[k]) < area(polygons_[best])))
                best = k;
        return best;
    }

    static bool cross(Place2 a, Place2 b, Place2 c, Place2 d) {
        return turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;
    }

    bool is_free(std::int64_t a, std::int64_t b, const std::vector<std::int64_t>& polygon) const {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const std::int64_t c = polygon[i], d = polygon[(i + 1) % polygon.size()];
            if (c == a || c == b || d == a || d == b) continue;
            if (cross(at(a), at(b), at(c), at(d))) return false;
        }
        return true;
    }

    // Whether the edge from a corner of the loop to b begins inside of the loop. A corner at which
    // the loop comes by several times has several wedges.
    bool leaves_inwards(const std::vector<std::int64_t>& loop, std::size_t i, Place2 b) const {
        const Place2 a = at(loop[i]), next = at(loop[(i + 1) % loop.size()]),
                     before = at(loop[(i + loop.size() - 1) % loop.size()]);
        if (turn(before, a, next) > 0) return turn(a, b, before) > 0 && turn(a, next, b) > 0;
        return !(turn(a, b, next) >= 0 && turn(a, before, b) >= 0);
    }

    // Joins one of the polygons inside to the loop, by the shortest edge that crosses nothing.
    // Returns false if there is none.
    bool join(std::vector<std::int64_t>& loop, std::vector<std::size_t>& inside) const {
        double least = std::numeric_limits<double>::infinity();
        std::size_t from = 0, which = 0, to = 0;
        for (std::size_t w = 0; w < inside.size(); ++w) {
            const std::vector<std::int64_t>& p = polygons_[inside[w]];
            for (std::size_t i = 0; i < loop.size(); ++i)
                for (std::size_t k = 0; k < p.size(); ++k) {
                    const Place2 a = at(loop[i]), b = at(p[k]);
                    const double length = std::hypot(a.u - b.u, a.v - b.v);
                    if (length >= least || !leaves_inwards(loop, i, b) ||
                        !is_free(loop[i], p[k], loop))
                        continue;
                    if (!std::all_of(inside.begin(), inside.end(), [&](std::size_t other) {
                            return is_free(loop[i], p[k], polygons_[other]);
                        }))
                        continue;
                    least = length;
                    from = i;
                    which = w;
                    to = k;
                }
        }
        if (least == std::numeric_limits<double>::infinity()) return false;
        // The inner polygon turns the other way.
        const std::vector<std::int64_t>& p = polygons_[inside[which]];
        std::vector<std::int64_t> walk;
        for (std::size_t k = 0; k <= p.size(); ++k)
            walk.push_back(p[(to + p.size() - k % p.size()) % p.size()]);
        walk.push_back(loop[from]);
        loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(from) + 1, walk.begin(), walk.end());
        inside.erase(inside.begin() + static_cast<std::ptrdiff_t>(which));
        return true;
    }

    const std::vector<double>& points_;
    std::vector<std::vector<std::int64_t>> polygons_;
    std::vector<std::size_t> parents_;  // the smallest polygon around each, or none
    std::array<std::size_t, 2> axis_ = {0, 1};
};

}  // namespace

bool add_planar_region(const std::vector<double>& points,
                       std::vector<std::vector<std::int64_t>> polygons,
                       const std::vector<std::array<double, 3>>& holes, std::int32_t marker,
                       FileFacets& facets) {
    for (const std::vector<std::int64_t>& p : polygons)
        if (p.size() == 2) facets.add_segment(p.data());
    polygons.erase(std::remove_if(polygons.begin(), polygons.end(),
                                  [](const std::vector<std::int64_t>& p) { return p.size() < 3; }),
                   polygons.end());
    if (polygons.size() > 1 || (polygons.size() == 1 && !holes.empty())) {
        return PlanarRegion(points, std::move(polygons)).add_facets(holes, marker, facets);
    }
    if (polygons.size() == 1) {
        facets.corners.insert(facets.corners.end(), polygons[0].begin(), polygons[0].end());
        facets.end_facet(marker);
    }
    return true;
}

}  // namespace mgdt::cli
