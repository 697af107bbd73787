// SPDX-License-Identifier: MIT
#include "recovery/triangle_sheet.hpp"

#include <algorithm>
#include <cmath>

namespace mgdt {

bool TriangleSheet::is_on_sheet(std::uint32_t v) const noexcept {
    return std::find(corner_, corner_ + 3, v) != corner_ + 3 ||
           std::find(inner_.begin(), inner_.end(), v) != inner_.end();
}

bool TriangleSheet::recover(const std::uint32_t (&v)[3], const TriangleWalk& walk) {
    std::copy_n(v, 3, corner_);
    double e[2][3], size = 0;
    for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 3; ++k) e[i][k] = mesh_.point(v[i + 1])[k] - mesh_.point(v[0])[k];
    for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        normal_[k] = e[0][l] * e[1][m] - e[0][m] * e[1][l];
        size += normal_[k] * normal_[k];
    }
    for (double& c : normal_) c /= std::sqrt(size);
    const std::size_t state = mesh_.state();
    for (const bool centers : {true, false}) {
        centers_ = centers;
        bool is_done = build(walk);
        while (is_done && !inner_.empty()) is_done = withdraw(inner_.back());
        if (is_done) return true;
        mesh_.undo(state);
    }
    return false;
}

// Divides the edges that cross the triangle.
bool TriangleSheet::build(const TriangleWalk& walk) {
    inner_.clear();
    return std::all_of(walk.edges().begin(), walk.edges().end(),
                       [&](const TriangleWalk::Edge& edge) { return divide_edge(edge.p, edge.q); });
}

bool TriangleSheet::divide_edge(std::uint32_t p, std::uint32_t q) {
    if (!ring_.collect(mesh_, p, q)) return false;
    const double *const a = mesh_.point(corner_[0]), *const pp = mesh_.point(p),
                        *const pq = mesh_.point(q);
    double along = 0, to = 0, x[3];
    for (int k = 0; k < 3; ++k) {
        along += (pq[k] - pp[k]) * normal_[k];
        to += (a[k] - pp[k]) * normal_[k];
    }
    const double t = to / along;
    if (!(t > 0) || !(t < 1)) return false;
    for (int k = 0; k < 3; ++k) x[k] = pp[k] + t * (pq[k] - pp[k]);
    const std::uint32_t s = mesh_.add_point(x);
    if (!ring_.join(mesh_, s)) return false;
    inner_.push_back(s);
    return true;
}

// Takes an inner vertex out of the sheet.
bool TriangleSheet::withdraw(std::uint32_t s) {
    mesh_.collect_star(s, star_);
    if (!find_cycle(s) || !find_sides(s)) return false;
    added_.clear();
    if (!fill_side(0, s) || !fill_side(1, s) || !mesh_.replace(star_, added_)) return false;
    mesh_.hints[s] = no_tetrahedron;
    inner_.resize(
        static_cast<std::size_t>(std::remove(inner_.begin(), inner_.end(), s) - inner_.begin()));
    return true;
}

// Finds the polygon of the neighbours of s in the sheet, and triangulates it. Below a face (s, x,
// y) of the sheet is a tetrahedron (s, x, y, d); it is positive if x turns to y counter-clockwise
// as seen from below.
bool TriangleSheet::find_cycle(std::uint32_t s) {
    cycle_.clear();
    std::uint32_t start = no_index;
    for (const std::uint32_t t : star_)
        for (const std::uint32_t v : mesh_.tetrahedra[t].v)
            if (v != s && is_on_sheet(v)) start = std::min(start, v);
    if (start == no_index) return false;
    std::uint32_t here = start;
    do {
        // The face of the sheet at s and `here` that goes on counter-clockwise as seen from above.
        std::uint32_t next = no_index;
        for (const std::uint32_t t : star_) {
            const FlipMesh::Tetrahedron& tet = mesh_.tetrahedra[t];
            if (!tet.has(here)) continue;
            std::uint32_t on = no_index, off = no_index;
            for (const std::uint32_t v : tet.v) {
                if (v == s || v == here) continue;
                (is_on_sheet(v) ? on : off) = v;
            }
            if (on == no_index || off == no_index) continue;
            double height = 0;
            for (int k = 0; k < 3; ++k)
                height += (mesh_.point(off)[k] - mesh_.point(corner_[0])[k]) * normal_[k];
            // Above, (s, here, next, off) is positive.
            if (height > 0 && mesh_.is_positive({{s, here, on, off}})) next = on;
        }
        if (next == no_index || cycle_.size() > star_.size()) return false;
        cycle_.push_back(here);
        here = next;
    } while (here != start);
    return cycle_.size() >= 3 && triangulate_cycle();
}

// Triangulates the polygon so that its flattest triangle is as good as possible.
bool TriangleSheet::triangulate_cycle() {
    const std::size_t n = cycle_.size();
    constexpr double none = HUGE_VAL;
    best_.clear();
    best_.resize(n * n, {none, 0});
    for (std::size_t i = 0; i + 1 < n; ++i) best_[i * n + i + 1].flatness = 0;
    for (std::size_t length = 2; length < n; ++length)
        for (std::size_t i = 0; i + length < n; ++i)
            for (std::size_t j = i + length, m = i + 1; m < j; ++m) {
                const double worst = std::max({best_[i * n + m].flatness, best_[m * n + j].flatness,
                                               flatness(cycle_[i], cycle_[m], cycle_[j])});
                if (worst < best_[i * n + j].flatness) best_[i * n + j] = {worst, m};
            }
    if (!(best_[n - 1].flatness < none)) return false;
    polygon_.clear();
    stack_.clear();
    stack_.push_back(static_cast<std::uint32_t>(n - 1));
    while (!stack_.empty()) {
        const std::size_t i = stack_.back() / n, j = stack_.back() % n;
        stack_.resize(stack_.size() - 1);
        if (j < i + 2) continue;
        const std::size_t m = best_[i * n + j].middle;
        for (const std::size_t of : {i, m, j}) polygon_.push_back(cycle_[of]);
        stack_.push_back(static_cast<std::uint32_t>(i * n + m));
        stack_.push_back(static_cast<std::uint32_t>(m * n + j));
    }
    return true;
}

