// SPDX-License-Identifier: MIT
// A tree of bounding boxes for the points of each part. The tree tells which parts may have points
// in a circumball, or beyond a hull facet: the parts with a box that meets the ball or the
// half-space. If rounding leaves a test undecided, the box counts as one that meets it.
#pragma once

#include "kernel/circumsphere.hpp"
#include "mesh/bounding_box.hpp"
#include "parts/homes.hpp"
#include "parts/part_point.hpp"

namespace mgdt {

// The boxes of a part are around all its points, around each half of them, each quarter, and so on.
// Small boxes fit curves and surfaces closely.
class Boxes {
  public:
    Boxes(Allocator& allocator, PartId parts)
        : parts_(parts), leaves_(most_leaves), nodes_(allocator), of_division_(allocator) {
        // Each process has the boxes of all parts, so their number is limited.
        while (leaves_ > least_leaves && leaves_ * parts > most_boxes) leaves_ /= 2;
    }

    // The number of boxes of a part.
    std::size_t size() const { return 2 * leaves_; }
    // Makes the boxes of a part. Box 1 is around all points; the halves of box i are 2 i and 2 i
    // + 1.
    void divide(const PartPoint* points, std::size_t n, BoundingBox* nodes) const;
    // Collective. Takes the boxes of the local parts, and distributes them to all processes.
    void gather(Collective& all, const Buffer<BoundingBox>& nodes);

    // Calls visit(part) for each part with a box that meets a ball. The sphere `s` is relative to
    // `base`; boxes are multiplied by 2^scale.
    template <class Visit>
    void each_in_ball(const Sphere& s, const double* base, int scale, const Visit& visit) const {
        each_that(visit, [&](const BoundingBox& box) { return meets_ball(box, s, base, scale); });
    }
    // Calls visit(part) for each part with a box that reaches strictly beyond the plane of a, b and
    // c. `inner` is a point on the inner side. Coordinates are not scaled.
    template <class Visit>
    void each_beyond(const double* a, const double* b, const double* c, const double* inner,
                     const Visit& visit) const {
        const Facet facet(a, b, c, inner);
        each_that(visit, [&](const BoundingBox& box) { return is_beyond(box, facet); });
    }

    static bool meets_ball(const BoundingBox& box, const Sphere& s, const double* base, int scale);
    // The plane of a hull facet. If rounding leaves the side of a point undecided, the exact
    // orientation of a, b, c and the point decides.
    struct Facet {
        Facet(const double* a, const double* b, const double* c, const double* inner);
        const double *a, *b, *c;
        int inside;          // the orientation of a point on the inner side
        double normal[3];    // pointing outwards, rounded
        double products[3];  // the sum of the magnitudes of the two products in each component
    };
    static bool is_beyond(const BoundingBox& box, const Facet& facet);

  private:
    static constexpr std::size_t most_leaves = 512, least_leaves = 16, most_boxes = 65536;

    struct Place;
    struct Split;

    template <class Visit, class Test>
    void each_that(const Visit& visit, const Test& test) const {
        each_among(0, parts_, visit, test);
    }
    template <class Visit, class Test>
    void each_among(PartId first, PartId last, const Visit& visit, const Test& test) const {
        if (last - first == 1) {
            if (any_leaf(first, 1, test)) visit(first);
            return;
        }
        const PartId middle = first + (last - first) / 2;
        if (of_division_[middle].is_empty() || !test(of_division_[middle])) return;
        each_among(first, middle, visit, test);
        each_among(middle, last, visit, test);
    }
    const BoundingBox& node(PartId part, std::size_t i) const {
        return nodes_[part * 2 * leaves_ + i];
    }
    template <class Test>
    bool any_leaf(PartId part, std::size_t i, const Test& test) const {
        if (node(part, i).is_empty() || !test(node(part, i))) return false;
        return i >= leaves_ || any_leaf(part, 2 * i, test) || any_leaf(part, 2 * i + 1, test);
    }
    static void split(Place* begin, Place* end, std::size_t i, std::size_t leaves, Split* splits);

    PartId parts_;
    std::size_t leaves_;
    Buffer<BoundingBox> nodes_;  // the boxes of each part, one part after another
    // The box of each set of parts that is divided. The index is the part in the middle.
    Buffer<BoundingBox> of_division_;
};

}  // namespace mgdt
