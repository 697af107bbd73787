// SPDX-License-Identifier: MIT
#include "improvement/place_search.hpp"

#include <algorithm>

#include "improvement/quality_gradient.hpp"

namespace mgdt {
namespace {

double square_of(const double (&v)[3]) {
    return (v[0] * v[0] + v[1] * v[1]) + v[2] * v[2];
}
double product_of(const double (&v)[3], const double (&w)[3]) {
    return (v[0] * w[0] + v[1] * w[1]) + v[2] * w[2];
}

}  // namespace

void PlaceSearch::evaluate(const double (&place)[3]) noexcept {
    for (Face& face : faces_) face.quality = quality_of(place, face.p[0], face.p[1], face.p[2]);
}

double PlaceSearch::worst() const noexcept {
    double worst = above_all;
    for (const Face& face : faces_) worst = std::min(worst, face.quality);
    return worst;
}

// Collects the faces with the lowest qualities, in ascending order.
void PlaceSearch::find_worst() {
    worst_count_ = 0;
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
        const double quality = faces_[f].quality;
        if (worst_count_ == most_worst && !(quality < worst_[most_worst - 1].quality)) continue;
        unsigned i = worst_count_ < most_worst ? worst_count_++ : most_worst - 1;
        for (; i > 0 && quality < worst_[i - 1].quality; --i) worst_[i] = worst_[i - 1];
        worst_[i].quality = quality;
        worst_[i].face = f;
    }
}

// The shortest vector of the convex hull of the gradients of the first `active` faces: in its
// direction, the least quality grows fastest. Iterates with exact steps to the gradient that is
// farthest against it.
void PlaceSearch::find_direction(unsigned active, double (&d)[3]) const {
    constexpr int most_steps = 12;
    std::copy_n(worst_[0].by, 3, d);
    for (int step = 0; step < most_steps; ++step) {
        const double square = square_of(d);
        double least = square;
        unsigned at = 0;
        for (unsigned k = 0; k < active; ++k)
            if (const double value = product_of(d, worst_[k].by); value < least) {
                least = value;
                at = k;
            }
        if (!(least < 0.999 * square)) return;
        const double* const g = worst_[at].by;
        const double difference[3] = {g[0] - d[0], g[1] - d[1], g[2] - d[2]};
        const double length = square_of(difference);
        if (!(length > 0)) return;
        const double t = std::min(1.0, -product_of(d, difference) / length);
        for (int k = 0; k < 3; ++k) d[k] += t * difference[k];
    }
}

// Each step goes along the direction in which the worst tetrahedra become better, as far as the
// next one lets it (Freitag and Ollivier-Gooch, International Journal for Numerical Methods in
// Engineering 40, 1997).
bool PlaceSearch::improve(const VertexClass& freedom, const Moves& moves, double (&place)[3]) {
    constexpr int most_tries = 4;
    constexpr double about_the_worst = 1.1, least_gain = 1.001, least_share = 1e-10;
    double worst = this->worst(), missing = 0;
    bool has_moved = false;
    for (const Face& face : faces_) missing += missing_to(moves.goal, face.quality);
    next_.resize(faces_.size());
    for (int move = 0; move < moves.most && worst > 0 && worst < moves.enough; ++move) {
        find_worst();
        unsigned active = 0;
        for (unsigned k = 0; k < worst_count_; ++k) {
            Worst& one = worst_[k];
            const double* const(&p)[3] = faces_[one.face].p;
            std::copy_n(quality_gradient(place, p[0], p[1], p[2]).by, 3, one.by);
            freedom.project(one.by);
            if (one.quality <= about_the_worst * worst) active = k + 1;
        }
        double d[3];
        find_direction(active, d);
        // What is left where gradients cancel has lost its line or plane.
        freedom.project(d);
        const double square = square_of(d);
        if (!(square > least_share * square_of(worst_[0].by))) break;
        // Along d the worst grow by at least the square of its length. The step ends where the
        // next one becomes the worst, or doubles the worst.
        double step = worst / square;
        for (unsigned k = 0; k < worst_count_; ++k) {
            const double slope = product_of(d, worst_[k].by);
            if (slope < square && worst_[k].quality > worst)
                step = std::min(step, (worst_[k].quality - worst) / (square - slope));
        }
        bool is_better = false;
        double to[3], there = 0, missing_there = 0;
        for (int tries = 0; tries < most_tries && !is_better; ++tries, step /= 2) {
            for (int k = 0; k < 3; ++k) to[k] = place[k] + step * d[k];
            is_better = true;
            there = above_all;
            missing_there = 0;
            for (std::size_t f = 0; f < faces_.size() && is_better; ++f) {
                const double* const(&p)[3] = faces_[f].p;
                next_[f] = quality_of(to, p[0], p[1], p[2]);
                there = std::min(there, next_[f]);
                missing_there += missing_to(moves.goal, next_[f]);
                is_better =
                    next_[f] > least_gain * worst && (moves.push || missing_there <= missing);
            }
        }
        if (!is_better) break;
        std::copy_n(to, 3, place);
        for (std::size_t f = 0; f < faces_.size(); ++f) faces_[f].quality = next_[f];
        worst = there;
        has_moved = true;
        missing = missing_there;
    }
    return has_moved;
}

double PlaceSearch::mean_at(const double (&place)[3]) const {
    double sum = 0;
    for (const Face& face : faces_) sum += volume_length_of(place, face.p[0], face.p[1], face.p[2]);
    return sum;
}

bool PlaceSearch::improve_mean(const VertexClass& freedom, double goal, double (&place)[3]) {
    constexpr int most_tries = 2;
    const double least = std::min(goal, worst()), mean = mean_at(place);
    double way[3] = {0, 0, 0};
    const double corners = 3 * static_cast<double>(faces_.size());
    for (const Face& face : faces_)
        for (const double* p : face.p)
            for (int k = 0; k < 3; ++k) way[k] += (p[k] - place[k]) / corners;
    freedom.project(way);
    double step = 1;
    for (int tries = 0; tries < most_tries; ++tries, step /= 2) {
        double to[3];
        for (int k = 0; k < 3; ++k) to[k] = place[k] + step * way[k];
        if (std::all_of(faces_.begin(), faces_.end(),
                        [&](const Face& face) {
                            return quality_of(to, face.p[0], face.p[1], face.p[2]) > least;
                        }) &&
            mean_at(to) > mean) {
            std::copy_n(to, 3, place);
            return true;
        }
    }
    return false;
}

}  // namespace mgdt
