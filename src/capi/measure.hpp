// SPDX-License-Identifier: MIT
// The measures of cells, as the C interface names them.
#pragma once

#include "capi/guard.hpp"
#include "dual/cell_measures.hpp"

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

}  // namespace mgdt
