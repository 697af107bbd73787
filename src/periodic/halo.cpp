// SPDX-License-Identifier: MIT
#include "periodic/halo.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/circumsphere.hpp"
#include "mesh/scale.hpp"
#include "mesh/star_traversal.hpp"
#include "predicates/circumcenter.hpp"
#include "predicates/predicates.hpp"
#include "query/locate.hpp"
#include "query/visit_queue.hpp"

namespace mgdt {
namespace {

std::uint32_t hash_of(const Image& image) {
    std::uint32_t of;
    std::memcpy(&of, image.of, sizeof of);
    std::uint64_t h = (std::uint64_t{image.point} << 32 | of) * 0x9E3779B97F4A7C15u;
    h ^= h >> 29;
    return static_cast<std::uint32_t>((h * 0xBF58476D1CE4E5B9u) >> 32);
}

bool are_equal(const Image& a, const Image& b) {
    return a.point == b.point && std::equal(a.of, a.of + 3, b.of);
}

// An image whose coordinates exceed the box by more than this share of a vector is not in a shell.
constexpr double widest_shell = 0.95;
// Coordinates of places whose errors are larger say nothing about which images are near.
constexpr double rough = 0x1p-4;
// Of all images of a point, the nearest to a place is within this many vectors of it, and so is a
// place in the cell of a lattice point (docs/theory.md, "Periodic boxes").
constexpr double nearest_range = 1.5;

}  // namespace

// One round: looks at tetrahedra, collects their balls and finds the images in the balls.
class Halo::Round {
  public:
    Round(Halo& halo, std::size_t most_requests, const StopRequest& stop)
        : halo_(halo),
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

    // All tetrahedra that have points of the box as corners.
    void look_at_all() {
        for (TetId t = 0; t < mesh_.tetrahedra.size(); ++t) {
            stop_.poll_in_step(t);
            if (!mesh_.tetrahedra[t].is_dead()) look_at(t);
        }
    }
    // Those that have a point with an index of at least `first` too.
    void look_at_stars(std::size_t first) {
        const Triangulation& triangulation = *halo_.triangulation_;
        const Locator where = {mesh_, triangulation.calls(), nullptr};
        VisitQueue star(halo_.allocator_);
        for (std::size_t p = first; p < halo_.point_count(); ++p) {
            stop_.poll_in_step(p);
            const VertexId v = triangulation.point_map()[p];
            if (mesh_.vertices[v].index != p) continue;
            star.clear();
            star.push(where.tetrahedron_of(v));
            traverse_star(mesh_, v, star,
                          [&](FacetCode facet) { star.push(tetrahedron_of(facet)); });
            for (std::size_t i = 0; i < star.size(); ++i) look_at(star[i]);
        }
    }
    // Whether tetrahedra were not looked at, since their points had to get their basic images
    // first.
    bool is_preliminary() const { return is_preliminary_; }

    // Adds the images of a point that bound the cell of a lattice point.
    void add_basic_images(std::uint32_t point) {
        halo_.basic_round_[point] = halo_.rounds_ + 1;
        const unsigned subsets = 1u << lattice().dimensions();
        for (unsigned subset = 1; subset < subsets; ++subset) {
            Multiples k = {};
            for (unsigned i = 0; i < 3; ++i) k[i] = static_cast<std::int32_t>(subset >> i & 1);
            halo_.add(image_of(point, k));
            halo_.add(image_of(point, -k));
        }
    }
    // Adds the images in the balls to the halo's list.
    void find_images() {
        find_in_balls();
        // Of a class that is not right, each tetrahedron needs its own images.
        balls_.clear();
        for (const Deferred& deferred : deferred_)
            if (!halo_.classes_[deferred.of].is_right) queue(deferred.tetrahedron, deferred.of);
        find_in_balls();
    }

  private:
    struct Ball {
        TetId tetrahedron;
        std::uint32_t of;     // its class
        std::uint32_t point;  // a corner in the box
        double offset[3];     // of the centre from the tetrahedron's first corner
        double center[3], radius;
    };
    const BoxLattice& lattice() const { return halo_.grid_->lattice(); }
    const double* corner(TetId t, unsigned i) const {
        return halo_.point(mesh_.vertices[mesh_.tetrahedra[t].v[i]].index);
    }

