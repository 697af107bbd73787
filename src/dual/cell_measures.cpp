// SPDX-License-Identifier: MIT
#include "dual/cell_measures.hpp"

#include <algorithm>
#include <limits>

#include "mesh/scale.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

constexpr unsigned after(unsigned k) {
    return k == 2 ? 0 : k + 1;
}
constexpr unsigned before(unsigned k) {
    return k == 0 ? 2 : k - 1;
}

}  // namespace

template <class Real>
void CellMeasures<Real>::Sum::clear() noexcept {
    terms_.clear();
    errors_.clear();
    largest_ = largest_error_ = 0;
}

template <>
void CellMeasures<double>::Sum::add(const double& term, double error) {
    terms_.push_back(term);
    errors_.push_back(error);
    largest_ = std::fmax(largest_, std::fabs(term));
    largest_error_ = std::fmax(largest_error_, error);
}

template <>
void CellMeasures<Twofold>::Sum::add(const Twofold& term, double error) {
    terms_.push_back(term.high);
    terms_.push_back(term.low);
    errors_.push_back(error);
    largest_ = std::fmax(largest_, std::fabs(term.high));
    largest_error_ = std::fmax(largest_error_, error);
}

// What the triangle of the vertex and an edge of the face adds, the face turning round its outward
// normal. Volumes are 12 times too large and areas twice; docs/theory.md, "Cells".
template <class Real>
template <Measure M>
void CellMeasures<Real>::add_edge(const Face& face, const Corner<Real>& a, const Corner<Real>& b,
                                  const Vector<Real>& a_cross_b) {
    constexpr double u = rounding_of<Real>;
    const Side<Real>& side = face.side;
    const Real along = dot(side.normal, a_cross_b);
    const double error = side.size * (a.size * b.error + b.size * a.error + a.error * b.error +
                                      24 * u * a.size * b.size);
    if constexpr (M == Measure::volume || M == Measure::centroid) {
        const Real volume = face.weight * along;
        const double w = std::fabs(nearest_double(face.weight)),
                     volume_error = w * error + face.error * std::fabs(nearest_double(along));
        sums_[0].add(volume, volume_error);
        if constexpr (M == Measure::centroid) {
            const Real half = scaled_by(face.weight, 0.5);
            const double distance = 0.5 * w * side.size + a.size + b.size;
            const double moved = 0.5 * face.error * side.size + a.error + b.error;
            for (int k = 0; k < 3; ++k)
                sums_[1 + k].add(
                    volume * (half * side.normal.x[k] + (a.x.x[k] + b.x.x[k])),
                    volume_error * (distance + moved) +
                        std::fabs(nearest_double(volume)) * (moved + 8 * u * distance));
        }
    } else {
        const Real one_over_size = to_real<Real>(1 / side.size);
        sums_[0].add(one_over_size * along, error / side.size);
    }
}

template <class Real>
template <Measure M>
void CellMeasures<Real>::add_whole(const Link& link) {
    const Buffer<LinkTriangle>& triangles = link.triangles();
    const Real one = to_real<Real>(1);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (unsigned k = 0; k < 3; ++k) {
            const std::uint32_t j = triangles[i].beyond[k];
            if (j < i) continue;
            const Corner<Real>&a = cell_.corner(i), &b = cell_.corner(j);
            const Side<Real>&p = cell_.side(triangles[i].corner[before(k)]),
                  &r = cell_.side(triangles[i].corner[after(k)]);
            const Vector<Real> a_cross_b = cross(a.x, b.x);
            add_edge<M>({p, one, 0}, a, b, a_cross_b);
            const Real zero = to_real<Real>(0);
            add_edge<M>({r, one, 0}, b, a,
                        {{zero - a_cross_b.x[0], zero - a_cross_b.x[1], zero - a_cross_b.x[2]}});
        }
    extent_ = cell_.radius();
}

