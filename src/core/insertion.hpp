// SPDX-License-Identifier: MIT
// Inserts a caller's points: checks and scales them, then inserts them as a batch, or holds them as
// long as all points together do not span space.
#pragma once

#include "core/batch.hpp"
#include "core/state.hpp"

namespace mgdt {

// Inserts n points, coordinate k of point i at axis[k][i * stride]. Throws Error and std::bad_alloc
// as mgdt_insert_points() documents.
void insert_points(State& state, std::size_t n, const double* const axis[3], std::ptrdiff_t stride);

// The scale for all points. The point table must include the exponents of the n new points.
int scale_for(const State& state, std::size_t n, const double* const axis[3],
              std::ptrdiff_t stride);
// Adds points of the batch to `basis` until `basis` spans space. Returns the number of points that
// this takes, which is all of them if they do not span space.
std::size_t points_to_span_space(const Batch& batch, AffineBasis& basis);
// Holds the points of a batch that do not span space with the points before. `basis` is a basis of
// all these points.
void hold(State& state, const Batch& batch, const AffineBasis& basis);

}  // namespace mgdt
