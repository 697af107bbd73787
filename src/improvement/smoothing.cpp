// SPDX-License-Identifier: MIT
#include "improvement/smoothing.hpp"

#include <algorithm>
#include <cmath>

#include "improvement/quality.hpp"
#include "improvement/quality_gradient.hpp"

namespace mgdt {
namespace {

constexpr unsigned most_colors = 64;

double dot(const double (&p)[3], const double (&q)[3]) {
    return (p[0] * q[0] + p[1] * q[1]) + p[2] * q[2];
}

// The quality of tetrahedron t with vertex v at a place.
double quality_at(const FlexibleMesh& mesh, const FlexibleMesh::Tetrahedron& t, std::uint32_t v,
                  const double (&place)[3]) {
    const double* p[4];
    for (int i = 0; i < 4; ++i) p[i] = t.v[i] == v ? place : mesh.point(t.v[i]);
    return quality_of(p[0], p[1], p[2], p[3]);
}

QualityGradient gradient_at(const FlexibleMesh& mesh, const FlexibleMesh::Tetrahedron& t,
                            std::uint32_t v, const double (&place)[3]) {
    // (q, f0, f1, f2) is positive for q beyond the face, so (v, f0, f2, f1) is positive.
    const unsigned char* const f = outer_face[t.position(v)];
    return quality_gradient(place, mesh.point(t.v[f[0]]), mesh.point(t.v[f[2]]),
                            mesh.point(t.v[f[1]]));
}

// The lowest qualities of a star, with their gradients.
struct Lowest {
    static constexpr unsigned most = 16;
    struct Entry {
        double quality;
        double by[3];
        std::uint32_t tetrahedron;
    };
    Entry entries[most] = {};
    unsigned count = 0;

    void add(double quality, std::uint32_t t) {
        if (count == most && !(quality < entries[most - 1].quality)) return;
        unsigned i = count < most ? count++ : most - 1;
        for (; i > 0 && quality < entries[i - 1].quality; --i) entries[i] = entries[i - 1];
        entries[i].quality = quality;
        entries[i].tetrahedron = t;
    }
};

// The shortest vector of the convex hull of the gradients of the worst tetrahedra: in its
// direction, the least quality grows fastest. Iterates with exact steps to the gradient that is
// farthest against it.
void find_direction(const Lowest& lowest, unsigned active, double (&d)[3]) {
    constexpr int most_steps = 12;
    std::copy_n(lowest.entries[0].by, 3, d);
    for (int step = 0; step < most_steps; ++step) {
        const double square = dot(d, d);
        double least = square;
        unsigned at = 0;
        for (unsigned k = 0; k < active; ++k)
            if (const double value = dot(d, lowest.entries[k].by); value < least) {
                least = value;
                at = k;
            }
        if (!(least < 0.999 * square)) return;
        const double* const g = lowest.entries[at].by;
        const double difference[3] = {g[0] - d[0], g[1] - d[1], g[2] - d[2]};
        const double length = dot(difference, difference);
        if (!(length > 0)) return;
        const double t = std::min(1.0, -dot(d, difference) / length);
        for (int k = 0; k < 3; ++k) d[k] += t * difference[k];
    }
}

}  // namespace

void Smoothing::choose_candidates(double goal) {
    candidates_.clear();
    color_.clear();
    color_.resize(mesh_.x.size() / 3, 0);
    for (std::uint32_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
        if (mesh_.tetrahedra[t].is_dead() || !(mesh_.qualities[t] < goal)) continue;
        for (const std::uint32_t v : mesh_.tetrahedra[t].v) {
            if (color_[v] != 0 || classes_[v].freedom == Freedom::fixed) continue;
            color_[v] = 1;
            candidates_.push_back(v);
        }
    }
    for (const std::uint32_t v : candidates_) color_[v] = 0;
}

void Smoothing::collect_stars(StageProgress& progress) {
    for (Mover& mover : movers_) mover.tetrahedra.clear();
    stars_.clear();
    stars_.resize(candidates_.size());
    constexpr std::size_t vertices_per_thread = 256;
    team_.split(candidates_.size(), vertices_per_thread,
                [&](std::size_t begin, std::size_t end, unsigned member) {
                    Mover& mover = movers_[member];
                    for (std::size_t k = begin; k < end; ++k) {
                        progress.step(k, begin, end, member);
                        stars_[k] = {mover.tetrahedra.size(), member, 0};
                        if (!mover.star.collect(mesh_, candidates_[k])) continue;
                        for (const std::uint32_t t : mover.star.tetrahedra)
                            mover.tetrahedra.push_back(t);
                        stars_[k].size = static_cast<std::uint32_t>(mover.star.tetrahedra.size());
                    }
                });
}

// Gives vertices of one tetrahedron different colours, and sorts the candidates by colour. A vertex
// that gets none stays where it is.
void Smoothing::color() {
    begin_of_color_.clear();
    begin_of_color_.resize(most_colors + 2, 0);
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
        std::uint64_t used = 0;
        const std::uint32_t* const star = tetrahedra_of(stars_[k]);
        for (std::uint32_t i = 0; i < stars_[k].size; ++i)
            for (const std::uint32_t v : mesh_.tetrahedra[star[i]].v)
                if (color_[v] != 0) used |= std::uint64_t{1} << (color_[v] - 1);
        unsigned color = 0;
        while (color < most_colors && (used >> color & 1) != 0) ++color;
        if (color == most_colors || stars_[k].size == 0) continue;
        color_[candidates_[k]] = static_cast<std::uint8_t>(color + 1);
        ++begin_of_color_[color + 1];
    }
    for (unsigned c = 1; c < begin_of_color_.size(); ++c)
        begin_of_color_[c] += begin_of_color_[c - 1];
    order_.resize(begin_of_color_[most_colors]);
    std::uint32_t next[most_colors];
    std::copy_n(begin_of_color_.begin(), most_colors, next);
    for (std::uint32_t k = 0; k < candidates_.size(); ++k)
        if (const unsigned color = color_[candidates_[k]]; color != 0)
            order_[next[color - 1]++] = k;
}

