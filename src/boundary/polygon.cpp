// SPDX-License-Identifier: MIT
#include "boundary/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "platform/no_index.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// Cuts ears off a polygon that is projected to the plane of two coordinates. The corners form a
// ring. A heap has the corners that may be ears, by the length of the edge that would cut them off.
// If another corner is in the way of an ear, the ear waits until that corner is removed or gets a
// new neighbour.
class EarCutter {
  public:
    EarCutter(const double* points, const std::uint32_t* corners, std::size_t size,
              Allocator& allocator)
        : points_(points),
          corners_(corners),
          left_(size),
          size_(static_cast<std::uint32_t>(size)),
          ring_(allocator, size),
          heap_(allocator),
          waiting_(allocator),
          doubtful_(allocator) {
        choose_axes();
        for (std::uint32_t i = 0; i < size_; ++i)
            ring_[i] = {point(i)[u_],
                        point(i)[v_],
                        (i > 0 ? i : size_) - 1,
                        i + 1 < size_ ? i + 1 : 0,
                        no_index,
                        true,
                        true};
    }

    // Appends the triangles. Returns false if there is no ear.
    bool run(Buffer<std::uint32_t>& triangles) {
        if (is_flat_) return false;
        for (std::uint32_t i = 0; i < size_; ++i) {
            push(i);
            doubtful_.push_back(i);
        }
        while (left_ > 3) {
            if (remove_spike()) continue;
            const std::uint32_t ear = best_ear();
            if (ear == no_index) return false;
            append(before(ear), ear, after(ear), triangles);
            remove(ear);
        }
        if (left_ < 3) return true;
        std::uint32_t first = 0;
        while (!ring_[first].is_left) ++first;
        const std::uint32_t second = after(first), third = after(second);
        if (turn(first, second, third) <= 0) return false;
        append(first, second, third, triangles);
        return true;
    }

  private:
    struct Corner {
        double x, y;  // in the plane
        std::uint32_t before, after;
        std::uint32_t first_waiting;  // the list in waiting_ of those that wait for it
        bool is_left, is_doubtful;    // doubtful: it may be a spike
    };
    // A corner that may be an ear, and its neighbours. If its neighbours have changed since, the
    // candidate is ignored.
    struct Candidate {
        std::uint32_t before, corner, after;
    };
    struct Waiting {
        Candidate candidate;
        std::uint32_t next;
    };

    const double* point(std::uint32_t i) const { return points_ + 3 * std::size_t{corners_[i]}; }
    std::uint32_t after(std::uint32_t i) const { return ring_[i].after; }
    std::uint32_t before(std::uint32_t i) const { return ring_[i].before; }
    void append(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                Buffer<std::uint32_t>& triangles) const {
        for (const std::uint32_t i : {a, b, c}) triangles.push_back(corners_[i]);
    }

    void remove(std::uint32_t i) {
        const std::uint32_t a = before(i), b = after(i);
        ring_[i].is_left = false;
        ring_[a].after = b;
        ring_[b].before = a;
        --left_;
        release(i);
        for (const std::uint32_t k : {a, b}) {
            release(k);
            push(k);
        }
        // Whether a corner is a spike depends on two neighbours on each side.
        for (const std::uint32_t k : {before(a), a, b, after(b)}) {
            if (ring_[k].is_doubtful) continue;
            ring_[k].is_doubtful = true;
            doubtful_.push_back(k);
            std::push_heap(doubtful_.begin(), doubtful_.end(), std::greater<>());
        }
    }
    bool is_valid(const Candidate& c) const {
        const Corner& corner = ring_[c.corner];
        return corner.is_left && corner.before == c.before && corner.after == c.after;
    }
    // The order of the heap: the first candidate has the shortest edge, and the lowest number among
    // equals.
    auto is_later() const {
        return [this](const Candidate& a, const Candidate& b) {
            const int order =
                compare_lengths(point(a.before), point(a.after), point(b.before), point(b.after));
            return order != 0 ? order > 0 : a.corner > b.corner;
        };
    }
    void push(std::uint32_t i) {
        heap_.push_back({before(i), i, after(i)});
        std::push_heap(heap_.begin(), heap_.end(), is_later());
    }
    // Makes all corners that wait for corner k candidates again.
    void release(std::uint32_t k) {
        std::uint32_t at = ring_[k].first_waiting;
        ring_[k].first_waiting = no_index;
        while (at != no_index) {
            if (is_valid(waiting_[at].candidate)) push(waiting_[at].candidate.corner);
            const std::uint32_t next = waiting_[at].next;
            waiting_[at].next = free_;
            free_ = at;
            at = next;
        }
    }
    void wait(const Candidate& candidate, std::uint32_t k) {
        const std::uint32_t at =
            free_ != no_index ? free_ : static_cast<std::uint32_t>(waiting_.size());
        if (free_ != no_index)
            free_ = waiting_[at].next;
        else
            waiting_.push_back({});
        waiting_[at] = {candidate, ring_[k].first_waiting};
        ring_[k].first_waiting = at;
    }

