// SPDX-License-Identifier: MIT
#include "recovery/patch_recovery.hpp"

#include <algorithm>

namespace mgdt {

bool PatchRecovery::recover(std::uint32_t a, std::uint32_t b) {
    return patch_.find(a, b) && (try_patch(narrow) || (patch_.widen() && try_patch(wide)));
}

// Recovers the patch, or else one with the neighbours that the cavity of the patch would lose.
bool PatchRecovery::try_patch(Failure failure) {
    constexpr int most_patches = 8;
    failed_.resize(patch_.all_triangles(), 0);
    const Buffer<std::uint32_t>& of = patch_.triangles();
    if (std::any_of(of.begin(), of.end(),
                    [&](std::uint32_t t) { return (failed_[t] & failure) != 0; }))
        return false;
    for (int i = 0; i < most_patches; ++i) {
        if (recover_patch()) return true;
        if (failure == wide || !patch_.add_neighbors(cavity_.lost())) break;
    }
    for (const std::uint32_t t : of) failed_[t] |= failure;
    return false;
}

bool PatchRecovery::recover_patch() {
    const std::size_t state = mesh_.state();
    cavity_.clear();
    added_.clear();
    const bool is_done = find_cavity() && fill_side(PatchCavity::above) &&
                         fill_side(PatchCavity::below) && cavity_.loses_nothing(patch_) &&
                         mesh_.replace(cavity_.tetrahedra(), added_);
    cavity_.clear();
    if (!is_done) {
        mesh_.undo(state);
        return false;
    }
    for (const std::uint32_t v : cavity_.vanishing()) mesh_.hints[v] = no_tetrahedron;
    return true;
}

// Finds what the edges of the patch cross.
bool PatchRecovery::find_cavity() {
    for (std::uint32_t i = 0; i < patch_.inner_edges().size(); ++i) {
        const auto [a, b] = patch_.inner_edges().pair(i);
        const CrossingWalk::Result result = walk_.run(a, b);
        if (result == CrossingWalk::Result::meets) return false;
        if (result == CrossingWalk::Result::is_edge) {
            cavity_.take_in_ring(a, b);
            continue;
        }
        for (const Crossing& c : walk_.crossings()) {
            cavity_.take_in(c.tetrahedron);
            if (c.is_edge()) cavity_.take_in_ring(c.v[0], c.v[1]);
        }
        const std::uint32_t last = mesh_.tetrahedron_towards(b, a);
        if (last == no_tetrahedron) return false;
        cavity_.take_in(last);
    }
    return cavity_.divide(patch_);
}

// Lists tetrahedra that fill what is between a side and the patch: they join a vertex of the side
// to both, or else a new point.
bool PatchRecovery::fill_side(PatchCavity::Side side) {
    const std::size_t first = added_.size();
    cavity_.collect_vertices(side, vertices_);
    for (const std::uint32_t v : vertices_)
        if (join(side, v, first) && added_.size() > first) return true;
    // The cavity grows where a face is not visible from the point.
    const double direction = side == PatchCavity::above ? 1 : -1;
    const std::size_t state = mesh_.state();
    for (const double share : {0.6173, 0.2137, 0.0513, 0.0127, 1.3e-3, 1.1e-4, 1.7e-6, 1.9e-8}) {
        const std::uint32_t z = add_point(direction * share);
        added_.resize(first);
        append_patch(side, z);
        if (enter_half_spaces(mesh_, z, added_, first, center_) && cavity_.grow(side, z, patch_)) {
            cavity_.append(side, z, added_);
            center_new_point(mesh_, z, added_, first, center_);
            return true;
        }
        mesh_.undo(state);
    }
    // A place from which all faces are visible may be beside the middle.
    const std::uint32_t z = add_point(direction * 0.0513);
    join(side, z, first);
    if (enter_half_spaces(mesh_, z, added_, first, center_)) {
        center_new_point(mesh_, z, added_, first, center_);
        return true;
    }
    mesh_.undo(state);
    return false;
}

// Adds a point that is above the middle of the patch by a share of its radius.
std::uint32_t PatchRecovery::add_point(double share) {
    double x[3];
    for (int k = 0; k < 3; ++k)
        x[k] = patch_.middle()[k] + share * patch_.radius() * patch_.normal()[k];
    return mesh_.add_point(x);
}

// Lists the tetrahedra that join a point to a side and to the patch, from element `first` on.
// Returns whether they are positive.
bool PatchRecovery::join(PatchCavity::Side side, std::uint32_t point, std::size_t first) {
    added_.resize(first);
    append_patch(side, point);
    cavity_.append(side, point, added_);
    return mesh_.are_positive(added_, first);
}

// Lists the tetrahedra that join a point to the triangles of the patch which do not have it.
void PatchRecovery::append_patch(PatchCavity::Side side, std::uint32_t point) {
    const Buffer<std::uint32_t>& v = patch_.corners();
    for (std::size_t i = 0; i < v.size(); i += 3) {
        if (v[i] == point || v[i + 1] == point || v[i + 2] == point) continue;
        if (side == PatchCavity::above)
            added_.push_back({{v[i], v[i + 1], v[i + 2], point}});
        else
            added_.push_back({{v[i + 2], v[i + 1], v[i], point}});
    }
}

}  // namespace mgdt
