// SPDX-License-Identifier: MIT
// The insertion of a caller's points: checked, scaled, and inserted as a batch, or held as long as
// all points together do not span space.
#pragma once

#include "core/batch.hpp"
#include "core/state.hpp"

namespace mgdt {

// Inserts n points, coordinate k of point i at axis[k][i * stride]. Throws Error and std::bad_alloc
// as mgdt_insert_points() documents.
void insert_points(State& state, std::size_t n, const double* const axis[3], std::ptrdiff_t stride);

// The scale for all points, if the exponents of n new ones are in the point table already.
int scale_for(const State& state, std::size_t n, const double* const axis[3],
              std::ptrdiff_t stride);
// The number of the batch's first points that `basis` needs to span space: all of them if they do
// not. `basis` takes them in.
std::size_t points_to_span_space(const Batch& batch, AffineBasis& basis);
// Holds points that do not span space with those before; `basis` is of all of them.
void hold(State& state, const Batch& batch, const AffineBasis& basis);

}  // namespace mgdt
