// SPDX-License-Identifier: MIT
// Values and weights for many places, and gradients for all points, in threads. Places are finite,
// lie one behind the other and have their own scale; values are by the caller's index.
#pragma once

#include "interpolation/interpolator.hpp"
#include "query/locate_points.hpp"

namespace mgdt {

// `fields` numbers for each point.
struct Values {
    std::size_t fields;
    const double* of(std::uint32_t index) const noexcept { return data + fields * index; }
    const double* data;
};

struct Manner {
    Method method;
    Outside outside;
};

// NaN where there is no value.
void interpolate(const ExportView& view, const Locator& where, Manner manner, const Values& values,
                 const PointSet& places, double* out);

// Rows of weights of points: weights of place i are from offsets[i] to before offsets[i + 1], with
// the base in each offset and index. Writes the offsets, and the rows if there is room for all;
// returns how much is needed.
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

// Three numbers for each field of each point: NaN for a point that is not in.
void gradients(const ExportView& view, const Locator& where, const Buffer<VertexId>& point_map,
               const Values& values, double* out);

}  // namespace mgdt
