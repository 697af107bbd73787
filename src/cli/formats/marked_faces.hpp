// SPDX-License-Identifier: MIT
// Faces of a mesh that are parts of facets, and the groups that equal markers make.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace mgdt::cli {

// Names that a file gives to markers of facets.
using MarkerNames = std::map<std::int32_t, std::string>;

struct MarkedFaces {
    std::vector<std::int32_t> corners;  // 3 points of each face
    std::vector<std::int32_t> markers;
    // For each face a tetrahedron t and the corner k of it that is opposite, as 4 t + k. Of two
    // tetrahedra it is the one that the face's normal points away from.
    std::vector<std::uint32_t> sides;
    MarkerNames names;

    std::size_t size() const { return markers.size(); }
};

// What has equal markers, in ascending order of the markers.
struct MarkerGroup {
    std::int32_t marker;
    std::vector<std::size_t> members;  // in ascending order
};

inline std::vector<MarkerGroup> groups_of(const std::vector<std::int32_t>& markers) {
    std::map<std::int32_t, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < markers.size(); ++i) members[markers[i]].push_back(i);
    std::vector<MarkerGroup> groups;
    groups.reserve(members.size());
    for (auto& [marker, of] : members) groups.push_back({marker, std::move(of)});
    return groups;
}

inline bool has_marker(const std::vector<std::int32_t>& markers) {
    return std::any_of(markers.begin(), markers.end(), [](std::int32_t m) { return m != 0; });
}

}  // namespace mgdt::cli
