// SPDX-License-Identifier: MIT
// When a call that takes vertices out one by one had better triangulate the others anew: once its
// work has come near to that of doing so, or will soon. So it takes little more than twice that
// time, whatever the sizes of the links. Counts decide, not times, so that every run does the same.
#pragma once

#include <algorithm>
#include <cstddef>

namespace mgdt {

// Work is in units of a tetrahedron that an insertion creates.
class RemovalBudget {
  public:
    // Of a mesh with this number of tetrahedra and of vertices.
    RemovalBudget(std::size_t tetrahedra, std::size_t vertices)
        : rebuild_(per_tetrahedron * static_cast<double>(tetrahedra) + least_rebuild),
          vertices_(static_cast<double>(vertices)) {}

    // Whether to triangulate anew rather than to take out a vertex with `link` vertices around it,
    // the first of `left` that are to go; with `is_large` its link is triangulated by itself.
    bool is_exceeded_by(std::size_t link, bool is_large, std::size_t left) const noexcept {
        // One alone takes little longer than a new triangulation, whatever its link.
        if (left == 1) return false;
        // The next ones are expected to have links like it.
        const auto some = static_cast<double>(std::min<std::size_t>(left, 4));
        const double share = static_cast<double>(link) / vertices_;
        const double work =
            is_large ? per_neighbor * static_cast<double>(link) + rebuild_ * share : work_of(link);
        return work_ + some * work > limit * rebuild_;
    }
    // The hole of a vertex was filled facet by facet, or from a triangulation of its link with
    // this number of tetrahedra, else 0.
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

    // Measured on the families of tests/bench/sweep_calls: an insertion creates 3.4 tetrahedra for
    // each that stays, and a removal takes as long as 15 for each vertex of its link, and 1 for
    // each 25 pairs of them that a pass compares.
    static constexpr double per_tetrahedron = 3.4, per_neighbor = 15, per_pair = 0.04;
    // That of some 64 ordinary removals, so that few points of a small mesh go one by one.
    static constexpr double least_rebuild = 16000;
    // A tenth of uniform points, taken out one by one, stays below.
    static constexpr double limit = 1.4;

    double rebuild_, vertices_, work_ = 0;
};

}  // namespace mgdt