template <class Real>
template <Measure M>
void CellMeasures<Real>::add_polygon(const Face& face) {
    const Buffer<Corner<Real>>& corners = polygon_.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Corner<Real>&a = corners[i], &b = corners[i + 1 == corners.size() ? 0 : i + 1];
        add_edge<M>(face, a, b, cross(a.x, b.x));
        is_known_ &= !a.is_ideal;
        extent_ = std::fmax(extent_, a.size);
    }
    // The area by mistake, as add_edge() has it.
    if (polygon_.slack() > 0) {
        const double w = M == Measure::area || M == Measure::faces
                             ? 1 / face.side.size
                             : std::fabs(nearest_double(face.weight));
        const double error = 2 * w * face.side.size * polygon_.slack();
        const Real nothing = to_real<Real>(0);
        sums_[0].add(nothing, error);
        if constexpr (M == Measure::centroid)
            for (int k = 1; k < 4; ++k) sums_[k].add(nothing, 3 * extent_ * error);
    }
}

// The planes that some corner of the cell may be beyond, or all.
template <class Real>
void CellMeasures<Real>::find_cuts(const Link& link, const Region& region) {
    cutting_.clear();
    if (!region.is_bounded()) return;
    if (cell_.is_bounded() && region.clearance(point_) * cell_.factor() > cell_.radius()) return;
    const double reach = 2 * region.extent() * cell_.factor();
    polygon_.set_reach(reach);
    for (std::size_t k = 0; k < region.size(); ++k) {
        const Side<Real> side = region.side<Real>(k, point_, cell_.factor());
        const bool is_cutting = faces_from_ == FacesFrom::triangles ||
                                !Polygon<Real>::are_inside(side, reach, [&](auto look) {
                                    for (std::size_t i = 0; i < link.triangles().size(); ++i)
                                        look(cell_.corner(i));
                                });
        if (is_cutting) cutting_.push_back({k, side});
    }
}

// The triangles of the link around neighbour b, each with the neighbour that it shares with the
// next.
template <class Real>
template <class Visit>
void CellMeasures<Real>::for_face(const Link& link, std::uint32_t b, Visit visit) const {
    std::uint32_t i = first_[b];
    do {
        const LinkTriangle& t = link.triangles()[i];
        const unsigned k = t.corner[0] == b ? 0 : t.corner[1] == b ? 1 : 2;
        visit(i, t.corner[before(k)]);
        i = t.beyond[after(k)];
    } while (i != first_[b]);
}

// Whether no plane touches the face to neighbour b, for sure.
template <class Real>
bool CellMeasures<Real>::is_face_inside(const Link& link, std::uint32_t b) const {
    for (const Cut& cut : cutting_) {
        const auto each = [&](auto look) {
            for_face(link, b, [&](std::uint32_t i, std::uint32_t) { look(cell_.corner(i)); });
        };
        if (!Polygon<Real>::are_inside(cut.side, 0x1p900, each)) return false;
    }
    return true;
}

// The face to neighbour b, cut by the planes of the region.
template <class Real>
void CellMeasures<Real>::set_face(const Link& link, const Region& region, std::uint32_t b) {
    const bool by_corners = faces_from_ == FacesFrom::corners;
    const auto region_label = [&](const Cut& cut) {
        return static_cast<std::uint32_t>(link.neighbor_count() + cut.plane);
    };
    const Side<Real>& side = cell_.side(b);
    if (by_corners) {
        polygon_.clear();
    } else {
        const std::uint32_t no_label = region_label({region.size(), side});
        polygon_.set_triangle(side, scaled_by(side.normal, 0.5),
                              2 * region.extent() * cell_.factor(), no_label);
        for (const Cut& cut : cutting_) polygon_.clip(cut.side, region_label(cut));
    }
    for_face(link, b, [&](std::uint32_t i, std::uint32_t next) {
        if (by_corners)
            polygon_.push_back(cell_.corner(i), next);
        else if (link.neighbor(next) != infinite_vertex)
            polygon_.clip(cell_.side(next), next);
    });
    if (by_corners)
        for (const Cut& cut : cutting_) polygon_.clip(cut.side, region_label(cut));
    else
        settle(side, link, region);
}

