// SPDX-License-Identifier: MIT
// The measures of cells and of tetrahedra, as the C interface names them.
#pragma once

#include "capi/guard.hpp"
#include "dual/cell_measures.hpp"
#include "query/tetrahedron_measures.hpp"

namespace mgdt {

inline Measure measure_of(std::int32_t measure) {
    switch (measure) {
        case MGDT_MEASURE_VOLUME:
            return Measure::volume;
        case MGDT_MEASURE_AREA:
            return Measure::area;
        case MGDT_MEASURE_CENTROID:
            return Measure::centroid;
        case MGDT_MEASURE_FACES:
            return Measure::faces;
        default:
            fail(MGDT_ERR_UNKNOWN_KEY, "there is no measure %d", static_cast<int>(measure));
    }
}

inline TetrahedronMeasure tetrahedron_measure_of(std::int32_t measure) {
    switch (measure) {
        case MGDT_TETRAHEDRON_VOLUME:
            return TetrahedronMeasure::volume;
        case MGDT_TETRAHEDRON_RADIUS_RATIO:
            return TetrahedronMeasure::radius_ratio;
        case MGDT_TETRAHEDRON_VOLUME_LENGTH:
            return TetrahedronMeasure::volume_length;
        case MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE:
            return TetrahedronMeasure::least_dihedral_angle;
        case MGDT_TETRAHEDRON_LARGEST_DIHEDRAL_ANGLE:
            return TetrahedronMeasure::largest_dihedral_angle;
        case MGDT_TETRAHEDRON_LONGEST_EDGE:
            return TetrahedronMeasure::longest_edge;
        case MGDT_TETRAHEDRON_EDGE_RATIO:
            return TetrahedronMeasure::edge_ratio;
        default:
            fail(MGDT_ERR_UNKNOWN_KEY, "there is no measure %d of tetrahedra",
                 static_cast<int>(measure));
    }
}

}  // namespace mgdt
