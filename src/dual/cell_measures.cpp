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

template <Measure M>
void CellMeasures::add_whole(const Link& link) {
    const Buffer<LinkTriangle>& triangles = link.triangles();
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (unsigned k = 0; k < 3; ++k) {
            const std::uint32_t j = triangles[i].beyond[k];
            if (j < i) continue;
            const Corner &a = cell_.corner(i), &b = cell_.corner(j);
            const Side &p = cell_.side(triangles[i].corner[before(k)]),
                       &r = cell_.side(triangles[i].corner[after(k)]);
            const Vector<double> a_cross_b = cross(a.x, b.x);
            sums_.add_edge<M>({p, 1, 0}, a, b, a_cross_b);
            sums_.add_edge<M>({r, 1, 0}, b, a,
                              {{-a_cross_b.x[0], -a_cross_b.x[1], -a_cross_b.x[2]}});
        }
    sums_.reach(cell_.radius());
}

template <Measure M>
void CellMeasures::add_polygon(const Sums::Face& face) {
    const Buffer<Corner>& corners = polygon_.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Corner &a = corners[i], &b = corners[i + 1 == corners.size() ? 0 : i + 1];
        sums_.add_edge<M>(face, a, b, cross(a.x, b.x));
        is_known_ &= !a.is_ideal;
        sums_.reach(a.size);
    }
    // Clipping may have kept or removed an area wrongly. The error bound includes this area.
    if (polygon_.slack() > 0) sums_.add_doubt<M>(face, polygon_.slack());
}

// Finds the planes of the region that may have a corner of the cell on their outer side.
void CellMeasures::find_cuts(const Link& link, const Region& region) {
    cutting_.clear();
    if (!region.is_bounded()) return;
    if (cell_.is_bounded() && region.clearance(point_) * cell_.factor() > cell_.radius()) return;
    const double reach = 2 * region.extent() * cell_.factor();
    polygon_.set_reach(reach);
    for (std::size_t k = 0; k < region.size(); ++k) {
        const Side side = region.side(k, point_, cell_.factor());
        const bool is_cutting = !Polygon::are_inside(side, reach, [&](auto look) {
            for (std::size_t i = 0; i < link.triangles().size(); ++i) look(cell_.corner(i));
        });
        if (is_cutting) cutting_.push_back({k, side});
    }
}

// Sets the polygon to the face of a neighbour, clipped by the planes of the region. Records in
// touches_ the planes that the face may reach; after uncertain clipping, all planes count.
void CellMeasures::set_face(const Link& link, std::size_t rank) {
    const std::uint32_t b = order_[rank];
    polygon_.clear();
    link.for_ring(b, first_[b], [&](std::uint32_t i, std::uint32_t next) {
        polygon_.push_back(cell_.corner(i), next);
    });
    for (std::size_t k = 0; k < cutting_.size(); ++k) {
        const Cut& cut = cutting_[k];
        const bool is_surely_inside =
            polygon_.slack() == 0 &&
            Polygon::are_inside(cut.side, polygon_.reach(), [&](auto look) {
                for (const Corner& corner : polygon_.corners()) look(corner);
            });
        if (is_surely_inside) continue;
        touches_.push_back({k, rank});
        polygon_.clip(cut.side, static_cast<std::uint32_t>(link.neighbor_count() + cut.plane));
    }
}

void CellMeasures::settle(const Side& plane, const Link& link, const Region& region) {
    const std::size_t n = link.neighbor_count();
    polygon_.settle(plane, [&](std::uint32_t label) {
        return label < n ? cell_.side(label) : region.side(label - n, point_, cell_.factor());
    });
}

// Sets the polygon to the face in a plane of the region. Only neighbours whose faces touch the
// plane are needed; docs/theory.md, "Cells", shows why.
void CellMeasures::set_region_face(const Cut& cut, const Link& link, const Region& region,
                                   const Touch* begin, const Touch* end) {
    const auto n = static_cast<std::uint32_t>(link.neighbor_count());
    region.set_face(cut.plane, point_, cell_.factor(), n, polygon_);
    for (; begin != end && !polygon_.corners().empty(); ++begin) {
        const std::uint32_t b = order_[begin->neighbor];
        polygon_.clip(cell_.side(b), b);
    }
    switch (overlap_with_cell()) {
        case Overlap::some:
            break;
        case Overlap::none:
            return polygon_.clear();
        case Overlap::unknown:
            for (const std::uint32_t b : order_) {
                polygon_.clip(cell_.side(b), b);
                if (polygon_.corners().empty()) break;
            }
    }
    settle(cut.side, link, region);
}

// Whether the polygon overlaps with the cell. If the clipping was uncertain, a corner may be wrong.
// A corner outside the cell then proves nothing.
Overlap CellMeasures::overlap_with_cell() const {
    const Buffer<Corner>& corners = polygon_.corners();
    const auto has_edge = [&](std::size_t i, std::size_t rank) {
        return order_[rank] == polygon_.label(i) || order_[rank] == polygon_.label_before(i);
    };
    const auto sign_at = [&](std::size_t i, std::size_t rank) {
        return Polygon::sign_at(corners[i], cell_.side(order_[rank]));
    };
    return find_overlap(corners.size(), order_.size(), has_edge, sign_at,
                        polygon_.slack() == 0 ? Overlap::none : Overlap::unknown);
}

