// SPDX-License-Identifier: MIT
#include "parts/boxes.hpp"

#include <algorithm>

#include "mesh/scale.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

Box empty_box() {
    Box box;
    std::fill_n(box.low, 3, infinity);
    std::fill_n(box.high, 3, -infinity);
    return box;
}

void add(Box& box, const double* x) {
    for (int k = 0; k < 3; ++k) {
        box.low[k] = std::min(box.low[k], x[k]);
        box.high[k] = std::max(box.high[k], x[k]);
    }
}

void Boxes::gather(Transport& transport, const Box* mine) {
    of_part_.resize(transport.parts());
    of_division_.resize(transport.parts());
    transport.gather(mine, sizeof(Box), of_part_.data());
    each_division(0, transport.parts(), [&](PartId first, PartId middle, PartId last) {
        Box& box = of_division_[middle] = empty_box();
        for (PartId p = first; p < last; ++p) {
            if (of_part_[p].is_empty()) continue;
            add(box, of_part_[p].low);
            add(box, of_part_[p].high);
        }
    });
}

// A place y, relative to the base, is in the closed ball where |y|^2 - w.y is at most 0: a sum of
// parabolas, one an axis, whose least values in the box add up. The bound of w's error is per
// coordinate; the rest is for rounding, generously, since being wrong this way costs little.
bool Boxes::meets_ball(const Box& box, const Sphere& s, const double* base, int scale) {
    double least = 0, sizes = 0, reach = 0;
    for (int k = 0; k < 3; ++k) {
        if (!scales_exactly(box.low[k], scale) || !scales_exactly(box.high[k], scale)) return true;
        const double low = scaled(box.low[k], scale) - base[k],
                     high = scaled(box.high[k], scale) - base[k];
        const double y = std::min(std::max(0.5 * s.w[k], low), high);
        least += y * (y - s.w[k]);
        const double farthest = std::max(std::fabs(low), std::fabs(high));
        sizes += farthest * (farthest + std::fabs(s.w[k]));
        reach += farthest;
    }
    return !(least > s.e * reach * (1 + 0x1p-40) + 0x1p-45 * sizes);
}

bool Boxes::is_beyond(const Box& box, const double* a, const double* b, const double* c,
                      const double* inner) {
    const int inside = orientation(a, b, c, inner);
    for (unsigned i = 0; i < 8; ++i) {
        double corner[3];
        for (unsigned k = 0; k < 3; ++k) corner[k] = (i >> k & 1 ? box.high : box.low)[k];
        if (orientation(a, b, c, corner) == -inside) return true;
    }
    return false;
}

}  // namespace mgdt