    // Removes the first spike: a corner whose two edges coincide and are outside of the polygon on
    // both sides. Cutting ears leaves such corners where a hole touches the border. Returns false
    // if there is none.
    bool remove_spike() {
        while (!doubtful_.empty()) {
            const std::uint32_t i = doubtful_[0];
            std::pop_heap(doubtful_.begin(), doubtful_.end(), std::greater<>());
            doubtful_.pop_back();
            ring_[i].is_doubtful = false;
            if (!ring_[i].is_left) continue;
            const std::uint32_t a = before(i), b = after(i), p = before(a), n = after(b);
            if (!is_same(a, b)) continue;
            const bool is_inside = is_same(p, n) ? false
                                   : turn(p, a, n) > 0
                                       ? turn(a, n, i) > 0 && turn(a, i, p) > 0
                                       : !(turn(a, p, i) >= 0 && turn(a, i, n) >= 0);
            if (is_inside) continue;
            remove(i);
            remove(b);
            return true;
        }
        return false;
    }

    // Chooses the axes of the projection so that the polygon is counter-clockwise: by the largest
    // component of the normal of Newell's formula. The sums use halved differences from the first
    // corner, which do not overflow.
    void choose_axes() {
        double normal[3] = {0, 0, 0}, largest = 0;
        const double* const o = point(0);
        for (std::uint32_t i = 0; i < size_; ++i)
            for (int k = 0; k < 3; ++k)
                largest = std::max(largest, std::fabs(point(i)[k] / 2 - o[k] / 2));
        if (largest == 0) largest = 1;
        for (std::uint32_t i = 0; i < size_; ++i) {
            double p[3], q[3];
            for (int k = 0; k < 3; ++k) {
                p[k] = (point(i)[k] / 2 - o[k] / 2) / largest;
                q[k] = (point(i + 1 < size_ ? i + 1 : 0)[k] / 2 - o[k] / 2) / largest;
            }
            for (int k = 0; k < 3; ++k) {
                const int u = (k + 1) % 3, v = (k + 2) % 3;
                normal[k] += p[u] * q[v] - p[v] * q[u];
            }
        }
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
        u_ = (axis + 1) % 3;
        v_ = (axis + 2) % 3;
        if (normal[axis] < 0) std::swap(u_, v_);
        is_flat_ = normal[axis] == 0;
    }

    // The sign of the area of a triangle in the plane, computed as its orientation with a point
    // above.
    int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const Corner &p = ring_[a], &q = ring_[b], &r = ring_[c];
        const double pa[3] = {p.x, p.y, 0}, pb[3] = {q.x, q.y, 0}, pc[3] = {r.x, r.y, 0},
                     above[3] = {p.x, p.y, 1};
        return orientation(pa, pb, pc, above);
    }
    // Whether two corners are at one place in the plane.
    bool is_same(std::uint32_t a, std::uint32_t b) const {
        return ring_[a].x == ring_[b].x && ring_[a].y == ring_[b].y;
    }

    // Whether corner k is at corner x of the triangle xyz and an edge of it goes into the triangle.
    bool enters(std::uint32_t k, std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
        if (!is_same(k, x)) return false;
        for (const std::uint32_t q : {before(k), after(k)})
            if (turn(x, y, q) > 0 && turn(x, q, z) > 0) return true;
        return false;
    }

    // A corner in the triangle at corner i, boundary included, or none.
    std::uint32_t in_the_way(std::uint32_t i) const {
        const std::uint32_t a = before(i), c = after(i);
        const Corner &p = ring_[a], &q = ring_[i], &r = ring_[c];
        const double low_x = std::min({p.x, q.x, r.x}), high_x = std::max({p.x, q.x, r.x}),
                     low_y = std::min({p.y, q.y, r.y}), high_y = std::max({p.y, q.y, r.y});
        for (std::uint32_t k = after(c); k != a; k = after(k)) {
            const Corner& other = ring_[k];
            if (other.x < low_x || other.x > high_x || other.y < low_y || other.y > high_y)
                continue;
            if (is_same(k, a) || is_same(k, i) || is_same(k, c)) {
                if (enters(k, a, i, c) || enters(k, i, c, a) || enters(k, c, a, i)) return k;
                continue;
            }
            if (turn(a, i, k) >= 0 && turn(i, c, k) >= 0 && turn(c, a, k) >= 0) return k;
        }
        return no_index;
    }

    // The ear with the shortest new edge, the first of equal ones, or none.
    std::uint32_t best_ear() {
        while (!heap_.empty()) {
            const Candidate best = heap_[0];
            std::pop_heap(heap_.begin(), heap_.end(), is_later());
            heap_.pop_back();
            if (!is_valid(best) || turn(best.before, best.corner, best.after) <= 0) continue;
            const std::uint32_t k = in_the_way(best.corner);
            if (k == no_index) return best.corner;
            wait(best, k);
        }
        return no_index;
    }

    const double* points_;
    const std::uint32_t* corners_;
    std::size_t left_;
    const std::uint32_t size_;
    Buffer<Corner> ring_;
    Buffer<Candidate> heap_;
    Buffer<Waiting> waiting_;
    std::uint32_t free_ = no_index;   // the list of unused elements of waiting_
    Buffer<std::uint32_t> doubtful_;  // a heap
    int u_ = 0, v_ = 1;
    bool is_flat_ = false;  // the corners are on a line, or the polygon crosses itself
};

}  // namespace

bool triangulate_polygon(const double* points, const std::uint32_t* corners, std::size_t size,
                         Buffer<std::uint32_t>& triangles) {
    if (size < 3) return false;
    const std::size_t before = triangles.size();
    if (size == 3) {
        for (int k = 0; k < 3; ++k) triangles.push_back(corners[k]);
        return true;
    }
    if (EarCutter(points, corners, size, triangles.allocator()).run(triangles)) return true;
    triangles.resize(before);
    return false;
}

}  // namespace mgdt
