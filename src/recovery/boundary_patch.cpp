// SPDX-License-Identifier: MIT
#include "recovery/boundary_patch.hpp"

#include <algorithm>
#include <cmath>

#include "platform/take_out_repeats.hpp"
#include "predicates/predicates.hpp"
#include "recovery/crossings.hpp"

namespace mgdt {

bool BoundaryPatch::find(std::uint32_t a, std::uint32_t b) {
    if (first_.empty()) list_triangles_at_edges();
    for (const std::uint32_t t : used_) state_[t] = 0;
    state_.resize(triangles_.size() / 3, 0);
    used_.clear();
    corners_.clear();
    const std::uint32_t edge = kept_.find(a, b);
    return edge != no_index && first_[edge] != first_[edge + 1] &&
           add(at_edge_[first_[edge]], no_index, no_index) && extend(false);
}

bool BoundaryPatch::widen() {
    const std::size_t before = corners_.size();
    return extend(true) && corners_.size() != before;
}

bool BoundaryPatch::add_neighbors(const PairTable& edges) {
    const std::size_t before = corners_.size();
    for (const bool takes_all : {false, true}) {
        for (std::size_t i = 0; i < before; ++i) {
            const Edge edge = edge_at(i);
            if (edge.neighbor == no_index || state_[edge.neighbor] != 0) continue;
            const std::uint32_t* const v = triangles_.begin() + 3 * std::size_t{edge.neighbor};
            const bool is_taken = takes_all || edges.find(v[0], v[1]) != no_index ||
                                  edges.find(v[1], v[2]) != no_index ||
                                  edges.find(v[2], v[0]) != no_index;
            if (is_taken && is_in_plane(v[0] ^ v[1] ^ v[2] ^ edge.from ^ edge.to) &&
                !add(edge.neighbor, edge.to, edge.from))
                return false;
        }
        if (corners_.size() != before) return extend(false);
    }
    return false;
}

// Adds the neighbours of triangles, their neighbours, and so on.
bool BoundaryPatch::extend(bool is_wide) {
    constexpr std::size_t most_wide = 6000;  // triangles
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        if (is_wide && used_.size() > most_wide) return false;
        const Edge edge = edge_at(i);
        const bool is_missing = !is_edge(edge.from, edge.to);
        if (edge.neighbor == no_index) {
            if (is_missing) return false;
            continue;
        }
        const std::uint32_t* const v = triangles_.begin() + 3 * std::size_t{edge.neighbor};
        const bool is_taken = is_missing || state_[edge.neighbor] != 0 ||
                              (is_wide && is_in_plane(v[0] ^ v[1] ^ v[2] ^ edge.from ^ edge.to));
        if (is_taken && !add(edge.neighbor, edge.to, edge.from)) return false;
    }
    inner_.clear();
    border_.clear();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const Edge edge = edge_at(i);
        const bool is_inner = edge.neighbor != no_index && state_[edge.neighbor] != 0;
        (is_inner ? inner_ : border_).add(edge.from, edge.to);
    }
    return measure();
}

// The edge that begins at a corner.
BoundaryPatch::Edge BoundaryPatch::edge_at(std::size_t corner) const noexcept {
    const std::uint32_t from = corners_[corner],
                        to = corners_[corner % 3 == 2 ? corner - 2 : corner + 1],
                        number = kept_.find(from, to);
    const std::uint32_t* const both = at_edge_.begin() + first_[number];
    if (first_[number + 1] - first_[number] != 2) return {from, to, no_index};
    return {from, to, both[both[0] == used_[corner / 3] ? 1 : 0]};
}

bool BoundaryPatch::is_in_mesh() {
    for (std::uint32_t i = 0; i < inner_.size(); ++i)
        if (const auto [a, b] = inner_.pair(i); !is_edge(a, b)) return false;
    return true;
}

bool BoundaryPatch::is_edge(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t t = mesh_.tetrahedron_towards(a, b);
    return t != no_tetrahedron && mesh_.tetrahedra[t].has(b);
}

// Whether the direction from the middle to a vertex is in the plane, or nearly so.
bool BoundaryPatch::is_in_plane(std::uint32_t v) const noexcept {
    constexpr double most_slope = 1e-6;
    const double* const p = mesh_.point(v);
    double height = 0;
    for (int k = 0; k < 3; ++k) height += (p[k] - middle_[k]) * normal_[k];
    return std::fabs(height) <=
           most_slope * std::hypot(p[0] - middle_[0], p[1] - middle_[1], p[2] - middle_[2]);
}

void BoundaryPatch::list_triangles_at_edges() {
    const auto for_each_side = [&](const auto& use) {
        for (std::uint32_t i = 0; i < triangles_.size(); ++i)
            use(kept_.find(triangles_[i], triangles_[i % 3 == 2 ? i - 2 : i + 1]), i / 3);
    };
    first_.resize(kept_.size() + 1, 0);
    at_edge_.resize(triangles_.size());
    for_each_side([&](std::uint32_t edge, std::uint32_t) { ++first_[edge]; });
    std::uint32_t sum = 0;
    for (std::uint32_t& first : first_) first = sum += first;
    for_each_side([&](std::uint32_t edge, std::uint32_t t) { at_edge_[--first_[edge]] = t; });
}

