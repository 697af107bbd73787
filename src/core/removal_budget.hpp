// SPDX-License-Identifier: MIT
// Decides when a call that removes vertices one by one should triangulate the remaining ones anew
// instead: when the work done, with that of the next removals, exceeds the work of a rebuild. The
// call then takes at most about twice the time of a rebuild, whatever the sizes of the links. Work
// is estimated from counts, not measured, so that every run decides alike.
#pragma once

#include <algorithm>
#include <cstddef>

namespace mgdt {

// The unit of work is one tetrahedron created by an insertion.
class RemovalBudget {
  public:
    // A budget for a mesh with this many tetrahedra and vertices.
    RemovalBudget(std::size_t tetrahedra, std::size_t vertices)
        : rebuild_(per_tetrahedron * static_cast<double>(tetrahedra) + least_rebuild),
          vertices_(static_cast<double>(vertices)) {}

    // Whether a rebuild is better than removing the next vertex, whose link has `link` vertices.
    // `left` vertices are still to be removed, including the next one. `is_large`: the link would
    // be triangulated by itself.
    bool is_exceeded_by(std::size_t link, bool is_large, std::size_t left) const noexcept {
        // A single removal takes little longer than a rebuild, whatever its link.
        if (left == 1) return false;
        // Assume that the next few vertices have links of the same size.
        const auto some = static_cast<double>(std::min<std::size_t>(left, 4));
        const double share = static_cast<double>(link) / vertices_;
        const double work =
            is_large ? per_neighbor * static_cast<double>(link) + rebuild_ * share : work_of(link);
        return work_ + some * work > limit * rebuild_;
    }
    // Adds the work of a removal. `tetrahedra` is the size of the triangulation of the link, or 0
    // if the hole was filled facet by facet.
    void add(std::size_t link, std::size_t tetrahedra) noexcept {
        work_ += tetrahedra == 0 ? work_of(link)
                                 : per_neighbor * static_cast<double>(link) +
                                       per_tetrahedron * static_cast<double>(tetrahedra);
    }

  private:
    static double work_of(std::size_t link) noexcept {
        const auto n = static_cast<double>(link);
        return per_neighbor * n + per_pair * n * n;
    }

    // Measured on the point sets of tests/bench/sweep_calls. Inserting a set creates 3.4 tetrahedra
    // for each that remains. A removal costs 15 units per vertex of the link, and 0.04 per pair of
    // such vertices, which the search for an apex compares.
    static constexpr double per_tetrahedron = 3.4, per_neighbor = 15, per_pair = 0.04;
    // The work of about 64 ordinary removals: fewer points of a small mesh are removed one by one.
    static constexpr double least_rebuild = 16000;
    // A call rebuilds if its work would exceed this multiple of the work of a rebuild. Removing a
    // tenth of a uniform set one by one stays below the limit.
    static constexpr double limit = 1.4;

    double rebuild_, vertices_, work_ = 0;
};

}  // namespace mgdt