template <class Real>
void CellMeasures<Real>::settle(const Side<Real>& plane, const Link& link, const Region& region) {
    const std::size_t n = link.neighbor_count();
    polygon_.settle(plane, [&](std::uint32_t label) {
        return label < n ? cell_.side(label) : region.side<Real>(label - n, point_, cell_.factor());
    });
}

// The faces to neighbours are what the cutting planes leave of them; a face in such a plane is what
// all neighbours leave of it.
template <class Real>
template <Measure M>
void CellMeasures<Real>::add_clipped(const Link& link, const Region& region) {
    const Buffer<LinkTriangle>& triangles = link.triangles();
    const std::size_t n = link.neighbor_count();
    first_.resize(n);
    order_.clear();
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (const std::uint32_t corner : triangles[i].corner) first_[corner] = i;
    for (std::uint32_t b = 0; b < n; ++b)
        if (link.neighbor(b) != infinite_vertex) order_.push_back(b);
    std::sort(order_.begin(), order_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return cell_.index(a) < cell_.index(b); });
    const auto add_face = [&](const Face& face) {
        add_polygon<M>(face);
        if (M != Measure::faces) return;
        const double area = sums_[0].value(), error = sums_[0].error();
        faces_ += area > error;
        is_known_ &= area > error || error == 0;
        sums_[0].clear();
    };
    for (const std::uint32_t b : order_) {
        if constexpr (M == Measure::faces) {
            if (edges_[b] < 3) continue;
            if (is_face_inside(link, b)) {
                ++faces_;
                continue;
            }
        }
        set_face(link, region, b);
        add_face({cell_.side(b), to_real<Real>(1), 0});
    }
    for (const Cut& cut : cutting_) {
        region.set_face(cut.plane, point_, cell_.factor(), static_cast<std::uint32_t>(n), polygon_);
        for (const std::uint32_t b : order_) {
            polygon_.clip(cell_.side(b), b);
            if (polygon_.corners().empty()) break;
        }
        settle(cut.side, link, region);
        const Real squared = dot(cut.side.normal, cut.side.normal),
                   weight = scaled_by(cut.side.offset, 2) / squared;
        add_face({cut.side, weight,
                  2 * cut.side.error / nearest_double(squared) +
                      8 * rounding_of<Real> * std::fabs(nearest_double(weight))});
    }
}

// Whether two neighbouring tetrahedra have one circumcentre, or two hull facets one plane.
template <class Real>
bool CellMeasures<Real>::is_one_corner(const Mesh& mesh, VertexId v, const Link& link,
                                       std::size_t triangle, unsigned beyond) const {
    const LinkTriangle& t = link.triangles()[triangle];
    const std::size_t other = t.beyond[beyond];
    const Corner<Real>&a = cell_.corner(triangle), &b = cell_.corner(other);
    if (a.is_ideal != b.is_ideal) return false;
    // The vertex of the other triangle that is not in this one.
    const LinkTriangle& of = link.triangles()[other];
    const std::uint32_t p = t.corner[after(beyond)], q = t.corner[before(beyond)];
    std::uint32_t apex = of.corner[0];
    for (const std::uint32_t corner : of.corner)
        if (corner != p && corner != q) apex = corner;
    const auto point = [&](std::uint32_t number) { return mesh.point(link.neighbor(number)); };
    if (a.is_ideal)
        // The vertex at infinity is on the edge, and the other two corners are hull vertices.
        return orientation(mesh.point(v), point(link.neighbor(p) == infinite_vertex ? q : p),
                           point(t.corner[beyond]), point(apex)) == 0;
    if (length(a.x - b.x) > 2 * (a.error + b.error)) return false;
    return side_of_sphere(mesh.point(v), point(t.corner[0]), point(t.corner[1]), point(t.corner[2]),
                          point(apex)) == 0;
}

