// SPDX-License-Identifier: MIT
#include "recovery/patch_recovery.hpp"

#include <algorithm>

namespace mgdt {

bool PatchRecovery::recover(std::uint32_t a, std::uint32_t b) {
    if (!patch_.find(a, b)) return false;
    for (const bool is_wide : {false, true}) {
        if (is_wide && !patch_.widen()) return false;
        const std::uint8_t failure = is_wide ? wide : narrow;
        failed_.resize(patch_.all_triangles(), 0);
        const Buffer<std::uint32_t>& of = patch_.triangles();
        if (std::any_of(of.begin(), of.end(),
                        [&](std::uint32_t t) { return (failed_[t] & failure) != 0; }))
            continue;
        if (recover_patch()) return true;
        for (const std::uint32_t t : of) failed_[t] |= failure;
    }
    return false;
}

bool PatchRecovery::recover_patch() {
    const std::size_t state = mesh_.state();
    cavity_.clear();
    added_.clear();
    const bool is_done = find_cavity() && add_point(PatchCavity::above) &&
                         add_point(PatchCavity::below) &&
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

// Finds a place for the new point of a side, and lists its tetrahedra.
bool PatchRecovery::add_point(PatchCavity::Side side) {
    const std::size_t state = mesh_.state(), first = added_.size();
    const double direction = side == PatchCavity::above ? 1 : -1;
    for (const double share : {0.6173, 0.2137, 0.0513, 0.0127, 1.3e-3, 1.1e-4, 1.7e-6, 1.9e-8}) {
        double x[3];
        for (int k = 0; k < 3; ++k)
            x[k] = patch_.middle()[k] + direction * share * patch_.radius() * patch_.normal()[k];
        const std::uint32_t z = mesh_.add_point(x);
        added_.resize(first);
        append_patch(side, z);
        if (mesh_.are_positive(added_, first) && cavity_.grow(side, z, patch_)) {
            cavity_.append(side, z, added_);
            center_new_point(mesh_, z, added_, first, center_);
            return true;
        }
        mesh_.undo(state);
    }
    return false;
}

// Lists the tetrahedra that join a point to the triangles of the patch.
void PatchRecovery::append_patch(PatchCavity::Side side, std::uint32_t point) {
    const Buffer<std::uint32_t>& v = patch_.corners();
    for (std::size_t i = 0; i < v.size(); i += 3)
        if (side == PatchCavity::above)
            added_.push_back({{v[i], v[i + 1], v[i + 2], point}});
        else
            added_.push_back({{v[i + 2], v[i + 1], v[i], point}});
}

}  // namespace mgdt
