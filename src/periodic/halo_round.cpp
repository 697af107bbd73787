// SPDX-License-Identifier: MIT
#include "periodic/halo_round.hpp"

#include <algorithm>

#include "kernel/circumsphere.hpp"
#include "mesh/scale.hpp"
#include "periodic/hull_walk.hpp"
#include "periodic/rough_power.hpp"
#include "predicates/circumcenter.hpp"
#include "predicates/predicates.hpp"
#include "query/locate.hpp"
#include "query/star.hpp"

namespace mgdt {
namespace {

// An upper bound of the errors of coordinates. Coordinates with larger errors do not tell which
// images are near.
constexpr double rough = 0x1p-4;
// The nearest image of a point to any place is within this many vectors of the place. So is the
// lattice point whose cell contains the place (docs/theory.md, "Periodic boxes").
constexpr double nearest_range = 1.5;

}  // namespace

Halo::Round::Round(Halo& halo, HaloSearch& search, std::size_t most_requests,
                   const StopRequest& stop)
    : halo_(halo),
      search_(search),
      mesh_(halo.triangulation_->mesh()),
      stop_(stop),
      balls_(halo.allocator_),
      deferred_(halo.allocator_),
      unsure_(halo.allocator_),
      inserted_(halo.point_count()),
      most_requests_(most_requests) {
    for (unsigned k = 0; k < 3; ++k) {
        error_[k] = lattice().error_of(k, halo_.grid_->size());
        low_[k] = -halo_.shell_[k] + error_[k];
        high_[k] = 1 + halo_.shell_[k] - error_[k];
    }
}

void Halo::Round::look_at_all() {
    walk_from_hull(
        mesh_, halo_.allocator_, stop_, [this](TetId t) { return leaves_shell(t); },
        [this](TetId t) { look_at(t); });
}

void Halo::Round::look_at_stars(std::size_t first) {
    const Triangulation& triangulation = *halo_.triangulation_;
    const Locator where = {mesh_, triangulation.calls(), nullptr};
    VisitQueue star(halo_.allocator_);
    for (std::size_t p = first; p < halo_.point_count(); ++p) {
        stop_.poll_in_step(p);
        const VertexId v = triangulation.point_map()[p];
        if (mesh_.vertices[v].index != p) continue;
        gather_star(where, v, star);
        for (std::size_t i = 0; i < star.size(); ++i)
            if (mesh_.tetrahedra[star[i]].is_ghost() || leaves_shell(star[i])) look_at(star[i]);
    }
}

void Halo::Round::add_basic_images(std::uint32_t point) {
    search_.basic_round[point] = halo_.rounds_ + 1;
    const unsigned subsets = 1u << lattice().dimensions();
    for (unsigned subset = 1; subset < subsets; ++subset) {
        Multiples k = {};
        for (unsigned i = 0; i < 3; ++i) k[i] = static_cast<std::int32_t>(subset >> i & 1);
        halo_.add(image_of(point, k));
        halo_.add(image_of(point, -k));
    }
}

void Halo::Round::find_images() {
    find_in_balls();
    // If the class is not final, each tetrahedron of it needs its own images.
    balls_.clear();
    for (const Deferred& deferred : deferred_)
        if (!search_.classes[deferred.of].is_right) queue(deferred.tetrahedron, deferred.of);
    find_in_balls();
}

std::uint32_t Halo::Round::class_of(const Tetrahedron& tetrahedron) {
    const auto corner = [&](unsigned i) {
        return halo_.image(mesh_.vertices[tetrahedron.v[i]].index);
    };
    return search_.classes.number_of({corner(0), corner(1), corner(2), corner(3)});
}

unsigned Halo::Round::find_own(const Tetrahedron& tetrahedron, std::uint32_t (&own)[4]) const {
    unsigned count = 0;
    for (const VertexId v : tetrahedron.v)
        if (v != infinite_vertex && halo_.is_own(mesh_.vertices[v].index))
            own[count++] = mesh_.vertices[v].index;
    return count;
}

void Halo::Round::look_at(TetId t) {
    const Tetrahedron& tetrahedron = mesh_.tetrahedra[t];
    if (tetrahedron.is_ghost()) return look_at_ghost(tetrahedron);
    std::uint32_t own[4] = {};
    if (find_own(tetrahedron, own) == 0) return;
    const std::uint32_t of = class_of(tetrahedron);
    TetrahedronClasses::Class& its_class = search_.classes[of];
    if (its_class.is_right) return;
    if (its_class.round == halo_.rounds_ + 1)
        deferred_.push_back({t, of});
    else if (queue(t, of))
        its_class.round = halo_.rounds_ + 1;
}

void Halo::Round::look_at_ghost(const Tetrahedron& tetrahedron) {
    std::uint32_t own[4] = {};
    const unsigned count = find_own(tetrahedron, own);
    if (!request_basic_images(own, count)) is_preliminary_ = true;
}

bool Halo::Round::queue(TetId t, std::uint32_t of) {
    std::uint32_t own[4] = {};
    const unsigned count = find_own(mesh_.tetrahedra[t], own);
    Ball ball = {t, of, own[0], {}, {}, infinity};
    set(ball);
    if (!is_above_cell(ball) && !request_basic_images(own, count)) {
        is_preliminary_ = true;
        return false;
    }
    balls_.push_back(ball);
    return true;
}

bool Halo::Round::request_basic_images(const std::uint32_t* points, unsigned count) {
    bool is_ready = true;
    for (unsigned i = 0; i < count; ++i) is_ready = request_basic_images(points[i]) && is_ready;
    return is_ready;
}

bool Halo::Round::request_basic_images(std::uint32_t point) {
    if (search_.basic_round[point] != 0) return search_.basic_round[point] <= halo_.rounds_;
    if (requests_ < most_requests_) {
        ++requests_;
        add_basic_images(point);
    }
    return false;
}

bool Halo::Round::leaves_shell(TetId t) const {
    const Tetrahedron& tetrahedron = mesh_.tetrahedra[t];
    const Sphere s = mesh_.tetrahedra.has_spheres()
                         ? mesh_.tetrahedra.sphere(t).in_doubles()
                         : circumsphere(tetrahedron, mesh_.vertices.data());
    const double* const base = mesh_.point(tetrahedron.v[0]);
    double center[3], square = 0;
    for (unsigned c = 0; c < 3; ++c) {
        const double half = 0.5 * s.w[c], size = std::fabs(half) + s.e;
        center[c] = scaled(base[c] + half, -mesh_.scale);
        square += size * size;
    }
    // The error of the centre is at most the error of w, so a part of the radius is added.
    const double radius = scaled(std::sqrt(square) * (1 + 0x1p-20) + 2 * s.e, -mesh_.scale);
    return leaves_shell(center, radius);
}

bool Halo::Round::leaves_shell(const double* center, double radius) const {
    double s[3];
    lattice().coordinates(center, s);
    const double size = size_of(center);
    for (unsigned k = 0; k < lattice().dimensions(); ++k) {
        const double reach = radius * lattice().slope(k) + lattice().error_of(k, size);
        if (!(s[k] - reach > low_[k] && s[k] + reach < high_[k])) return true;
    }
    return false;
}

void Halo::Round::set(Ball& ball) const {
    const double* const corners[4] = {corner(ball.tetrahedron, 0), corner(ball.tetrahedron, 1),
                                      corner(ball.tetrahedron, 2), corner(ball.tetrahedron, 3)};
    center_offset(corners, ball.offset);
    double square = 0;
    for (unsigned c = 0; c < 3; ++c) {
        ball.center[c] = corners[0][c] + ball.offset[c];
        square += ball.offset[c] * ball.offset[c];
    }
    ball.radius = std::sqrt(square) * (1 + 0x1p-40);
}

bool Halo::Round::is_above_cell(const Ball& ball) const {
    double center[3], point[3];
    lattice().coordinates(ball.center, center);
    lattice().coordinates(halo_.point(ball.point), point);
    for (unsigned k = 0; k < lattice().dimensions(); ++k) {
        const double error = error_at(ball, k);
        if (!(error <= rough && std::fabs(center[k] - point[k]) <= nearest_range + error))
            return false;
    }
    return true;
}

void Halo::Round::range_of(const Ball& ball, double (&low)[3], double (&high)[3]) const {
    // A distant centre also counts as above the cell, if the basic images are known.
    const bool is_near = is_above_cell(ball);
    double s[3];
    lattice().coordinates(is_near ? ball.center : halo_.point(ball.point), s);
    for (unsigned k = 0; k < lattice().dimensions(); ++k) {
        const double reach =
            is_near ? std::min(ball.radius * lattice().slope(k), nearest_range) + error_at(ball, k)
                    : 2 * nearest_range + error_[k];
        low[k] = s[k] - reach;
        high[k] = s[k] + reach;
    }
}

void Halo::Round::find_in_balls() {
    collect_candidates();
    for (std::size_t i = 0; i < balls_.size(); ++i) {
        stop_.poll_in_step(i);
        search_.classes[balls_[i].of].is_right = find_in(balls_[i]);
    }
}

template <class Visit>
void Halo::Round::each_range(const Ball& ball, const Visit& visit) const {
    double low[3] = {}, high[3] = {};
    range_of(ball, low, high);
    for (unsigned k = 0; k < lattice().dimensions(); ++k) {
        low[k] -= error_[k];
        high[k] += error_[k];
    }
    for (unsigned k = 0; k < lattice().dimensions(); ++k) {
        const double from = low[k], to = high[k];
        if (to > high_[k]) {
            low[k] = std::max(from, high_[k]);
            visit(low, high);
            low[k] = from;
        }
        if (from < low_[k]) {
            high[k] = std::min(to, low_[k]);
            visit(low, high);
            high[k] = to;
        }
    }
}

void Halo::Round::collect_candidates() {
    ImageCells& cells = search_.candidate_cells;
    bool is_known = true;
    for (std::size_t i = 0; i < balls_.size() && is_known; ++i)
        each_range(balls_[i], [&](const double(&low)[3], const double(&high)[3]) {
            is_known = is_known && cells.has_all(low, high);
        });
    if (is_known) return;
    for (const Ball& ball : balls_)
        each_range(ball,
                   [&](const double(&low)[3], const double(&high)[3]) { cells.add(low, high); });
    cells.mark();
    search_.candidates.clear();
    const bool are_different = halo_.triangulation_->vertex_count() == inserted_;
    for (std::uint32_t p = 0; p < halo_.own_; ++p) {
        double s[3];
        lattice().coordinates(halo_.point(p), s);
        const auto is_vertex = [&] { return are_different || halo_.vertex_of(p) == p; };
        if (cells.has(s) && is_vertex()) search_.candidates.push(p, halo_.point(p));
    }
    search_.candidates.make(stop_);
}

template <class Visit>
void Halo::Round::each_shift(const Ball& ball, const Visit& visit) const {
    double low[3] = {}, high[3] = {}, w[3];
    range_of(ball, low, high);
    for (unsigned c = 0; c < 3; ++c) w[c] = 2 * ball.offset[c];
    double base[3];  // a copy, since `visit` may add points
    std::copy_n(corner(ball.tetrahedron, 0), 3, base);
    // The points of the box have coordinates from 0 to 1.
    std::int32_t first[3] = {}, last[3] = {};
    for (unsigned k = 0; k < lattice().dimensions(); ++k) {
        first[k] = static_cast<std::int32_t>(std::ceil(low[k] - 1 - error_[k]));
        last[k] = static_cast<std::int32_t>(std::floor(high[k] + error_[k]));
    }
    Multiples k;
    for (k[0] = first[0]; k[0] <= last[0]; ++k[0])
        for (k[1] = first[1]; k[1] <= last[1]; ++k[1])
            for (k[2] = first[2]; k[2] <= last[2]; ++k[2]) {
                if (k == Multiples{}) continue;
                double moved[3];
                halo_.grid_->image(base, -k, moved);
                visit(k, RoughPower(moved, w));
            }
}

bool Halo::Round::find_in(const Ball& ball) {
    double least = 0;
    Image deepest = {};
    unsure_.clear();
    each_shift(ball, [&](const Multiples& k, const RoughPower& power) {
        const double before = least;
        std::uint32_t point = 0;
        search_.candidates.search(power, least, point, [&](std::uint32_t maybe) {
            unsure_.push_back(image_of(maybe, k));
        });
        if (least < before) deepest = image_of(point, k);
    });
    if (least < 0) {
        halo_.add(deepest);
        return false;
    }
    bool is_right = true;
    for (const Image& image : unsure_) {
        const std::uint32_t number = halo_.number_of(image);
        if (number < inserted_ || side_of(ball, image.point, image.multiples()) < 0) continue;
        is_right = false;
        halo_.add(image);
    }
    return is_right;
}

int Halo::Round::side_of(const Ball& ball, std::uint32_t point, const Multiples& k) const {
    double x[3];
    halo_.grid_->image(halo_.point(point), k, x);
    const TetId t = ball.tetrahedron;
    return side_of_sphere(corner(t, 0), corner(t, 1), corner(t, 2), corner(t, 3), x);
}

}  // namespace mgdt