// How many edges of some length the face to each neighbour has. It has no area with fewer than
// three.
template <class Real>
void CellMeasures<Real>::count_edges(const Mesh& mesh, VertexId v, const Link& link) {
    edges_.resize(0);
    edges_.resize(link.neighbor_count(), 0);
    const Buffer<LinkTriangle>& triangles = link.triangles();
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (unsigned k = 0; k < 3; ++k) {
            if (triangles[i].beyond[k] < i || is_one_corner(mesh, v, link, i, k)) continue;
            ++edges_[triangles[i].corner[before(k)]];
            ++edges_[triangles[i].corner[after(k)]];
        }
}

template <class Real>
template <Measure M>
bool CellMeasures<Real>::measure_as(const Mesh& mesh, VertexId v, const Link& link,
                                    const Region& region) {
    for (Sum& sum : sums_) sum.clear();
    extent_ = 0;
    if constexpr (M == Measure::faces) count_edges(mesh, v, link);
    if (!cutting_.empty())
        add_clipped<M>(link, region);
    else if constexpr (M == Measure::faces)
        for (std::size_t b = 0; b < link.neighbor_count(); ++b)
            faces_ += link.neighbor(b) != infinite_vertex && edges_[b] >= 3;
    else
        add_whole<M>(link);
    if constexpr (M == Measure::faces) return is_known_;
    if (!is_known_) return false;
    if (!(sums_[0].error() <= 0.9 * measure_error * sums_[0].value())) return false;
    if constexpr (M == Measure::centroid)
        for (int k = 1; k < 4; ++k)
            if (!(sums_[k].error() <= measure_error * extent_ * sums_[0].value())) return false;
    return true;
}

template <class Real>
bool CellMeasures<Real>::measure(const Mesh& mesh, VertexId v, const Link& link,
                                 const Region& region, Measure measure, Centers centers,
                                 FacesFrom faces_from, double* x) {
    faces_from_ = faces_from;
    cell_.make(mesh, v, link, centers);
    point_ = mesh.point(v);
    find_cuts(link, region);
    faces_ = 0;
    is_known_ = true;
    const int exponent = -(std::ilogb(cell_.factor()) + mesh.scale);
    const bool is_infinite = !cell_.is_bounded() && cutting_.empty();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    switch (measure) {
        case Measure::volume: {
            if (is_infinite) return x[0] = infinity, true;
            const bool is_sure = measure_as<Measure::volume>(mesh, v, link, region);
            x[0] = std::ldexp(std::fmax(sums_[0].value() / 12, 0), 3 * exponent);
            return is_sure;
        }
        case Measure::area: {
            if (is_infinite) return x[0] = infinity, true;
            const bool is_sure = measure_as<Measure::area>(mesh, v, link, region);
            x[0] = std::ldexp(std::fmax(sums_[0].value() / 2, 0), 2 * exponent);
            return is_sure;
        }
        case Measure::centroid: {
            if (is_infinite) return x[0] = x[1] = x[2] = infinity, true;
            const bool is_sure = measure_as<Measure::centroid>(mesh, v, link, region);
            const double volume = sums_[0].value();
            for (int k = 0; k < 3; ++k) {
                double offset = sums_[1 + k].value() / (4 * volume);
                // Beyond what twofold numbers can tell, the vertex is a point of the cell.
                if (!is_sure && !(std::fabs(offset) <= extent_)) offset = 0;
                x[k] = scaled(point_[k] + offset / cell_.factor(), -mesh.scale);
            }
            return is_sure;
        }
        default: {
            const bool is_sure = measure_as<Measure::faces>(mesh, v, link, region);
            x[0] = static_cast<double>(faces_);
            return is_sure;
        }
    }
}

template class CellMeasures<double>;
template class CellMeasures<Twofold>;

}  // namespace mgdt
