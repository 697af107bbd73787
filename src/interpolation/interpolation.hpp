// SPDX-License-Identifier: MIT
// Values and weights at many places, and gradients at all points, computed by threads. Places are
// finite points, stored one after the other, and have their own scale. Values are by the caller's
// index.
#pragma once

#include "interpolation/interpolator.hpp"
#include "query/locate_points.hpp"

namespace mgdt {

// Values at points: `fields` numbers for each.
struct Values {
    std::size_t fields;
    const double* of(std::uint32_t index) const noexcept { return data + fields * index; }
    const double* data;
};

struct Manner {
    Method method;
    Outside outside;
};

// Writes the values at the places; NaN for a place without a value.
void interpolate(const ExportView& view, const Locator& where, Manner manner, const Values& values,
                 const PointSet& places, double* out);

// Writes the weights of the points as one row per place. Row i is from offsets[i] to before
// offsets[i + 1]; the index base is added to offsets and indices. Writes the offsets, and the rows
// if there is room for all. Returns the room that is needed.
template <class Int>
struct WeightRows {
    Int* offsets;
    std::size_t capacity;
    Int* points;
    double* weights;
};
template <class Int>
std::size_t interpolation_weights(const ExportView& view, const Locator& where, Manner manner,
                                  const PointSet& places, const WeightRows<Int>& rows);

// Writes three numbers for each field of each point; NaN for a point that is not in.
void gradients(const ExportView& view, const Locator& where, const Buffer<VertexId>& point_map,
               const Values& values, double* out);

}  // namespace mgdt