// The square of the longest side of a triangle over its area, as seen from above.
double TriangleSheet::flatness(std::uint32_t a, std::uint32_t b, std::uint32_t c) const noexcept {
    const double *const pa = mesh_.point(a), *const pb = mesh_.point(b), *const pc = mesh_.point(c);
    double area = 0, sides[3] = {0, 0, 0};
    for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        area +=
            normal_[k] * ((pb[l] - pa[l]) * (pc[m] - pa[m]) - (pb[m] - pa[m]) * (pc[l] - pa[l]));
        sides[0] += (pb[k] - pa[k]) * (pb[k] - pa[k]);
        sides[1] += (pc[k] - pb[k]) * (pc[k] - pb[k]);
        sides[2] += (pa[k] - pc[k]) * (pa[k] - pc[k]);
    }
    const double longest = *std::max_element(sides, sides + 3);
    return area > 1e-12 * longest ? longest / area : HUGE_VAL;
}

// Finds the side of each tetrahedron at s.
bool TriangleSheet::find_sides(std::uint32_t s) {
    side_of_.clear();
    side_of_.resize(star_.size(), no_index);
    const auto is_on_cycle = [&](std::uint32_t v) {
        return std::find(cycle_.begin(), cycle_.end(), v) != cycle_.end();
    };
    for (std::size_t first = 0; first < star_.size(); ++first) {
        if (side_of_[first] != no_index) continue;
        // The side is that of a vertex off the sheet.
        std::uint32_t off = no_index;
        for (const std::uint32_t v : mesh_.tetrahedra[star_[first]].v)
            if (v != s && !is_on_cycle(v)) off = v;
        if (off == no_index) return false;
        double height = 0;
        for (int k = 0; k < 3; ++k)
            height += (mesh_.point(off)[k] - mesh_.point(corner_[0])[k]) * normal_[k];
        const std::uint32_t side = height > 0 ? 1 : 0;
        stack_.clear();
        stack_.push_back(static_cast<std::uint32_t>(first));
        side_of_[first] = side;
        while (!stack_.empty()) {
            const FlipMesh::Tetrahedron t = mesh_.tetrahedra[star_[stack_.back()]];
            stack_.resize(stack_.size() - 1);
            for (unsigned k = 0; k < 4; ++k) {
                if (t.v[k] == s) continue;
                unsigned on_sheet = 0;
                for (unsigned m = 0; m < 4; ++m) on_sheet += m != k && is_on_sheet(t.v[m]);
                if (on_sheet == 3) continue;
                const auto at = static_cast<std::size_t>(
                    std::find(star_.begin(), star_.end(), t.n[k] / 4) - star_.begin());
                if (side_of_[at] == no_index) {
                    side_of_[at] = side;
                    stack_.push_back(static_cast<std::uint32_t>(at));
                } else if (side_of_[at] != side) {
                    return false;
                }
            }
        }
    }
    return true;
}

// Fills a side from a vertex of the side or from a new point.
bool TriangleSheet::fill_side(std::uint32_t side, std::uint32_t s) {
    for (std::size_t i = 0; i < star_.size(); ++i) {
        if (side_of_[i] != side) continue;
        const FlipMesh::Tetrahedron t = mesh_.tetrahedra[star_[i]];
        for (const std::uint32_t v : t.v)
            if (v != s && !is_on_sheet(v) && fill_from(v, side, s)) return true;
    }
    double reach = 0;
    for (const std::uint32_t v : cycle_) {
        double distance = 0;
        for (int k = 0; k < 3; ++k)
            distance = std::max(distance, std::fabs(mesh_.point(v)[k] - mesh_.point(s)[k]));
        reach = reach == 0 ? distance : std::min(reach, distance);
    }
    const std::size_t state = mesh_.state();
    for (double share = 0.5; share > 1e-14; share *= 0.2) {
        double x[3];
        for (int k = 0; k < 3; ++k)
            x[k] = mesh_.point(s)[k] + (side == 1 ? share : -share) * reach * normal_[k];
        const std::size_t before = added_.size();
        const std::uint32_t z = mesh_.add_point(x);
        if (fill_from(z, side, s)) {
            if (centers_) center_new_point(mesh_, z, added_, before, center_);
            return true;
        }
        mesh_.undo(state);
    }
    return false;
}

bool TriangleSheet::fill_from(std::uint32_t apex, std::uint32_t side, std::uint32_t s) {
    const std::size_t before = added_.size();
    for (std::size_t i = 0; i < star_.size(); ++i) {
        if (side_of_[i] != side || mesh_.tetrahedra[star_[i]].has(apex)) continue;
        FlipMesh::Corners t;
        std::copy_n(mesh_.tetrahedra[star_[i]].v, 4, t.v);
        *std::find(t.v, t.v + 4, s) = apex;
        added_.push_back(t);
    }
    for (std::size_t i = 0; i < polygon_.size(); i += 3) {
        const std::uint32_t a = polygon_[i], b = polygon_[i + 1], c = polygon_[i + 2];
        added_.push_back(side == 1 ? FlipMesh::Corners{{a, b, c, apex}}
                                   : FlipMesh::Corners{{a, c, b, apex}});
    }
    if (mesh_.are_positive(added_, before)) return true;
    added_.resize(before);
    return false;
}

}  // namespace mgdt
