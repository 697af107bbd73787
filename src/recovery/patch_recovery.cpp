// SPDX-License-Identifier: MIT
#include "recovery/patch_recovery.hpp"

#include <algorithm>

namespace mgdt {

bool PatchRecovery::recover(std::uint32_t a, std::uint32_t b) {
    failed_.resize(patch_.all_triangles(), 0);
    if (!patch_.find(a, b)) return false;
    if (has_failed(narrow) && has_failed(wide)) return false;
    if (!has_failed(narrow)) {
        if (try_patch(narrow)) return true;
        // The patch may have other triangles now.
        if (!patch_.find(a, b)) return false;
    }
    if (has_failed(wide)) return false;
    if (patch_.widen()) return try_patch(wide);
    mark(wide, patch_.triangles().size());
    return false;
}

// Whether a patch with a triangle of this one has failed.
bool PatchRecovery::has_failed(Failure failure) const noexcept {
    const Buffer<std::uint32_t>& of = patch_.triangles();
    return std::any_of(of.begin(), of.end(),
                       [&](std::uint32_t t) { return (failed_[t] & failure) != 0; });
}

// Records that a patch with the first `triangles` triangles of this one has failed.
void PatchRecovery::mark(Failure failure, std::size_t triangles) noexcept {
    for (std::size_t i = 0; i < triangles; ++i) failed_[patch_.triangles()[i]] |= failure;
}

// Recovers the patch, or else one with the neighbours that the cavity of the patch would lose.
bool PatchRecovery::try_patch(Failure failure) {
    constexpr int most_patches = 8;
    const std::size_t triangles = patch_.triangles().size();
    for (int i = 0; i < most_patches; ++i) {
        cavity_.forget_lost();
        if (recover_patch()) return true;
        if (failure == wide || !patch_.add_neighbors(cavity_.lost())) break;
    }
    mark(failure, triangles);
    return false;
}

bool PatchRecovery::recover_patch() {
    const std::size_t state = mesh_.state();
    cavity_.clear();
    added_.clear();
    bool is_done = find_cavity() && fill_side(PatchCavity::above) &&
                   fill_side(PatchCavity::below) && cavity_.loses_nothing(patch_) &&
                   mesh_.replace(cavity_.tetrahedra(), added_);
    cavity_.clear();
    if (is_done)
        for (const std::uint32_t v : cavity_.vanishing()) mesh_.hints[v] = no_tetrahedron;
    is_done = is_done && patch_.is_in_mesh();
    if (!is_done) mesh_.undo(state);
    return is_done;
}

// Finds what the edges of the patch cross.
bool PatchRecovery::find_cavity() {
    for (std::uint32_t i = 0; i < patch_.inner_edges().size(); ++i) {
        stop_.poll();
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
    for (const std::uint32_t v : vertices_) {
        stop_.poll();
        if (join(side, v, first) && added_.size() > first) return true;
    }
    // The cavity grows where a face is not visible from the point.
    const double direction = side == PatchCavity::above ? 1 : -1;
    const std::size_t state = mesh_.state();
    for (const double share : {0.6173, 0.2137, 0.0513, 0.0127, 1.3e-3, 1.1e-4, 1.7e-6, 1.9e-8}) {
        const std::uint32_t z = add_point(direction * share);
        list(side, z, first, false);
        if (enter_half_spaces(mesh_, z, added_, first, center_) && cavity_.grow(side, z, patch_)) {
            list(side, z, first, true);
            center_new_point(mesh_, z, added_, first, center_);
            return true;
        }
        mesh_.undo(state);
    }
    // A place from which all faces are visible may be beside the middle.
    const std::uint32_t z = add_point(direction * 0.0513);
    list(side, z, first, true);
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

// Lists the tetrahedra that join a point to a side and to the patch, from element `first` on. Stops
// and returns false if one is not positive.
bool PatchRecovery::join(PatchCavity::Side side, std::uint32_t point, std::size_t first) {
    added_.resize(first);
    const auto add = [&](const FlipMesh::Corners& t) {
        added_.push_back(t);
        return mesh_.is_positive(t);
    };
    return for_each_on_patch(side, point, add) && cavity_.for_each_on_side(side, point, add);
}

// Lists all these tetrahedra, or only those at triangles of the patch.
void PatchRecovery::list(PatchCavity::Side side, std::uint32_t point, std::size_t first,
                         bool is_whole) {
    added_.resize(first);
    const auto add = [&](const FlipMesh::Corners& t) { return added_.push_back(t), true; };
    for_each_on_patch(side, point, add);
    if (is_whole) cavity_.for_each_on_side(side, point, add);
}

// Calls use(t) for the tetrahedra that join a point to the triangles of the patch which do not have
// it, until one of these calls returns false. Returns whether none does.
template <class Use>
bool PatchRecovery::for_each_on_patch(PatchCavity::Side side, std::uint32_t point,
                                      const Use& use) const {
    const Buffer<std::uint32_t>& v = patch_.corners();
    for (std::size_t i = 0; i < v.size(); i += 3) {
        if (v[i] == point || v[i + 1] == point || v[i + 2] == point) continue;
        const std::size_t first = side == PatchCavity::above ? i : i + 2, last = 2 * i + 2 - first;
        if (!use(FlipMesh::Corners{{v[first], v[i + 1], v[last], point}})) return false;
    }
    return true;
}

}  // namespace mgdt
