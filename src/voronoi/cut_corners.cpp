// SPDX-License-Identifier: MIT
#include "voronoi/cut_corners.hpp"

#include <algorithm>

#include "mesh/scale.hpp"
#include "platform/hash.hpp"

namespace mgdt {
namespace {

bool are_equal(const CutCorners::Key& a, const CutCorners::Key& b) {
    return std::equal(a.of, a.of + 4, b.of);
}

std::uint32_t hash_of(const CutCorners::Key& key) {
    return hash_of_words(key.of[0], key.of[1], key.of[2], key.of[3]);
}

}  // namespace

CutCorners::CutCorners(const MeshView& view, const VertexIndices& indices, const Region& region,
                       const Circumcenters& centers, const Buffer<VertexId>& vertex_of)
    : mesh_(view.mesh),
      indices_(indices),
      region_(region),
      centers_(centers),
      vertex_of_(vertex_of),
      half_spaces_(view.allocator),
      by_key_(view.allocator),
      by_position_(view.allocator),
      keys_(view.allocator),
      positions_(view.allocator),
      points_(view.allocator),
      key_of_point_(view.allocator) {}

void CutCorners::add_half_space(std::uint32_t of, HalfSpaces& to) const {
    if (is_plane(of))
        to.add_plane(region_.numbers(of & ~VoronoiDiagram::plane), mesh_.scale);
    else
        to.add_nearer_side(point(of));
}

// Sets the half-spaces 0, 1 and 2 to those of a corner. The least member of its key is a site,
// because numbers of planes are larger.
void CutCorners::set_planes(const Key& key) {
    half_spaces_.clear(point(key.of[0]), 1);
    for (int i = 1; i < 4; ++i) add_half_space(key.of[i], half_spaces_);
}

SplitPoint CutCorners::position(const Key& key) {
    set_planes(key);
    Vector<Twofold> x;
    double error[3], nearest[3];
    const bool is_ordinary = half_spaces_.round_corner(0, 1, 2, x);
    bool is_known = is_ordinary;
    for (int k = 0; k < 3 && is_ordinary; ++k) {
        const double low = x.x[k].low;
        error[k] = HalfSpaces::corner_error * std::fabs(x.x[k].high);
        nearest[k] = x.x[k].high + low;
        is_known &= x.x[k].high + (low - error[k]) == nearest[k] &&
                    x.x[k].high + (low + error[k]) == nearest[k];
    }
    if (!is_known) half_spaces_.nearest_corner(0, 1, 2, 0, nearest);
    for (int k = 0; k < 3 && !is_ordinary; ++k) {
        x.x[k] = {nearest[k], 0};
        error[k] = rounding_of<double> * std::fabs(nearest[k]) + 0x1p-1074;
    }
    return split(x.x, error, nearest, centers_.factor());
}

// Whether the corners of two keys are at one point. They are if the first corner is on all planes
// of the second key, and as far from the sites of the second key as from its own.
bool CutCorners::is_same(const Key& a, const Key& b) {
    set_planes(a);
    PlaneNumber next = 3;
    for (const std::uint32_t of : b.of) {
        if (std::find(a.of, a.of + 4, of) != a.of + 4) continue;
        add_half_space(of, half_spaces_);
        if (half_spaces_.side_of_corner(0, 1, 2, next++) != 0) return false;
    }
    return true;
}

// The number of a key. That of a new key is keys_.size(), and keys_ has room for it.
std::uint32_t CutCorners::number_of(const Key& key) {
    by_key_.reserve(keys_.size() + 1);
    keys_.grow(keys_.size() + 1);
    return by_key_.number(hash_of(key),
                          [&](std::uint32_t i) { return are_equal(keys_[i].key, key); });
}

void CutCorners::add(TetId t) {
    Key key;
    for (int i = 0; i < 4; ++i) key.of[i] = indices_[mesh_.tetrahedra[t].v[i]];
    std::sort(key.of, key.of + 4);
    const TetId first = centers_.first_equal(t);
    const std::uint32_t number = number_of(key);
    if (number == keys_.size()) keys_.push_back({key, first});
    by_position_.reserve(positions_.size() + 1);
    positions_.grow(positions_.size() + 1);
    // Circumcentres of different sets of tetrahedra are different points.
    const std::uint32_t here =
        by_position_.number(hash_of_coordinates(centers_[first].x),
                            [&](std::uint32_t i) { return positions_[i].corner == first; });
    if (here == positions_.size()) positions_.push_back({key, first});
}

std::uint32_t CutCorners::find(Key key) {
    std::sort(key.of, key.of + 4);
    const std::uint32_t number = number_of(key);
    if (number < keys_.size()) return keys_[number].corner;
    keys_.push_back({key, 0});
    const SplitPoint at = position(key);
    by_position_.reserve(positions_.size() + 1);
    positions_.grow(positions_.size() + 1);
    const std::uint32_t here = by_position_.number(hash_of_coordinates(at.x), [&](std::uint32_t i) {
        const SplitPoint& other = (*this)[positions_[i].corner];
        return std::equal(at.x, at.x + 3, other.x) && is_same(key, positions_[i].key);
    });
    if (here == positions_.size()) {
        positions_.push_back({key, cut_corner | static_cast<std::uint32_t>(points_.size())});
        points_.push_back(at);
        key_of_point_.push_back(key);
    }
    return keys_[number].corner = positions_[here].corner;
}

void CutCorners::unscaled(std::uint32_t corner, double (&x)[3]) {
    const std::uint32_t i = corner & ~cut_corner;
    if (unscale(points_[i].x, mesh_.scale, x)) return;
    set_planes(key_of_point_[i]);
    half_spaces_.nearest_corner(0, 1, 2, mesh_.scale, x);
}

}  // namespace mgdt
