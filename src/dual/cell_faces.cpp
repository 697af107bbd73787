// SPDX-License-Identifier: MIT
#include "dual/cell_faces.hpp"

#include <algorithm>

#include "mesh/facet_turns.hpp"
#include "platform/hash.hpp"

namespace mgdt {

// Finds the planes of the region that may have a corner of the cell on their outer side.
void CellFaces::find_cutting(const Link& link, const Cell& cell, const Region& region) {
    cutting_.clear();
    for (std::size_t k = 0; k < region.size(); ++k) {
        const auto plane = static_cast<PlaneNumber>(order_.size() + k);
        const bool is_surely_inside =
            cell.is_ordinary() && cell.is_bounded() &&
            Polygon::are_inside(half_spaces_.side(plane), 0, [&](auto look) {
                for (std::size_t i = 0; i < link.triangles().size(); ++i) look(cell.corner(i));
            });
        if (!is_surely_inside) cutting_.push_back(plane);
    }
}

// Sets the polygon to the face in the plane of a neighbour, which the half-spaces of the other
// neighbours bound. If the circumcentres around the neighbour are finite and certainly distinct,
// they are the corners. Otherwise the other neighbours clip the polygon one by one.
void CellFaces::set_polygon(const Link& link, const Cell& cell, PlaneNumber plane) {
    const std::uint32_t b = order_[plane];
    bool are_apart = cell.is_ordinary();
    const mgdt::Corner* before = nullptr;
    const auto look = [&](std::uint32_t i, std::uint32_t) {
        const mgdt::Corner& corner = cell.corner(i);
        are_apart &= !corner.is_ideal &&
                     (!before || length(corner.x - before->x) > 2 * (corner.error + before->error));
        before = &corner;
    };
    link.for_ring(b, first_[b], look);
    look(first_[b], 0);
    if (are_apart) {
        polygon_.begin(plane);
        link.for_ring(b, first_[b], [&](std::uint32_t i, std::uint32_t next) {
            polygon_.add(cell.corner(i), rank_[next]);
        });
        return;
    }
    ring_.clear();
    link.for_ring(b, first_[b], [&](std::uint32_t, std::uint32_t next) {
        if (link.neighbor(next) != infinite_vertex) ring_.push_back(rank_[next]);
    });
    // The planes are sorted: if two planes contain the same edge, the one that becomes its label
    // must not depend on where the ring begins.
    std::sort(ring_.begin(), ring_.end());
    polygon_.set_far(plane);
    for (const PlaneNumber other : ring_) polygon_.clip(other, true);
}

void CellFaces::add_whole(const Link& link, PlaneNumber plane) {
    const std::uint32_t b = order_[plane];
    ring_.clear();
    link.for_ring(b, first_[b],
                  [&](std::uint32_t, std::uint32_t next) { ring_.push_back(rank_[next]); });
    add_face(plane);
}

void CellFaces::add_polygon() {
    if (polygon_.is_empty()) return;
    ring_.clear();
    for (std::size_t i = 0; i < polygon_.size(); ++i) ring_.push_back(polygon_.edge(i));
    add_face(polygon_.plane());
}

// Adds the face whose edges are in the ring, beginning at the edge with the least number.
void CellFaces::add_face(PlaneNumber plane) {
    const std::size_t begin = edges_.size();
    PlaneNumber* const least = std::min_element(ring_.begin(), ring_.end());
    for (const PlaneNumber* edge = least; edge != ring_.end(); ++edge) edges_.push_back(*edge);
    for (const PlaneNumber* edge = ring_.begin(); edge != least; ++edge) edges_.push_back(*edge);
    faces_.push_back({plane, begin, edges_.size()});
}

// Adds the face of the cell in a plane of the region. The face is found from the neighbours whose
// own faces touch the plane; docs/theory.md, "Cells", shows that these neighbours are enough. If
// the plane of the region coincides with the plane of a neighbour, the face belongs to the
// neighbour.
void CellFaces::add_region_face(std::size_t cut) {
    polygon_.set_far(cutting_[cut]);
    for (const PlaneNumber other : cutting_)
        if (other != cutting_[cut]) polygon_.clip(other, true);
    const Touch* touch = std::partition_point(touches_.begin(), touches_.end(),
                                              [&](const Touch& t) { return t.cut < cut; });
    for (; touch != touches_.end() && touch->cut == cut && !polygon_.is_empty(); ++touch)
        polygon_.clip(touch->neighbor, false);
    switch (overlap_with_cell()) {
        case Overlap::some:
            break;
        case Overlap::none:
            return;
        case Overlap::unknown:
            for (PlaneNumber b = 0; b < order_.size() && !polygon_.is_empty(); ++b)
                polygon_.clip(b, false);
    }
    add_polygon();
}

// Whether the polygon overlaps with the cell.
Overlap CellFaces::overlap_with_cell() {
    const auto has_edge = [&](std::size_t i, std::size_t b) {
        return b == polygon_.edge(i) || b == polygon_.edge_before(i);
    };
    const auto sign_at = [&](std::size_t i, std::size_t b) {
        return polygon_.sign_at(i, static_cast<PlaneNumber>(b));
    };
    return find_overlap(polygon_.size(), order_.size(), has_edge, sign_at, Overlap::none);
}

void CellFaces::number_planes(const Mesh& mesh, VertexId v, const Link& link, const Cell& cell,
                              const Region& region) {
    const std::size_t n = link.neighbor_count();
    order_.clear();
    for (std::uint32_t b = 0; b < n; ++b)
        if (link.neighbor(b) != infinite_vertex) order_.push_back(b);
    std::sort(order_.begin(), order_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return cell.index(a) < cell.index(b); });
    rank_.resize(n);
    half_spaces_.clear(mesh.point(v), cell.factor());
    for (PlaneNumber plane = 0; plane < order_.size(); ++plane) {
        rank_[order_[plane]] = plane;
        half_spaces_.add_nearer_side(mesh.point(link.neighbor(order_[plane])));
    }
    for (std::size_t k = 0; k < region.size(); ++k)
        half_spaces_.add_plane(region.numbers(k), mesh.scale);
}

