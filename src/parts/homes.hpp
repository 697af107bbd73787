// SPDX-License-Identifier: MIT
// Gives each point its home, the part that owns it: a k-d tree over the parts divides the points
// evenly. The home depends on the coordinates alone, so equal points have the same home.
#pragma once

#include "parts/collective.hpp"

namespace mgdt {

// Calls visit(first, middle, last) for each set of parts that is divided: parts first..middle-1 are
// on the lower side, middle..last-1 on the upper side. A set is visited before its subsets. Each
// set has a different `middle`, which identifies the set.
template <class Visit>
void each_division(PartId first, PartId last, const Visit& visit) {
    if (last - first < 2) return;
    const PartId middle = first + (last - first) / 2;
    visit(first, middle, last);
    each_division(first, middle, visit);
    each_division(middle, last, visit);
}

// The points that were inserted into a local part.
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
    // A point, and the axis that is compared first. Points before it go to the lower side.
    struct Splitter {
        double x[3];
        unsigned axis;

        bool has_before(const double* p) const { return compare(p) < 0; }
        bool has_after(const double* p) const { return compare(p) > 0; }
        // -1 if p is before the splitter, 0 if it is equal to the splitter, 1 if it is after it.
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
        std::uint64_t points, wanted;  // the number of all points, and of those for the lower side
        // The two candidates that enclose the right splitter, and the best candidate so far.
        Splitter low, high, best;
        bool has_low, has_high, has_best;
        std::uint64_t off;  // the error of `best`, in points
    };
    class Level;

    PartId parts_;
    Buffer<Splitter> splitters_;  // the splitter of each set of parts, indexed by its `middle`
};

}  // namespace mgdt
