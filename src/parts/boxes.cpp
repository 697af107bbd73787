// SPDX-License-Identifier: MIT
#include "parts/boxes.hpp"

#include <algorithm>

#include "mesh/scale.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

struct Boxes::Place {
    double x[3];
};

struct Boxes::Split {
    double at;
    unsigned axis;
};

// A sample of the points determines the splits; the boxes enclose all points.
void Boxes::divide(const PartPoint* points, std::size_t n, BoundingBox* nodes) const {
    constexpr std::size_t sample_of_leaf = 16;
    Allocator& allocator = nodes_.allocator();
    const std::size_t count = std::min(n, sample_of_leaf * leaves_);
    Buffer<Place> sample(allocator, count);
    for (std::size_t k = 0; k < count; ++k) std::copy_n(points[n * k / count].x, 3, sample[k].x);
    Buffer<Split> splits(allocator, leaves_);
    split(sample.begin(), sample.end(), 1, leaves_, splits.data());
    std::fill_n(nodes, 2 * leaves_, BoundingBox::empty());
    for (const PartPoint* p = points; p < points + n; ++p) {
        std::size_t i = 1;
        while (i < leaves_) i = 2 * i + (p->x[splits[i].axis] < splits[i].at ? 0 : 1);
        nodes[i].include(p->x);
    }
    for (std::size_t i = leaves_; --i > 0;)
        for (const std::size_t half : {2 * i, 2 * i + 1}) {
            if (nodes[half].is_empty()) continue;
            nodes[i].include(nodes[half]);
        }
}

void Boxes::split(Place* begin, Place* end, std::size_t i, std::size_t leaves, Split* splits) {
    if (i >= leaves) return;
    BoundingBox box = BoundingBox::empty();
    for (const Place* p = begin; p < end; ++p) box.include(p->x);
    unsigned axis = 0;
    for (unsigned k = 1; k < 3; ++k)
        if (0.5 * box.high[k] - 0.5 * box.low[k] > 0.5 * box.high[axis] - 0.5 * box.low[axis])
            axis = k;
    Place* const middle = begin + (end - begin) / 2;
    splits[i] = {0, axis};
    if (middle < end) {
        std::nth_element(begin, middle, end,
                         [&](const Place& a, const Place& b) { return a.x[axis] < b.x[axis]; });
        splits[i].at = middle->x[axis];
    }
    split(begin, middle, 2 * i, leaves, splits);
    split(middle, end, 2 * i + 1, leaves, splits);
}

void Boxes::gather(Collective& all, const Buffer<BoundingBox>& nodes) {
    of_division_.resize(parts_);
    all.gather(nodes, nodes_);
    each_division(0, parts_, [&](PartId first, PartId middle, PartId last) {
        BoundingBox& box = of_division_[middle] = BoundingBox::empty();
        for (PartId p = first; p < last; ++p) {
            if (node(p, 1).is_empty()) continue;
            box.include(node(p, 1).low);
            box.include(node(p, 1).high);
        }
    });
}

// A point y, relative to the base, is in the closed ball if |y|^2 - w.y <= 0. The left side is a
// sum of one parabola per axis, so its minimum over a box is the sum of the minima of the
// parabolas. s.e bounds the error of each coordinate of w. The other terms are generous bounds for
// rounding and underflow, since a box that is visited needlessly costs little.
bool Boxes::meets_ball(const BoundingBox& box, const Sphere& s, const double* base, int scale) {
    double least = 0, sizes = 0, reach = 0;
    for (int k = 0; k < 3; ++k) {
        if (scale != 0 &&
            !(scales_exactly(box.low[k], scale) && scales_exactly(box.high[k], scale)))
            return true;
        const double low = scaled(box.low[k], scale) - base[k],
                     high = scaled(box.high[k], scale) - base[k];
        const double y = std::min(std::max(0.5 * s.w[k], low), high);
        least += y * (y - s.w[k]);
        const double farthest = std::max(std::fabs(low), std::fabs(high));
        sizes += farthest * (farthest + std::fabs(s.w[k]));
        reach += farthest;
    }
    return !(least > s.e * reach * (1 + 0x1p-40) + 0x1p-45 * sizes + 0x1p-1060);
}

Boxes::Facet::Facet(const double* a_, const double* b_, const double* c_, const double* inner)
    : a(a_), b(b_), c(c_), inside(orientation(a_, b_, c_, inner)) {
    double u[3], v[3];
    for (int k = 0; k < 3; ++k) {
        u[k] = b[k] - a[k];
        v[k] = c[k] - a[k];
    }
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const double first = u[i] * v[j], second = u[j] * v[i];
        normal[k] = inside * (second - first);
        products[k] = std::fabs(first) + std::fabs(second);
    }
}

// Whether a corner of the box is beyond the facet. The corner farthest along the normal is tested
// in doubles first: for most boxes it is on the inner side by more than the rounding error.
bool Boxes::is_beyond(const BoundingBox& box, const Facet& f) {
    double farthest = 0, sizes = 0, reach = 1;
    for (int k = 0; k < 3; ++k) {
        const double y = (f.normal[k] > 0 ? box.high : box.low)[k] - f.a[k];
        farthest += f.normal[k] * y;
        // The computed component may have the wrong sign, so the error bound uses the farther side
        // of the box.
        const double size =
            std::max(std::fabs(box.high[k] - f.a[k]), std::fabs(box.low[k] - f.a[k]));
        sizes += f.products[k] * size;
        reach += size;
    }
    if (farthest < -(0x1p-48 * sizes + 0x1p-1060 * reach)) return false;
    for (unsigned i = 0; i < 8; ++i) {
        double corner[3];
        for (unsigned k = 0; k < 3; ++k) corner[k] = (i >> k & 1 ? box.high : box.low)[k];
        if (orientation(f.a, f.b, f.c, corner) == -f.inside) return true;
    }
    return false;
}

}  // namespace mgdt