std::size_t Smoothing::pass(double goal, StageProgress& progress) {
    choose_candidates(goal);
    collect_stars(progress);
    color();
    for (Mover& mover : movers_) mover.moved = 0;
    constexpr std::size_t vertices_per_thread = 32;
    for (unsigned c = 0; c < most_colors && begin_of_color_[c] < order_.size(); ++c) {
        const std::size_t first = begin_of_color_[c];
        team_.split(begin_of_color_[c + 1] - first, vertices_per_thread,
                    [&](std::size_t begin, std::size_t end, unsigned member) {
                        for (std::size_t k = begin; k < end; ++k) {
                            progress.step(k, begin, end, member);
                            if (smooth(order_[first + k], movers_[member])) ++movers_[member].moved;
                        }
                    });
    }
    std::size_t moved = 0;
    for (const Mover& mover : movers_) moved += mover.moved;
    return moved;
}

// Moves a vertex along the direction in which the worst tetrahedra of its star become better, as
// far as the next one lets it (Freitag and Ollivier-Gooch, International Journal for Numerical
// Methods in Engineering 40, 1997).
bool Smoothing::smooth(std::uint32_t candidate, Mover& mover) {
    constexpr int most_moves = 4, most_tries = 4;
    constexpr double about_the_worst = 1.1, least_gain = 1.001, least_share = 1e-10;
    const std::uint32_t v = candidates_[candidate];
    const std::uint32_t* const star = tetrahedra_of(stars_[candidate]);
    const std::uint32_t size = stars_[candidate].size;
    double place[3];
    std::copy_n(mesh_.point(v), 3, place);
    bool has_moved = false;
    mover.qualities.resize(size);
    for (int move = 0; move < most_moves; ++move) {
        Lowest lowest;
        for (std::uint32_t i = 0; i < size; ++i) lowest.add(mesh_.qualities[star[i]], star[i]);
        const double worst = lowest.entries[0].quality;
        if (!(worst > 0)) break;
        unsigned active = 0;
        for (unsigned k = 0; k < lowest.count; ++k) {
            Lowest::Entry& entry = lowest.entries[k];
            std::copy_n(gradient_at(mesh_, mesh_.tetrahedra[entry.tetrahedron], v, place).by, 3,
                        entry.by);
            classes_[v].project(entry.by);
            if (entry.quality <= about_the_worst * worst) active = k + 1;
        }
        double d[3];
        find_direction(lowest, active, d);
        // What is left where gradients cancel has lost its line or plane.
        classes_[v].project(d);
        const double square = dot(d, d);
        if (!(square > least_share * dot(lowest.entries[0].by, lowest.entries[0].by))) break;
        // Along d the worst grow by at least the square of its length. The step ends where the
        // next one becomes the worst, or doubles the worst.
        double step = worst / square;
        for (unsigned k = 0; k < lowest.count; ++k) {
            const double slope = dot(d, lowest.entries[k].by);
            if (slope < square && lowest.entries[k].quality > worst)
                step = std::min(step, (lowest.entries[k].quality - worst) / (square - slope));
        }
        bool is_better = false;
        double to[3];
        for (int tries = 0; tries < most_tries && !is_better; ++tries, step /= 2) {
            for (int k = 0; k < 3; ++k) to[k] = place[k] + step * d[k];
            is_better = true;
            for (std::uint32_t i = 0; i < size && is_better; ++i) {
                mover.qualities[i] = quality_at(mesh_, mesh_.tetrahedra[star[i]], v, to);
                is_better = mover.qualities[i] > least_gain * worst;
            }
        }
        if (!is_better) break;
        std::copy_n(to, 3, place);
        std::copy_n(to, 3, mesh_.x.begin() + 3 * std::size_t{v});
        for (std::uint32_t i = 0; i < size; ++i) mesh_.qualities[star[i]] = mover.qualities[i];
        has_moved = true;
    }
    return has_moved;
}

}  // namespace mgdt
