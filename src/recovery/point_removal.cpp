// SPDX-License-Identifier: MIT
#include "recovery/point_removal.hpp"

#include <algorithm>

#include "platform/take_out_repeats.hpp"
#include "recovery/flatness.hpp"

namespace mgdt {

void PointRemoval::run(std::uint32_t first, const StopRequest& stop) {
    constexpr int most_passes = 4;
    bool is_changed = true;
    for (int pass = 0; pass < most_passes && is_changed; ++pass) {
        is_changed = false;
        for (std::uint32_t v = first; v < mesh_.point_count(); ++v) {
            stop.poll();
            if (mesh_.hints[v] == no_tetrahedron) continue;
            mesh_.forget();
            is_changed = remove(v) || is_changed;
        }
    }
}

bool PointRemoval::remove(std::uint32_t v) {
    if (contract(v)) return true;
    // Removes one edge after the other, as long as that is possible.
    constexpr std::size_t rings = 1000;
    flips_.set_budget(rings);
    const std::size_t state = mesh_.state();
    const Crossings none = Crossings::of_nothing(mesh_);
    for (bool is_changed = true; is_changed;) {
        is_changed = false;
        collect_star(v);
        for (const std::uint32_t neighbor : neighbors_) {
            int change = 0;
            if (!flips_.remove_edge(v, neighbor, none, 0, 1, change)) continue;
            if (contract(v)) return true;
            is_changed = true;
            break;
        }
    }
    mesh_.undo(state);
    return false;
}

// Finds the tetrahedra at a vertex, and its neighbours in ascending order.
void PointRemoval::collect_star(std::uint32_t v) {
    mesh_.collect_star(v, star_);
    neighbors_.clear();
    for (const std::uint32_t t : star_)
        for (const std::uint32_t neighbor : mesh_.tetrahedra[t].v)
            if (neighbor != v) neighbors_.push_back(neighbor);
    take_out_repeats(neighbors_);
}

// Moves a vertex to the neighbour for which the flattest tetrahedron is best.
bool PointRemoval::contract(std::uint32_t v) {
    collect_star(v);
    double least = 0;
    best_.clear();
    for (const std::uint32_t target : neighbors_) {
        const double flat = move_to(v, target);
        if (added_.empty() || (!best_.empty() && flat >= least)) continue;
        least = flat;
        best_.clear();
        for (const FlipMesh::Corners& t : added_) best_.push_back(t);
    }
    if (best_.empty() || !mesh_.replace(star_, best_)) return false;
    mesh_.hints[v] = no_tetrahedron;
    return true;
}

// Lists the tetrahedra that a vertex takes to a neighbour in added_, which is empty if one is not
// positive. Returns how flat the flattest one is.
double PointRemoval::move_to(std::uint32_t v, std::uint32_t target) {
    double worst = 0;
    added_.clear();
    for (const std::uint32_t s : star_) {
        const FlipMesh::Tetrahedron& from = mesh_.tetrahedra[s];
        if (from.has(target)) continue;
        FlipMesh::Corners t;
        std::copy_n(from.v, 4, t.v);
        *std::find(t.v, t.v + 4, v) = target;
        if (!mesh_.is_positive(t)) {
            added_.clear();
            return 0;
        }
        worst = std::max(worst, flatness_of(mesh_.point(t.v[0]), mesh_.point(t.v[1]),
                                            mesh_.point(t.v[2]), mesh_.point(t.v[3])));
        added_.push_back(t);
    }
    return worst;
}

}  // namespace mgdt
