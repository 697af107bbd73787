// SPDX-License-Identifier: MIT
// Triangles with the same corners are taken once.
#pragma once

#include "cleaning/surface_pieces.hpp"

namespace mgdt {

// A facet that is covered, or a part of it is, by another facet that stays in its place.
struct CoveredFacet {
    std::uint32_t facet, by;

    friend bool operator<(const CoveredFacet& a, const CoveredFacet& b) {
        return a.facet != b.facet ? a.facet < b.facet : a.by < b.by;
    }
    friend bool operator==(const CoveredFacet& a, const CoveredFacet& b) {
        return a.facet == b.facet && a.by == b.by;
    }
};

// Of several triangles with the same corners, keeps the one of the smallest facet. So a facet that
// marks a part of a larger one keeps its marker. If facets are equally large, the triangle of the
// first facet stays. Appends the facets that lose triangles to `covered`, and marks them in
// `is_changed`. Returns whether there are any.
bool remove_equal_triangles(SurfacePieces& pieces, const Buffer<double>& facet_areas,
                            Buffer<CoveredFacet>& covered, Buffer<std::uint8_t>& is_changed,
                            Allocator& allocator);

}  // namespace mgdt