// Adds a triangle, turned so that its edge runs from `from` to `to`. If the patch has the triangle
// already, returns whether it is turned like that.
bool BoundaryPatch::add(std::uint32_t triangle, std::uint32_t from, std::uint32_t to) {
    const std::uint32_t* const v = triangles_.begin() + 3 * std::size_t{triangle};
    bool is_turned = false;
    for (int k = 0; k < 3; ++k) is_turned = is_turned || (v[k] == to && v[(k + 1) % 3] == from);
    const std::uint8_t state = is_turned ? 2 : 1;
    if (state_[triangle] != 0) return state_[triangle] == state;
    state_[triangle] = state;
    used_.push_back(triangle);
    for (const int k : {0, is_turned ? 2 : 1, is_turned ? 1 : 2}) corners_.push_back(v[k]);
    return true;
}

// Finds the normal, the middle and the radius.
bool BoundaryPatch::measure() {
    vertices_.clear();
    for (const std::uint32_t v : corners_) vertices_.push_back(v);
    take_out_repeats(vertices_);
    for (int k = 0; k < 3; ++k) normal_[k] = middle_[k] = 0;
    for (std::size_t i = 0; i < corners_.size(); i += 3) {
        const double* p[3];
        for (std::size_t k = 0; k < 3; ++k) p[k] = mesh_.point(corners_[i + k]);
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            normal_[k] += (p[1][l] - p[0][l]) * (p[2][m] - p[0][m]) -
                          (p[1][m] - p[0][m]) * (p[2][l] - p[0][l]);
        }
    }
    const double length = std::hypot(normal_[0], normal_[1], normal_[2]);
    if (!(length > 0) || !std::isfinite(length)) return false;
    for (double& c : normal_) c /= length;
    for (std::size_t i = 0; i < corners_.size(); i += 3)
        if (!(area(mesh_.point(corners_[i]), mesh_.point(corners_[i + 1]),
                   mesh_.point(corners_[i + 2])) > 0))
            return false;
    // The weights are no simple fractions, so that points avoid planes of a lattice.
    const double* const start = mesh_.point(vertices_[0]);
    double sum = 0, weight = 1;
    for (const std::uint32_t v : vertices_) {
        weight = weight < 1.1 ? weight * 1.0137 : 1;
        sum += weight;
        for (int k = 0; k < 3; ++k) middle_[k] += weight * (mesh_.point(v)[k] - start[k]);
    }
    for (int k = 0; k < 3; ++k) middle_[k] = start[k] + middle_[k] / sum;
    boxes_.clear();
    for (std::size_t i = 0; i < corners_.size(); i += 3) {
        boxes_.push_back(BoundingBox(mesh_.point(corners_[i])));
        for (std::size_t k = 1; k < 3; ++k) boxes_.back().include(mesh_.point(corners_[i + k]));
    }
    radius_ = 0;
    for (const std::uint32_t v : vertices_) {
        const double* const p = mesh_.point(v);
        radius_ =
            std::max(radius_, std::hypot(p[0] - middle_[0], p[1] - middle_[1], p[2] - middle_[2]));
    }
    return std::isfinite(radius_);
}

double BoundaryPatch::area(const double* a, const double* b, const double* c) const noexcept {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        sum += normal_[k] * ((b[l] - a[l]) * (c[m] - a[m]) - (b[m] - a[m]) * (c[l] - a[l]));
    }
    return sum;
}

bool BoundaryPatch::is_met_by(std::uint32_t a, std::uint32_t b) const noexcept {
    const double *const p = mesh_.point(a), *const q = mesh_.point(b);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const std::uint32_t* const v = corners_.begin() + 3 * i;
        // Most triangles are far away, so their boxes are kept.
        if (!boxes_[i].has_beside(p, q) &&
            Crossings::of_triangle(mesh_, {v[0], v[1], v[2]}).of_edge(a, b) == 1)
            return true;
    }
    if (!has_vertex(a) || !has_vertex(b)) return false;
    double middle[3];
    for (int k = 0; k < 3; ++k) middle[k] = 0.5 * (p[k] + q[k]);
    const std::size_t i = triangle_at(middle);
    if (i == corners_.size()) return false;
    const double *const u = mesh_.point(corners_[i]), *const v = mesh_.point(corners_[i + 1]),
                        *const w = mesh_.point(corners_[i + 2]);
    return orientation(u, v, w, p) == 0 && orientation(u, v, w, q) == 0;
}

bool BoundaryPatch::is_outer_triangle(std::uint32_t a, std::uint32_t b,
                                      std::uint32_t c) const noexcept {
    const std::uint32_t edge = kept_.find(a, b);
    return edge != no_index &&
           std::any_of(at_edge_.begin() + first_[edge], at_edge_.begin() + first_[edge + 1],
                       [&](std::uint32_t t) {
                           const std::uint32_t* const v = triangles_.begin() + 3 * std::size_t{t};
                           return (v[0] ^ v[1] ^ v[2] ^ a ^ b) == c && state_[t] == 0;
                       });
}

// Where the corners of a triangle begin that is right above or below a place, up to rounding, or
// the number of all corners.
std::size_t BoundaryPatch::triangle_at(const double (&x)[3]) const noexcept {
    std::size_t i = 0;
    for (; i < corners_.size(); i += 3) {
        const double* p[3];
        for (std::size_t k = 0; k < 3; ++k) p[k] = mesh_.point(corners_[i + k]);
        if (area(p[0], p[1], x) >= 0 && area(p[1], p[2], x) >= 0 && area(p[2], p[0], x) >= 0) break;
    }
    return i;
}

}  // namespace mgdt
