// SPDX-License-Identifier: MIT
// The boxes around the points of the parts, and which of them a circumball or the outside of a hull
// facet meets. Where rounding leaves that open, they do.
#pragma once

#include "kernel/circumsphere.hpp"
#include "parts/homes.hpp"

namespace mgdt {

struct Box {
    double low[3], high[3];
    bool is_empty() const { return !(low[0] <= high[0]); }
};
Box empty_box();
void add(Box& box, const double* x);

class Boxes {
  public:
    explicit Boxes(Allocator& allocator) : of_part_(allocator), of_division_(allocator) {}

    // Collective: boxes of the local parts in, those of all out.
    void gather(Transport& transport, const Box* mine);
    const Box& of(PartId part) const { return of_part_[part]; }
    const Box& all() const {
        return of_part_.size() == 1 ? of_part_[0] : of_division_[of_part_.size() / 2];
    }

    // Calls visit(part) for each part whose box, multiplied by 2^scale, meets the ball that has w
    // and its error in `s`, its base at `base`.
    template <class Visit>
    void each_in_ball(const Sphere& s, const double* base, int scale, const Visit& visit) const {
        each_that(visit, [&](const Box& box) { return meets_ball(box, s, base, scale); });
    }
    // Of those with a place strictly beyond the plane of a, b and c, which `inner` is on the inner
    // side of; not scaled.
    template <class Visit>
    void each_beyond(const double* a, const double* b, const double* c, const double* inner,
                     const Visit& visit) const {
        each_that(visit, [&](const Box& box) { return is_beyond(box, a, b, c, inner); });
    }

    static bool meets_ball(const Box& box, const Sphere& s, const double* base, int scale);
    static bool is_beyond(const Box& box, const double* a, const double* b, const double* c,
                          const double* inner);

  private:
    template <class Visit, class Test>
    void each_that(const Visit& visit, const Test& test) const {
        each_among(0, static_cast<PartId>(of_part_.size()), visit, test);
    }
    template <class Visit, class Test>
    void each_among(PartId first, PartId last, const Visit& visit, const Test& test) const {
        const bool is_one = last - first == 1;
        const PartId middle = first + (last - first) / 2;
        const Box& box = is_one ? of_part_[first] : of_division_[middle];
        if (box.is_empty() || !test(box)) return;
        if (is_one) return visit(first);
        each_among(first, middle, visit, test);
        each_among(middle, last, visit, test);
    }

    Buffer<Box> of_part_, of_division_;  // of_division_: by the part in the middle
};

}  // namespace mgdt
