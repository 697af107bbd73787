// SPDX-License-Identifier: MIT
#include "improvement/flips.hpp"

#include <utility>

namespace mgdt {

// Finds the change of a tetrahedron's edges and faces whose worst new tetrahedron is the best.
bool Flips::find(std::uint32_t t, Finder& finder, Change& best) const {
    best.clear();
    best.after = 0;
    const auto keep = [&](bool is_found) {
        if (is_found && finder.other.after > best.after) std::swap(best, finder.other);
    };
    for (unsigned i = 0; i < 4; ++i)
        for (unsigned j = i + 1; j < 4; ++j) keep(finder.edges.find(t, i, j, finder.other));
    for (unsigned i = 0; i < 4; ++i) keep(finder.faces.find(t, i, finder.other));
    return !best.empty();
}

std::size_t Flips::pass(double goal, StageProgress& progress) {
    candidates_.clear();
    for (std::uint32_t t = 0; t < mesh_.tetrahedra.size(); ++t)
        if (!mesh_.tetrahedra[t].is_dead() && mesh_.qualities[t] < goal) candidates_.push_back(t);
    return round_.run(candidates_.size(), progress,
                      [&](std::size_t k, unsigned member, Change& change) {
                          return find(candidates_[k], finders_[member], change);
                      });
}

}  // namespace mgdt
