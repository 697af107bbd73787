// SPDX-License-Identifier: MIT
// The stages of the predicates, for tests and measurements. Each returns the result of the
// predicate or `undecided`. The stages whose names end in _integer, perturbed_by_parts() and
// perturbed_integers() always decide.
#pragma once

#include "predicates/filter.hpp"
#include "predicates/ranged.hpp"

namespace mgdt::exact {

int orientation_filter(const double* a, const double* b, const double* c, const double* d,
                       const Bound& bound = orientation_bound);
int orientation_lattice(const double* a, const double* b, const double* c, const double* d);
int orientation_native(const double* a, const double* b, const double* c, const double* d);
// The number of terms that a sparse stage accepts in each difference.
enum class Terms { single, any };
constexpr int sparse_least = 512;  // bits; below this, plain integers are as fast
// The stage of sparse integers. It is undecided if the differences span fewer than `least` bits.
MGDT_PREDICATES_APART int orientation_sparse(const double* a, const double* b, const double* c,
                                             const double* d, Terms terms = Terms::any,
                                             int least = sparse_least);
MGDT_PREDICATES_APART int orientation_scaled(const double* a, const double* b, const double* c,
                                             const double* d,
                                             const Bound& bound = orientation_bound);
MGDT_PREDICATES_APART int orientation_ranged(const double* a, const double* b, const double* c,
                                             const double* d,
                                             double bound = ranged_orientation_bound);
// The stage of integers. It uses the smallest of `widths` that fits and is at least least_width.
MGDT_PREDICATES_APART int orientation_integer(const double* a, const double* b, const double* c,
                                              const double* d, int least_width = 0);

int sphere_filter(const double* a, const double* b, const double* c, const double* d,
                  const double* q, const Bound& bound = sphere_bound);
int sphere_lattice(const double* a, const double* b, const double* c, const double* d,
                   const double* q);
int sphere_native(const double* a, const double* b, const double* c, const double* d,
                  const double* q);
// In a tie, sphere_sparse() also writes the signs of the 3 x 3 minors [bcd], [acd], [abd], [abc] to
// minor_signs, unless this is null.
MGDT_PREDICATES_APART int sphere_sparse(const double* a, const double* b, const double* c,
                                        const double* d, const double* q, Terms terms = Terms::any,
                                        int minor_signs[4] = nullptr, int least = sparse_least);
MGDT_PREDICATES_APART int sphere_scaled(const double* a, const double* b, const double* c,
                                        const double* d, const double* q,
                                        const Bound& bound = sphere_bound);
MGDT_PREDICATES_APART int sphere_ranged(const double* a, const double* b, const double* c,
                                        const double* d, const double* q,
                                        double bound = ranged_sphere_bound);
MGDT_PREDICATES_APART int sphere_integer(const double* a, const double* b, const double* c,
                                         const double* d, const double* q, int least_width = 0);

// +1 if the points are certainly not collinear, otherwise `undecided`.
int collinear_filter(const double* a, const double* b, const double* c,
                     const Bound& bound = collinear_bound);
// 1 if the points are certainly not collinear, 0 if they certainly are, otherwise `undecided`.
MGDT_PREDICATES_APART int collinear_ranged(const double* a, const double* b, const double* c,
                                           double bound = collinear_bound.relative);
MGDT_PREDICATES_APART bool collinear_integer(const double* a, const double* b, const double* c,
                                             int least_width = 0);

int lengths_filter(const double* a, const double* b, const double* c, const double* d,
                   const Bound& bound = distance_bound);
MGDT_PREDICATES_APART int lengths_integer(const double* a, const double* b, const double* c,
                                          const double* d, int least_width = 0);
int diametral_filter(const double* a, const double* b, const double* q,
                     const Bound& bound = distance_bound);
MGDT_PREDICATES_APART int diametral_integer(const double* a, const double* b, const double* q,
                                            int least_width = 0);

int edge_filter(const double* a, const double* b, const double* c, const double* q,
                const Bound& bound = edge_bound);
MGDT_PREDICATES_APART int edge_integer(const double* a, const double* b, const double* c,
                                       const double* q, int least_width = 0);

// The stages of the perturbed sphere predicate: the determinant in doubles; native integers; sparse
// integers; sphere_integer() and orientation(). perturbed_integers() tries all but the first in
// turn, and filters in between.
int perturbed_doubles(const double* a, const double* b, const double* c, const double* d,
                      const double* q);
int perturbed_native(const double* a, const double* b, const double* c, const double* d,
                     const double* q);
int perturbed_sparse(const double* a, const double* b, const double* c, const double* d,
                     const double* q, Terms terms);
int perturbed_by_parts(const double* a, const double* b, const double* c, const double* d,
                       const double* q);
int perturbed_integers(const double* a, const double* b, const double* c, const double* d,
                       const double* q);

int distance_filter(const double* q, const double* a, const double* b,
                    const Bound& bound = distance_bound);
MGDT_PREDICATES_APART int distance_ranged(const double* q, const double* a, const double* b,
                                          double bound = distance_bound.relative);
MGDT_PREDICATES_APART int distance_integer(const double* q, const double* a, const double* b,
                                           int least_width = 0);

}  // namespace mgdt::exact
