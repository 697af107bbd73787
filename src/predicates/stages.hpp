// SPDX-License-Identifier: MIT
// The stages that the predicates are made of, one by one: for tests and measurements. Each gives
// the predicate's sign; filters, lattice stages and those of native integers may answer
// `undecided`.
#pragma once

#include "filter.hpp"

namespace mgdt::exact {

int orientation_filter(const double* a, const double* b, const double* c, const double* d,
                       const Bound& bound = orientation_bound);
int orientation_lattice(const double* a, const double* b, const double* c, const double* d);
int orientation_whole(const double* a, const double* b, const double* c, const double* d);
// Integers of the least of `widths` that fits and is at least least_width.
MGDT_PREDICATES_APART int orientation_integer(const double* a, const double* b, const double* c,
                                              const double* d, int least_width = 0);

int sphere_filter(const double* a, const double* b, const double* c, const double* d,
                  const double* q, const Bound& bound = sphere_bound);
int sphere_lattice(const double* a, const double* b, const double* c, const double* d,
                   const double* q);
int sphere_whole(const double* a, const double* b, const double* c, const double* d,
                 const double* q);
MGDT_PREDICATES_APART int sphere_integer(const double* a, const double* b, const double* c,
                                         const double* d, const double* q, int least_width = 0);

// +1: surely not collinear.
int collinear_filter(const double* a, const double* b, const double* c,
                     const Bound& bound = collinear_bound);
MGDT_PREDICATES_APART bool collinear_integer(const double* a, const double* b, const double* c,
                                             int least_width = 0);

// The perturbed side of a sphere: by the determinant in doubles; by integers of 64 bits; by the
// predicates that it is made of; by the first of the last two that can.
int perturbed_doubles(const double* a, const double* b, const double* c, const double* d,
                      const double* q);
int perturbed_whole(const double* a, const double* b, const double* c, const double* d,
                    const double* q);
int perturbed_by_parts(const double* a, const double* b, const double* c, const double* d,
                       const double* q);
int perturbed_integers(const double* a, const double* b, const double* c, const double* d,
                       const double* q);

int distance_filter(const double* q, const double* a, const double* b,
                    const Bound& bound = distance_bound);
MGDT_PREDICATES_APART int distance_integer(const double* q, const double* a, const double* b,
                                           int least_width = 0);

}  // namespace mgdt::exact
