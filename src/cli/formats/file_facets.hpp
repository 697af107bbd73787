// SPDX-License-Identifier: MIT
// The boundary of a domain in a file: polygons, segments, and places of holes and regions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cli/formats/marked_faces.hpp"

namespace mgdt::cli {

struct FileFacets {
    struct Place {
        std::array<double, 3> x;
        std::int32_t marker;
    };

    // The corners of facet i are corners[begin[i]] to corners[begin[i + 1] - 1].
    std::vector<std::int64_t> begin = {0}, corners;
    std::vector<std::int32_t> markers;   // of each facet
    MarkerNames names;                   // of markers; or none
    std::vector<std::int64_t> segments;  // 2 points for each
    std::vector<Place> holes, regions;

    std::size_t size() const { return markers.size(); }
    void add_facet(const std::int64_t* points, std::size_t count, std::int32_t marker = 0) {
        corners.insert(corners.end(), points, points + count);
        end_facet(marker);
    }
    void add_segment(const std::int64_t* ends) { segments.insert(segments.end(), ends, ends + 2); }
    // Ends a facet whose corners were appended.
    void end_facet(std::int32_t marker = 0) {
        begin.push_back(static_cast<std::int64_t>(corners.size()));
        markers.push_back(marker);
    }
};

}  // namespace mgdt::cli