// Adds all faces. The face of a neighbour is clipped by the cutting planes; the face in a cutting
// plane is clipped by the half-spaces of the neighbours.
template <Measure M>
void CellMeasures::add_clipped(const Link& link, const Region& region) {
    link.find_rings([&](std::uint32_t b) { return cell_.index(b); }, first_);
    order_.clear();
    for (std::uint32_t b = 0; b < link.neighbor_count(); ++b)
        if (link.neighbor(b) != infinite_vertex) order_.push_back(b);
    std::sort(order_.begin(), order_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return cell_.index(a) < cell_.index(b); });
    touches_.clear();
    for (std::size_t rank = 0; rank < order_.size(); ++rank) {
        set_face(link, rank);
        add_polygon<M>({cell_.side(order_[rank]), 1, 0});
    }
    std::sort(touches_.begin(), touches_.end(), [](const Touch& a, const Touch& b) {
        return a.cut != b.cut ? a.cut < b.cut : a.neighbor < b.neighbor;
    });
    const Touch* touch = touches_.begin();
    for (std::size_t k = 0; k < cutting_.size(); ++k) {
        const Touch* const begin = touch;
        while (touch != touches_.end() && touch->cut == k) ++touch;
        set_region_face(cutting_[k], link, region, begin, touch);
        add_polygon<M>(FaceSums::face_in_plane(cutting_[k].side));
    }
}

// Whether the tetrahedra of a triangle of the link and of the adjacent triangle across edge
// `beyond` have the same circumcentre or, for ghosts, hull facets in one plane.
bool CellMeasures::is_one_corner(const Mesh& mesh, VertexId v, const Link& link,
                                 std::size_t triangle, unsigned beyond) const {
    const LinkTriangle& t = link.triangles()[triangle];
    const std::size_t other = t.beyond[beyond];
    const Corner &a = cell_.corner(triangle), &b = cell_.corner(other);
    if (a.is_ideal != b.is_ideal) return false;
    // The apex is the vertex of the other triangle that triangle t does not have.
    const LinkTriangle& of = link.triangles()[other];
    const std::uint32_t p = t.corner[after(beyond)], q = t.corner[before(beyond)];
    std::uint32_t apex = of.corner[0];
    for (const std::uint32_t corner : of.corner)
        if (corner != p && corner != q) apex = corner;
    const auto point = [&](std::uint32_t number) { return mesh.point(link.neighbor(number)); };
    if (a.is_ideal)
        // Both triangles belong to ghosts, because the vertex at infinity is an end of their common
        // edge. The two corners are one direction if the two hull facets are in one plane.
        return orientation(mesh.point(v), point(link.neighbor(p) == infinite_vertex ? q : p),
                           point(t.corner[beyond]), point(apex)) == 0;
    if (length(a.x - b.x) > 2 * (a.error + b.error)) return false;
    return side_of_sphere(mesh.point(v), point(t.corner[0]), point(t.corner[1]), point(t.corner[2]),
                          point(apex)) == 0;
}

// The number of faces with at least three edges of positive length. Other faces have no area.
std::size_t CellMeasures::count_faces(const Mesh& mesh, VertexId v, const Link& link) {
    edges_.resize(0);
    edges_.resize(link.neighbor_count(), 0);
    const Buffer<LinkTriangle>& triangles = link.triangles();
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (unsigned k = 0; k < 3; ++k) {
            if (triangles[i].beyond[k] < i || is_one_corner(mesh, v, link, i, k)) continue;
            ++edges_[triangles[i].corner[before(k)]];
            ++edges_[triangles[i].corner[after(k)]];
        }
    std::size_t faces = 0;
    for (std::size_t b = 0; b < link.neighbor_count(); ++b)
        faces += link.neighbor(b) != infinite_vertex && edges_[b] >= 3;
    return faces;
}

template <Measure M>
bool CellMeasures::measure_as(const Link& link, const Region& region) {
    sums_.clear();
    is_known_ = true;
    if (cutting_.empty())
        add_whole<M>(link);
    else
        add_clipped<M>(link, region);
    return is_known_ && sums_.is_sure<M>();
}

bool CellMeasures::measure(const Mesh& mesh, VertexId v, const Link& link, const Region& region,
                           Measure measure, Centers centers, double* x) {
    cell_.make(mesh, v, link, centers);
    point_ = mesh.point(v);
    if (measure == Measure::faces) {
        if (region.is_bounded()) {
            if (!cell_.is_ordinary() || !region.is_ordinary()) return false;
            find_cuts(link, region);
            if (!cutting_.empty()) return false;
        }
        x[0] = static_cast<double>(count_faces(mesh, v, link));
        return true;
    }
    if (!region.is_bounded() && !cell_.is_bounded()) {
        std::fill_n(x, width_of(measure), std::numeric_limits<double>::infinity());
        return true;
    }
    if (!cell_.is_ordinary() || !region.is_ordinary()) return false;
    find_cuts(link, region);
    const int exponent = -(std::ilogb(cell_.factor()) + mesh.scale);
    switch (measure) {
        case Measure::volume:
            if (!measure_as<Measure::volume>(link, region)) return false;
            x[0] = std::ldexp(sums_.volume(), 3 * exponent);
            return true;
        case Measure::area:
            if (!measure_as<Measure::area>(link, region)) return false;
            x[0] = std::ldexp(sums_.area(), 2 * exponent);
            return true;
        default:
            if (!measure_as<Measure::centroid>(link, region)) return false;
            for (int k = 0; k < 3; ++k) {
                const double offset = sums_.centroid(k) / cell_.factor();
                x[k] =
                    scaled(measure == Measure::centroid ? point_[k] + offset : offset, -mesh.scale);
            }
            return true;
    }
}

}  // namespace mgdt