void CellFaces::find(const Mesh& mesh, VertexId v, const Link& link, const Cell& cell,
                     const Region& region) {
    faces_.clear();
    edges_.clear();
    number_planes(mesh, v, link, cell, region);
    const auto neighbors = static_cast<PlaneNumber>(order_.size());
    link.find_rings([&](std::uint32_t b) { return cell.index(b); }, first_);
    find_cutting(link, cell, region);
    touches_.clear();
    for (PlaneNumber plane = 0; plane < neighbors; ++plane) {
        if (cutting_.empty()) {
            add_whole(link, plane);
            continue;
        }
        set_polygon(link, cell, plane);
        for (std::size_t cut = 0; cut < cutting_.size() && !polygon_.is_empty(); ++cut)
            if (polygon_.clip(cutting_[cut], true)) touches_.push_back({cut, plane});
        add_polygon();
    }
    std::sort(touches_.begin(), touches_.end(), [](const Touch& a, const Touch& b) {
        return a.cut != b.cut ? a.cut < b.cut : a.neighbor < b.neighbor;
    });
    for (std::size_t cut = 0; cut < cutting_.size(); ++cut) add_region_face(cut);
    number_corners();
}

// Numbers the corners. Each corner belongs to three faces, and each of the faces gives its three
// planes in the same cyclic order.
void CellFaces::number_corners() {
    corner_numbers_.clear(edges_.size());
    corners_.clear();
    corner_of_edge_.resize(edges_.size());
    for (const Face& face : faces_)
        for (std::size_t i = face.begin; i < face.end; ++i) {
            const PlaneNumber before = edges_[i == face.begin ? face.end - 1 : i - 1];
            Corner corner = {{face.plane, before, edges_[i]}};
            turn_to_least(corner.plane);
            corner_of_edge_[i] = corner_number(corner);
        }
}

std::uint32_t CellFaces::corner_number(const Corner& corner) {
    const PlaneNumber* const plane = corner.plane;
    const std::uint32_t number = corner_numbers_.number(
        hash_of_words(plane[0], plane[1], plane[2]),
        [&](std::uint32_t i) { return std::equal(plane, plane + 3, corners_[i].plane); });
    if (number == corners_.size()) corners_.push_back(corner);
    return number;
}

}  // namespace mgdt