    // A tetrahedron whose class is being looked at.
    struct Deferred {
        TetId tetrahedron;
        std::uint32_t of;
    };
    // The corners in the box. Returns their number.
    unsigned find_own(const Tetrahedron& tetrahedron, std::uint32_t (&own)[4]) const {
        unsigned count = 0;
        for (const VertexId v : tetrahedron.v)
            if (v != infinite_vertex && halo_.is_own(mesh_.vertices[v].index))
                own[count++] = mesh_.vertices[v].index;
        return count;
    }
    void look_at(TetId t) {
        const Tetrahedron& tetrahedron = mesh_.tetrahedra[t];
        if (tetrahedron.is_ghost()) return look_at_ghost(tetrahedron);
        std::uint32_t own[4];
        if (is_in_shell(t) || find_own(tetrahedron, own) == 0) return;
        const std::uint32_t of = halo_.class_of(tetrahedron);
        Halo::Class& its_class = halo_.classes_[of];
        if (its_class.is_right) return;
        if (its_class.round == halo_.rounds_ + 1)
            deferred_.push_back({t, of});
        else if (queue(t, of))
            its_class.round = halo_.rounds_ + 1;
    }
    void look_at_ghost(const Tetrahedron& tetrahedron) {
        std::uint32_t own[4];
        const unsigned count = find_own(tetrahedron, own);
        if (!request_basic_images(own, count)) is_preliminary_ = true;
    }
    // Puts the ball of a tetrahedron on the list unless its points have to get their basic images
    // first.
    bool queue(TetId t, std::uint32_t of) {
        std::uint32_t own[4];
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
    bool request_basic_images(const std::uint32_t* points, unsigned count) {
        bool is_ready = true;
        for (unsigned i = 0; i < count; ++i) is_ready = request_basic_images(points[i]) && is_ready;
        return is_ready;
    }
    // Whether the basic images of a point were known before this round. A few points get theirs if
    // they were not; the others may not need them after that.
    bool request_basic_images(std::uint32_t point) {
        if (halo_.basic_round_[point] != 0) return halo_.basic_round_[point] <= halo_.rounds_;
        if (requests_ < most_requests_) {
            ++requests_;
            add_basic_images(point);
        }
        return false;
    }
    // Whether the ball of a tetrahedron is in the shell, where all images are known.
    bool is_in_shell(TetId t) const {
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
        // The error of the centre is at most that of w, a part of the radius that is added to it.
        const double radius = scaled(std::sqrt(square) * (1 + 0x1p-20) + 2 * s.e, -mesh_.scale);
        return is_in_shell(center, radius);
    }
    bool is_in_shell(const double* center, double radius) const {
        double s[3];
        lattice().coordinates(center, s);
        const double size = size_of(center);
        for (unsigned k = 0; k < lattice().dimensions(); ++k) {
            const double reach = radius * lattice().slope(k) + lattice().error_of(k, size);
            if (!(s[k] - reach > low_[k] && s[k] + reach < high_[k])) return false;
        }
        return true;
    }
    static double size_of(const double* place) {
        return std::fabs(place[0]) + std::fabs(place[1]) + std::fabs(place[2]);
    }
    void set(Ball& ball) const {
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
    // A bound on the error of coordinate k of a centre, or of its difference from that of a point.
    double error_at(const Ball& ball, unsigned k) const {
        return error_[k] + lattice().error_of(k, size_of(ball.center));
    }
    // Whether the centre may be in the cell that the basic images leave to the point, or above that
    // cell in a slab or beside a wire. False for a centre so far away that its coordinates are
    // rough.
    bool is_above_cell(const Ball& ball) const {
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

    // The range of coordinates along the vectors in which images of a ball are looked for: in the
    // ball, and near enough to its centre to be the nearest image of a point.
    void range_of(const Ball& ball, double (&low)[3], double (&high)[3]) const {
        // A distant centre is above the cell too, when the basic images are known.
        const bool is_near = is_above_cell(ball);
        double s[3];
        lattice().coordinates(is_near ? ball.center : halo_.point(ball.point), s);
        for (unsigned k = 0; k < lattice().dimensions(); ++k) {
            const double reach =
                is_near
                    ? std::min(ball.radius * lattice().slope(k), nearest_range) + error_at(ball, k)
                    : 2 * nearest_range + error_[k];
            low[k] = s[k] - reach;
            high[k] = s[k] + reach;
        }
    }
    void find_in_balls() {
        collect_candidates();
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            stop_.poll_in_step(i);
            halo_.classes_[balls_[i].of].is_right = find_in(balls_[i]);
        }
    }
    // The points of the box that have images in the range of a ball, but not in the shell.
    void collect_candidates() {
        const unsigned dimensions = lattice().dimensions();
        bool is_known = true;
        double* const low = halo_.candidates_low_;
        double* const high = halo_.candidates_high_;
        for (const Ball& ball : balls_) {
            double from[3], to[3];
            range_of(ball, from, to);
            for (unsigned k = 0; k < dimensions; ++k) {
                is_known = is_known && from[k] >= low[k] && to[k] <= high[k];
                low[k] = std::min(low[k], from[k]);
                high[k] = std::max(high[k], to[k]);
            }
        }
        if (is_known) return;
        // A little more, for the next rounds.
        for (unsigned k = 0; k < dimensions; ++k) {
            const double more = 0.1 * (high[k] - low[k]);
            low[k] -= more;
            high[k] += more;
        }
        halo_.candidates_.clear();
        for (std::uint32_t p = 0; p < halo_.own_; ++p) {
            double s[3];
            lattice().coordinates(halo_.point(p), s);
            bool is_candidate = false;
            for (unsigned k = 0; k < dimensions; ++k)
                is_candidate = is_candidate ||
                               (s[k] + 1 >= high_[k] && s[k] + 1 <= high[k] + error_[k]) ||
                               (s[k] - 1 <= low_[k] && s[k] - 1 >= low[k] - error_[k]) ||
                               high[k] + error_[k] >= 2 || low[k] - error_[k] <= -1;
            const auto repeats_another = [&] { return halo_.vertex_of(p) != p; };
            if (!is_candidate || repeats_another()) continue;
            halo_.candidates_.push(p, halo_.point(p));
        }
        halo_.candidates_.make(stop_);
    }

    // Calls visit(k, power) for the multiples by which images may be in the ball. `power` is that
    // of points of the box with respect to the ball moved back by these multiples.
    template <class Visit>
    void each_shift(const Ball& ball, const Visit& visit) const {
        double low[3] = {}, high[3] = {}, w[3];
        range_of(ball, low, high);
        for (unsigned c = 0; c < 3; ++c) w[c] = 2 * ball.offset[c];
        double base[3];  // a copy, since `visit` may add points
        std::copy_n(corner(ball.tetrahedron, 0), 3, base);
        // A point of the box has coordinates from 0 to 1.
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
    // Adds the image that is deepest in the ball, if there is one. Then those that are in the ball
    // with it can wait for a later round. If there is none, adds those on the sphere. Where doubles
    // leave a power uncertain, the exact predicate decides. Returns whether the triangulation has
    // all images in the closed ball, so that the tetrahedron is right.
    bool find_in(const Ball& ball) {
        double least = 0;
        Image deepest = {};
        unsure_.clear();
        each_shift(ball, [&](const Multiples& k, const RoughPower& power) {
            const double before = least;
            std::uint32_t point = 0;
            halo_.candidates_.search(power, least, point, [&](std::uint32_t maybe) {
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
    int side_of(const Ball& ball, std::uint32_t point, const Multiples& k) const {
        double x[3];
        halo_.grid_->image(halo_.point(point), k, x);
        const TetId t = ball.tetrahedron;
        return side_of_sphere(corner(t, 0), corner(t, 1), corner(t, 2), corner(t, 3), x);
    }

    Halo& halo_;
    const Mesh& mesh_;
    const StopRequest& stop_;
    Buffer<Ball> balls_;
    Buffer<Deferred> deferred_;
    Buffer<Image> unsure_;
    const std::size_t inserted_;  // points in the triangulation
    const std::size_t most_requests_;
    std::size_t requests_ = 0;
    double error_[3], low_[3], high_[3];
    bool is_preliminary_ = false;
};

void Halo::clear() noexcept {
    triangulation_.reset();
    points_.reset();
    images_.reset();
    known_.reset();
    basic_round_.reset();
    candidates_.reset();
    classes_.reset();
    class_numbers_.reset();
    own_ = 0;
    rounds_ = 0;
}

// The index of an image; NumberTable::none if it is not known.
std::uint32_t Halo::number_of(const Image& image) const {
    if (images_.empty()) return NumberTable::none;
    const std::uint32_t number =
        known_.find(hash_of(image), [&](std::uint32_t i) { return are_equal(images_[i], image); });
    return number == NumberTable::none ? number : static_cast<std::uint32_t>(own_ + number);
}

// The number of a tetrahedron's class.
std::uint32_t Halo::class_of(const Tetrahedron& tetrahedron) {
    const Mesh& mesh = triangulation_->mesh();
    Class its = {{}, 0, false};
    for (unsigned i = 0; i < 4; ++i) {
        const Image corner = image(mesh.vertices[tetrahedron.v[i]].index);
        unsigned k = i;
        for (; k > 0 && is_before(corner, its.corners[k - 1]); --k)
            its.corners[k] = its.corners[k - 1];
        its.corners[k] = corner;
    }
    std::uint32_t hash = 0;
    const Multiples first = its.corners[0].multiples();
    for (Image& corner : its.corners) {
        corner = image_of(corner.point, corner.multiples() - first);
        hash = (hash ^ hash_of(corner)) * 0x9E3779B1u;
    }
    class_numbers_.reserve(classes_.size() + 1);
    const std::uint32_t number = class_numbers_.number(hash ^ hash >> 15, [&](std::uint32_t i) {
        return std::equal(its.corners, its.corners + 4, classes_[i].corners, are_equal);
    });
    if (number == classes_.size()) classes_.push_back(its);
    return number;
}

// Adds an image to the list unless it is known. Returns whether it is new.
bool Halo::add(const Image& image) {
    if (point_count() >= max_points)
        fail(MGDT_ERR_TOO_LARGE, "%zu points and images of points are more than can be numbered",
             point_count() + 1);
    known_.reserve(images_.size() + 1);
    const std::uint32_t number = known_.number(
        hash_of(image), [&](std::uint32_t i) { return are_equal(images_[i], image); });
    if (number < images_.size()) return false;
    images_.push_back(image);
    points_.grow(points_.size() + 3);
    points_.resize_within_capacity(points_.size() + 3);
    double x[3];
    grid_->image(point(image.point), image.multiples(), x);
    std::copy_n(x, 3, points_.end() - 3);
    return true;
}

void Halo::list_used_images(Buffer<UsedImage>& used) const {
    constexpr std::uint32_t none = 0xFFFFFFFFu;
    Buffer<std::uint32_t> by(used.allocator());
    by.resize(images_.size(), none);
    const Mesh& mesh = triangulation_->mesh();
    for (TetId t = 0; t < mesh.tetrahedra.size(); ++t) {
        const Tetrahedron& tetrahedron = mesh.tetrahedra[t];
        if (tetrahedron.is_dead()) continue;
        std::uint32_t own = none;
        for (const VertexId v : tetrahedron.v)
            if (v != infinite_vertex && is_own(mesh.vertices[v].index))
                own = mesh.vertices[v].index;
        if (own == none) continue;
        for (const VertexId v : tetrahedron.v)
            if (v != infinite_vertex && !is_own(mesh.vertices[v].index))
                by[mesh.vertices[v].index - own_] = own;
    }
    for (std::size_t i = 0; i < images_.size(); ++i)
        if (by[i] != none) used.push_back({by[i], images_[i]});
}

std::size_t Halo::bytes_elsewhere() const {
    return triangulation_ && !passes_through_ ? triangulation_->allocator().bytes() : 0;
}

// All images in a shell around the box.
void Halo::add_first_halo() {
    const BoxLattice& lattice = grid_->lattice();
    const unsigned dimensions = lattice.dimensions();
    double low[3], high[3];
    std::fill_n(low, 3, infinity);
    std::fill_n(high, 3, -infinity);
    for (std::uint32_t p = 0; p < own_; ++p) {
        double s[3];
        lattice.coordinates(point(p), s);
        for (unsigned k = dimensions; k < 3; ++k) {
            low[k] = std::min(low[k], s[k]);
            high[k] = std::max(high[k], s[k]);
        }
    }
    // The volume that the points fill, in the coordinates of the basis, and its determinant.
    double volume = 1;
    for (unsigned k = 0; k < 3; ++k) {
        const double* const v = lattice.vector(k);
        const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        volume *= k < dimensions ? length : std::max(high[k] - low[k], 1e-3) * length;
    }
    const double width = first_width * std::cbrt(volume / static_cast<double>(own_));
    for (unsigned k = 0; k < dimensions; ++k)
        shell_[k] = std::min(width * lattice.slope(k), widest_shell);
    for (std::uint32_t p = 0; p < own_; ++p) {
        double s[3];
        lattice.coordinates(point(p), s);
        std::int32_t first[3] = {}, last[3] = {};
        bool is_inner = true;
        for (unsigned k = 0; k < dimensions; ++k) {
            if (s[k] + 1 <= 1 + shell_[k]) last[k] = 1;
            if (s[k] - 1 >= -shell_[k]) first[k] = -1;
            is_inner = is_inner && first[k] == 0 && last[k] == 0;
        }
        if (is_inner) continue;
        Multiples k;
        for (k[0] = first[0]; k[0] <= last[0]; ++k[0])
            for (k[1] = first[1]; k[1] <= last[1]; ++k[1])
                for (k[2] = first[2]; k[2] <= last[2]; ++k[2])
                    if (k != Multiples{}) add(image_of(p, k));
    }
}

void Halo::insert(std::size_t first, StageProgress& progress) {
    const double* const x = point(static_cast<std::uint32_t>(first));
    const double* const axis[3] = {x, x + 1, x + 2};
    progress.watch(*triangulation_, 0, 1,
                   [&] { triangulation_->insert(point_count() - first, axis, 3); });
}

void Halo::build(const ImageGrid& grid, Buffer<double>&& points, const Buffer<Image>& expected,
                 std::int32_t threads, StageProgress& progress, const StopRequest& stop) {
    clear();
    grid_ = &grid;
    points_ = std::move(points);
    own_ = points_.size() / 3;
    // A limit or a caller's functions hold for the triangulation too. Otherwise it has an allocator
    // of its own, whose blocks grow without a copy.
    passes_through_ = allocator_.limit() > 0 || allocator_.allocate_function();
    if (passes_through_)
        triangulation_.emplace(Allocator::allocate_from, Allocator::release_to, &allocator_);
    else
        triangulation_.emplace(nullptr, nullptr, nullptr);
    triangulation_->settings().threads = threads;
    if (own_ == 0) return;
    basic_round_.resize(own_, 0u);
    candidates_.clear();
    std::fill_n(candidates_low_, 3, infinity);
    std::fill_n(candidates_high_, 3, -infinity);
    add_first_halo();
    for (const Image& image : expected) add(image);
    // Memory for the images of later rounds too, which are few as a rule. Growth would copy all.
    triangulation_->reserve(std::min(point_count() + point_count() / 32 + 64, max_points));
    std::size_t first = 0;
    bool is_preliminary = true;
    double done = 0;
    do {
        progress.enter(done, done + 0.8 * (1 - done));
        done += 0.8 * (1 - done);
        if (point_count() > first) insert(first, progress);
        Round round(*this, std::size_t{8} << std::min(rounds_, 30u), stop);
        const std::size_t known = point_count();
        // Points that do not span space do so with these, if the infinite set does.
        if (triangulation_->dimension() < 3)
            round.add_basic_images(0);
        else if (is_preliminary)
            round.look_at_all();
        else
            round.look_at_stars(first);
        round.find_images();
        is_preliminary =
            triangulation_->dimension() < 3 ? point_count() > known : round.is_preliminary();
        first = known;
        ++rounds_;
    } while (point_count() > first || is_preliminary);
    // Images that were expected may be those of a point that equals another one.
    for (Image& image : images_) image.point = vertex_of(image.point);
    known_.reset();
    candidates_.reset();
    classes_.reset();
    class_numbers_.reset();
}

}  // namespace mgdt
