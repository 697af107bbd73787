// SPDX-License-Identifier: MIT
// Which part is home to a point: a k-d tree over the parts, which divides the points evenly. The
// home depends on the coordinates alone, so equal points meet in one part.
#pragma once

#include "parts/collective.hpp"

namespace mgdt {

// Calls visit(first, middle, last) for each set of parts that is divided, first to middle on one
// side and middle to last on the other, before those that it is divided into. `middle` names it.
template <class Visit>
void each_division(PartId first, PartId last, const Visit& visit) {
    if (last - first < 2) return;
    const PartId middle = first + (last - first) / 2;
    visit(first, middle, last);
    each_division(first, middle, visit);
    each_division(middle, last, visit);
}

// The points that a local part was given.
struct GivenPoints {
    const double* xyz;
    std::size_t n;
};

class Homes {
  public:
    Homes(Allocator& allocator, PartId parts) : parts_(parts), splitters_(allocator, parts) {}

    // Collective. `points` has an entry for each local part.
    void divide(Collective& all, const GivenPoints* points);
    PartId of(const double* x) const {
        PartId first = 0, last = parts_;
        while (last - first > 1) {
            const PartId middle = first + (last - first) / 2;
            (splitters_[middle].has_before(x) ? last : first) = middle;
        }
        return first;
    }

  private:
    // A point, and the axis that is compared first: what is before it goes to the lower side.
    struct Splitter {
        double x[3];
        unsigned axis;

        bool has_before(const double* p) const { return compare(p) < 0; }
        bool has_after(const double* p) const { return compare(p) > 0; }
        // Where p is from here.
        int compare(const double* p) const {
            for (unsigned k = 0; k < 3; ++k) {
                const unsigned a = (axis + k) % 3;
                if (p[a] != x[a]) return p[a] < x[a] ? -1 : 1;
            }
            return 0;
        }
    };
    // A set of parts that is being divided.
    struct Node {
        PartId first, middle, last;
        unsigned axis;
        std::uint64_t points, wanted;  // in all, and on the lower side
        // Candidates around the place that is wanted, and the best so far.
        Splitter low, high, best;
        bool has_low, has_high, has_best;
        std::uint64_t off;  // of the best
    };
    class Level;

    PartId parts_;
    Buffer<Splitter> splitters_;  // by the part in the middle
};

}  // namespace mgdt
