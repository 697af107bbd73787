// SPDX-License-Identifier: MIT
#include "dual/cell_faces.hpp"

#include <algorithm>

namespace mgdt {

// The planes of the region that some corner of the cell may be beyond.
void CellFaces::find_cutting(const Link& link, const Cell& cell, const Region& region) {
    cutting_.clear();
    const std::size_t n = link.neighbor_count();
    for (std::size_t k = 0; k < region.size(); ++k) {
        const auto plane = static_cast<PlaneNumber>(n + k);
        const bool is_surely_inside =
            cell.is_ordinary() && cell.is_bounded() &&
            Polygon::are_inside(half_spaces_.side(plane), 0, [&](auto look) {
                for (std::size_t i = 0; i < link.triangles().size(); ++i) look(cell.corner(i));
            });
        if (!is_surely_inside) cutting_.push_back(plane);
    }
}

// What the neighbours leave of the plane of b: from the circumcentres around it where these are
// points that are surely apart.
void CellFaces::set_polygon(const Link& link, const Cell& cell, std::uint32_t b) {
    bool are_apart = cell.is_ordinary();
    const Corner<double>* before = nullptr;
    const auto look = [&](std::uint32_t i, std::uint32_t) {
        const Corner<double>& corner = cell.corner(i);
        are_apart &= !corner.is_ideal &&
                     (!before || length(corner.x - before->x) > 2 * (corner.error + before->error));
        before = &corner;
    };
    link.for_ring(b, first_[b], look);
    look(first_[b], 0);
    if (are_apart) {
        polygon_.begin(b);
        link.for_ring(b, first_[b], [&](std::uint32_t i, std::uint32_t next) {
            polygon_.add(cell.corner(i), next);
        });
        return;
    }
    ring_.clear();
    link.for_ring(b, first_[b], [&](std::uint32_t, std::uint32_t next) {
        if (link.neighbor(next) != infinite_vertex) ring_.push_back(next);
    });
    // Which of two planes through one line is an edge must not depend on where the ring begins.
    std::sort(ring_.begin(), ring_.end(),
              [&](PlaneNumber a, PlaneNumber c) { return cell.index(a) < cell.index(c); });
    polygon_.set_far(b);
    for (const PlaneNumber plane : ring_) polygon_.clip(plane, true);
}

void CellFaces::add_whole(const Link& link, std::uint32_t b) {
    const std::size_t begin = edges_.size();
    link.for_ring(b, first_[b], [&](std::uint32_t, std::uint32_t next) { edges_.push_back(next); });
    faces_.push_back({b, begin, edges_.size()});
}

void CellFaces::add_polygon() {
    if (polygon_.is_empty()) return;
    const std::size_t begin = edges_.size();
    for (std::size_t i = 0; i < polygon_.size(); ++i) edges_.push_back(polygon_.edge(i));
    faces_.push_back({polygon_.plane(), begin, edges_.size()});
}

void CellFaces::find(const Mesh& mesh, VertexId v, const Link& link, const Cell& cell,
                     const Region& region) {
    const std::size_t n = link.neighbor_count();
    faces_.clear();
    edges_.clear();
    exponent_ = std::ilogb(cell.factor());
    half_spaces_.clear(mesh.point(v), cell.factor());
    for (std::size_t b = 0; b < n; ++b) {
        if (link.neighbor(b) == infinite_vertex)
            half_spaces_.add_nothing();
        else
            half_spaces_.add_nearer_side(mesh.point(link.neighbor(b)));
    }
    for (std::size_t k = 0; k < region.size(); ++k)
        half_spaces_.add_plane(region.numbers(k), mesh.scale);
    first_.resize(n);
    for (std::uint32_t i = 0; i < link.triangles().size(); ++i)
        for (const std::uint32_t corner : link.triangles()[i].corner) first_[corner] = i;
    order_.clear();
    for (std::uint32_t b = 0; b < n; ++b)
        if (link.neighbor(b) != infinite_vertex) order_.push_back(b);
    std::sort(order_.begin(), order_.end(),
              [&](PlaneNumber a, PlaneNumber b) { return cell.index(a) < cell.index(b); });
    find_cutting(link, cell, region);
    for (const PlaneNumber b : order_) {
        if (cutting_.empty()) {
            add_whole(link, b);
            continue;
        }
        set_polygon(link, cell, b);
        for (const PlaneNumber plane : cutting_) {
            if (polygon_.is_empty()) break;
            polygon_.clip(plane, true);
        }
        add_polygon();
    }
    // Of a plane of the region and a side of a neighbour that are one, the neighbour has the face.
    for (const PlaneNumber plane : cutting_) {
        polygon_.set_far(plane);
        for (const PlaneNumber other : cutting_)
            if (other != plane) polygon_.clip(other, true);
        for (const PlaneNumber b : order_) {
            if (polygon_.is_empty()) break;
            polygon_.clip(b, false);
        }
        add_polygon();
    }
}

}  // namespace mgdt
