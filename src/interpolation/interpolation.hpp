// SPDX-License-Identifier: MIT
// Interpolated values and weights at many places, and gradients at all points, computed by all
// threads of a team. Places are finite points, stored one after the other in the caller's scale.
// Values are stored in the order of the caller's indices.
#pragma once

#include "interpolation/interpolator.hpp"
#include "query/locate_points.hpp"

namespace mgdt {

// The values at the points: `fields` numbers for each point.
struct Values {
    std::size_t fields;
    const double* of(std::uint32_t index) const noexcept { return data + fields * index; }
    const double* data;
};

struct Manner {
    Method method;
    Outside outside;
};

// Writes the interpolated values at the places, or NaN for a place without a value.
void interpolate(const MeshView& view, const Locator& where, Manner manner, const Values& values,
                 const PointSet& places, StageProgress& progress, double* out);

// The output of interpolation_weights(), which writes the weights of the points as one row per
// place. Row i is from offsets[i] to before offsets[i + 1]; the index base is added to offsets and
// indices. The function always writes the offsets, but all rows only if `capacity` is enough for
// all. The function returns the capacity that is needed.
template <class Int>
struct WeightRows {
    Int* offsets;
    std::size_t capacity;
    Int* points;
    double* weights;
};
template <class Int>
std::size_t interpolation_weights(const MeshView& view, const Locator& where, Manner manner,
                                  const PointSet& places, const StageProgress& progress,
                                  const WeightRows<Int>& rows);

// Writes the gradient, three numbers, for each field of each point. A gradient is NaN for a point
// that is not in the triangulation.
void gradients(const MeshView& view, const Locator& where, const Buffer<VertexId>& point_map,
               const Values& values, StageProgress& progress, double* out);

}  // namespace mgdt
