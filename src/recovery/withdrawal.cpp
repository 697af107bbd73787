// SPDX-License-Identifier: MIT
#include "recovery/withdrawal.hpp"

#include <algorithm>
#include <cmath>

namespace mgdt {
namespace {

constexpr double pi = 3.14159265358979323846;

double dot(const double* a, const double* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

bool Withdrawal::run(std::uint32_t u, std::uint32_t s, std::uint32_t w) {
    u_ = u;
    s_ = s;
    w_ = w;
    mesh_.collect_star(s, star_);
    set_frame();
    find_walls();
    if (borders_.size() > 1) return find_sectors() && fill_sectors();
    // Paths are tried in several directions, as they may cross each other.
    const bool has_wall = !borders_.empty();
    const double base = has_wall ? borders_[0].angle + pi : 0;
    constexpr int tries = 12;
    for (int i = 0; i < tries; ++i) {
        borders_.resize(has_wall ? 1 : 0);
        paths_.resize(has_wall ? 1 : 0);
        const double turn = (i % 2 == 0 ? i : -i) * (has_wall ? 0.08 : 2 * pi / 3 / tries);
        bool is_complete = add_path(base + turn);
        for (int k = 1; k < 3 && !has_wall && is_complete; ++k)
            is_complete = add_path(base + turn + k * 2 * pi / 3);
        if (is_complete && find_sectors() && fill_sectors()) return true;
    }
    return false;
}

// Replaces the tetrahedra at s by those of the sectors.
bool Withdrawal::fill_sectors() {
    const std::size_t state = mesh_.state();
    for (double share = 0.5; share > 1e-14; share *= 0.2) {
        if (fill(share)) {
            if (centers_) center_points();
            if (!mesh_.replace(star_, added_)) return false;
            mesh_.hints[s_] = no_tetrahedron;
            return true;
        }
        mesh_.undo(state);
    }
    return false;
}

// Moves the new points away from the walls, one after the other.
void Withdrawal::center_points() {
    for (const std::uint32_t z : points_)
        if (z != no_index) center_new_point(mesh_, z, added_, 0, center_);
}

// Finds two directions at right angles to the axis.
void Withdrawal::set_frame() {
    for (int k = 0; k < 3; ++k) axis_[k] = mesh_.point(w_)[k] - mesh_.point(u_)[k];
    const double length = std::sqrt(dot(axis_, axis_));
    for (double& c : axis_) c /= length;
    int least = 0;
    for (int k = 1; k < 3; ++k)
        if (std::fabs(axis_[k]) < std::fabs(axis_[least])) least = k;
    for (int k = 0; k < 3; ++k) across_[k] = (k == least ? 1 : 0) - axis_[least] * axis_[k];
    const double size = std::sqrt(dot(across_, across_));
    for (double& c : across_) c /= size;
    for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        up_[k] = axis_[l] * across_[m] - axis_[m] * across_[l];
    }
}

double Withdrawal::distance_of(std::uint32_t v) const noexcept {
    double to[3];
    for (int k = 0; k < 3; ++k) to[k] = mesh_.point(v)[k] - mesh_.point(s_)[k];
    return std::hypot(dot(to, across_), dot(to, up_));
}

double Withdrawal::angle_of(std::uint32_t v) const noexcept {
    double to[3];
    for (int k = 0; k < 3; ++k) to[k] = mesh_.point(v)[k] - mesh_.point(s_)[k];
    return std::atan2(dot(to, up_), dot(to, across_));
}

// Finds the walls: vertices that are neighbours of u, s and w.
void Withdrawal::find_walls() {
    borders_.clear();
    paths_.clear();
    for (const std::uint32_t t : star_) {
        if (!mesh_.tetrahedra[t].has(u_)) continue;
        for (const std::uint32_t c : mesh_.tetrahedra[t].v) {
            if (c == u_ || c == s_ || std::find(paths_.begin(), paths_.end(), c) != paths_.end())
                continue;
            const bool is_common = std::any_of(star_.begin(), star_.end(), [&](std::uint32_t o) {
                return mesh_.tetrahedra[o].has(w_) && mesh_.tetrahedra[o].has(c);
            });
            if (!is_common) continue;
            borders_.push_back({paths_.size(), paths_.size() + 1, true, angle_of(c)});
            paths_.push_back(c);
        }
    }
    std::sort(borders_.begin(), borders_.end(), [](const Border& a, const Border& b) {
        return a.angle != b.angle ? a.angle < b.angle : a.first < b.first;
    });
}

// Finds a path near the half-plane with this angle. Its edges go around the normal of the
// half-plane in one direction.
bool Withdrawal::add_path(double angle) {
    double normal[3], along[3];
    for (int k = 0; k < 3; ++k) {
        along[k] = std::cos(angle) * across_[k] + std::sin(angle) * up_[k];
        normal[k] = std::cos(angle) * up_[k] - std::sin(angle) * across_[k];
    }
    const double* const ps = mesh_.point(s_);
    const std::size_t first = paths_.size();
    std::uint32_t here = u_;
    while (here != w_) {
        double from[3];
        for (int k = 0; k < 3; ++k) from[k] = mesh_.point(here)[k] - ps[k];
        std::uint32_t best = no_index;
        double least = 0;
        for (const std::uint32_t t : star_) {
            if (!mesh_.tetrahedra[t].has(here)) continue;
            for (const std::uint32_t v : mesh_.tetrahedra[t].v) {
                if (v == here || v == s_ || v == u_ ||
                    std::find(paths_.begin() + first, paths_.end(), v) != paths_.end())
                    continue;
                double to[3], turn[3];
                for (int k = 0; k < 3; ++k) to[k] = mesh_.point(v)[k] - ps[k];
                for (int k = 0; k < 3; ++k) {
                    const int l = (k + 1) % 3, m = (k + 2) % 3;
                    turn[k] = from[l] * to[m] - from[m] * to[l];
                }
                // The axis, the direction along the half-plane and its normal are right-handed if
                // the order is along, normal, axis: from u the path turns to -normal.
                if (!(dot(turn, normal) < 0)) continue;
                const double out = v == w_ ? 0
                                           : std::fabs(dot(to, normal)) / std::sqrt(dot(to, to)) +
                                                 (dot(to, along) > 0 ? 0 : 1);
                if (best == no_index || out < least || (out == least && v < best)) {
                    best = v;
                    least = out;
                }
            }
        }
        if (best == no_index) return false;
        if (best != w_) paths_.push_back(best);
        here = best;
    }
    borders_.push_back({first, paths_.size(), false, angle});
    return paths_.size() > first;
}

// Whether an edge opposite s is a part of a border.
bool Withdrawal::is_on_border(std::uint32_t a, std::uint32_t b) const noexcept {
    return std::any_of(borders_.begin(), borders_.end(), [&](const Border& border) {
        std::uint32_t from = u_;
        for (std::size_t i = border.first; i <= border.end; ++i) {
            const std::uint32_t to = i < border.end ? paths_[i] : w_;
            if ((a == from && b == to) || (a == to && b == from)) return true;
            from = to;
        }
        return false;
    });
}

bool Withdrawal::enter(std::uint32_t t, std::uint32_t sector) {
    const auto at =
        static_cast<std::size_t>(std::find(star_.begin(), star_.end(), t) - star_.begin());
    if (sector_of_[at] != no_index) return sector_of_[at] == sector;
    sector_of_[at] = sector;
    stack_.push_back(t);
    return true;
}

// Finds the sector of each tetrahedron. Returns false if the borders cross.
bool Withdrawal::find_sectors() {
    sector_of_.clear();
    sector_of_.resize(star_.size(), no_index);
    for (std::uint32_t sector = 0; sector < borders_.size(); ++sector) {
        const std::uint32_t c = paths_[borders_[sector].first];
        // The tetrahedron at s, u and c on the side to which the angle grows: (s, w, c, x) is
        // positive there, and so is (u, s, c, x).
        const std::uint32_t* const start =
            std::find_if(star_.begin(), star_.end(), [&](std::uint32_t t) {
                const FlipMesh::Tetrahedron& tet = mesh_.tetrahedra[t];
                if (!tet.has(u_) || !tet.has(c)) return false;
                std::uint32_t x = no_index;
                for (const std::uint32_t v : tet.v)
                    if (v != u_ && v != s_ && v != c) x = v;
                return mesh_.is_positive({{u_, s_, c, x}});
            });
        if (start == star_.end()) return false;
        stack_.clear();
        if (!enter(*start, sector)) return false;
        while (!stack_.empty()) {
            const FlipMesh::Tetrahedron t = mesh_.tetrahedra[stack_.back()];
            stack_.resize(stack_.size() - 1);
            for (unsigned k = 0; k < 4; ++k) {
                if (t.v[k] == s_) continue;
                std::uint32_t edge[2];
                int n = 0;
                for (unsigned m = 0; m < 4; ++m)
                    if (m != k && t.v[m] != s_) edge[n++] = t.v[m];
                if (!is_on_border(edge[0], edge[1]) && !enter(t.n[k] / 4, sector)) return false;
            }
        }
    }
    return std::find(sector_of_.begin(), sector_of_.end(), no_index) == sector_of_.end();
}

// Whether a sector is between two walls and consists of two tetrahedra, so that one can take their
// place.
bool Withdrawal::is_simple(std::size_t sector) const noexcept {
    const Border &border = borders_[sector], &next = borders_[(sector + 1) % borders_.size()];
    return border.is_wall && next.is_wall && borders_.size() > 1 &&
           std::count(sector_of_.begin(), sector_of_.end(), static_cast<std::uint32_t>(sector)) ==
               2 &&
           mesh_.is_positive({{u_, w_, paths_[border.first], paths_[next.first]}});
}

// The direction of a sector's point, from which the walls on both sides are visible.
double Withdrawal::angle_of_point(std::size_t sector) const noexcept {
    const std::size_t n = borders_.size();
    if (n < 2) return 0;
    const Border &border = borders_[sector], &next = borders_[(sector + 1) % n];
    double gap = next.angle - border.angle;
    while (gap <= 0) gap += 2 * pi;
    while (gap > 2 * pi) gap -= 2 * pi;
    // Beside a wall and a path, the ring is the wall's vertex and two points beside the path.
    if (n == 2 && border.is_wall != next.is_wall)
        return border.is_wall ? next.angle - pi / 3 : border.angle + pi / 3;
    return border.angle + gap / 2;
}

void Withdrawal::place_points(double share) {
    points_.clear();
    for (std::size_t sector = 0; sector < borders_.size(); ++sector) {
        if (is_simple(sector)) {
            points_.push_back(no_index);
            continue;
        }
        const double angle = angle_of_point(sector);
        const double reach =
            std::min(distance_of(paths_[borders_[sector].first]),
                     distance_of(paths_[borders_[(sector + 1) % borders_.size()].first]));
        double x[3];
        for (int k = 0; k < 3; ++k)
            x[k] = mesh_.point(s_)[k] +
                   share * reach * (std::cos(angle) * across_[k] + std::sin(angle) * up_[k]);
        points_.push_back(mesh_.add_point(x));
    }
}

// Fills the sectors from points at a share of the least distance of a vertex. Returns whether all
// tetrahedra are positive.
bool Withdrawal::fill(double share) {
    place_points(share);
    added_.clear();
    const std::size_t n = borders_.size();
    for (std::size_t i = 0; i < star_.size(); ++i) {
        const std::uint32_t z = points_[sector_of_[i]];
        if (z == no_index) continue;
        FlipMesh::Corners t;
        std::copy_n(mesh_.tetrahedra[star_[i]].v, 4, t.v);
        *std::find(t.v, t.v + 4, s_) = z;
        added_.push_back(t);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const Border& border = borders_[i];
        const std::uint32_t after = points_[i], before = points_[(i + n - 1) % n],
                            c = paths_[border.first];
        if (border.is_wall) {
            if (after != no_index) add(u_, w_, c, after);
            if (before != no_index) add(w_, u_, c, before);
            if (after == no_index) add(u_, w_, c, paths_[borders_[(i + 1) % n].first]);
            continue;
        }
        add(u_, w_, before, after);
        std::uint32_t from = u_;
        for (std::size_t k = border.first; k <= border.end; ++k) {
            const std::uint32_t to = k < border.end ? paths_[k] : w_;
            add(from, to, after, before);
            from = to;
        }
    }
    return mesh_.are_positive(added_);
}

}  // namespace mgdt
