/* SPDX-License-Identifier: MIT
 * What the tests of the interface share: a macro that counts, and a few helpers. */
#ifndef MGDT_TESTS_API_CHECK_H
#define MGDT_TESTS_API_CHECK_H

#include <mgdt/mgdt.h>
#include <stddef.h>
#include <stdint.h>

#include "../support/small.h"

/* Counts; on failure prints the expression and where it stands, and goes on. Gives the outcome. */
#define CHECK(condition) check_that((condition) ? 1 : 0, #condition, __FILE__, __LINE__)
/* The same for two integers, which a failure prints. */
#define CHECK_EQUAL(a, b) check_equal((int64_t)(a), (int64_t)(b), #a " == " #b, __FILE__, __LINE__)
/* The message of the last failure contains the text. */
#define CHECK_ERROR(t, text) check_error((t), (text), __FILE__, __LINE__)

int check_that(int condition, const char* what, const char* file, int line);
int check_equal(int64_t a, int64_t b, const char* what, const char* file, int line);
int check_error(const mgdt_triangulation* t, const char* text, const char* file, int line);

/* Uniform in [0, 1), from a generator of our own: the same on every machine. */
double random_double(uint64_t* state);
/* n random points; every coordinate is rounded to a multiple of 1/grid unless grid is 0. */
double* random_points(int64_t n, int grid, uint64_t seed);

/* A handle that holds the points, or NULL after a counted failure. */
mgdt_triangulation* make(int64_t n, const double* xyz);

/* Exported arrays; the caller frees them. NULL after a counted failure. */
typedef mgdt_status (*get_fn)(const mgdt_triangulation*, int64_t, int64_t*);
int64_t* get_array(get_fn get, const mgdt_triangulation* t, int64_t size);

/* Sorts the vertices of each tetrahedron, then the tetrahedra. */
void sort_tetrahedra(int64_t* v, int64_t count);
/* Whether t holds the tetrahedra of `expected`. Point i of t is point origin[i] of `expected`, or
 * without origins i modulo the number of its points: the same points given again and again. */
int same_tetrahedra(const mgdt_triangulation* t, const mgdt_triangulation* expected,
                    const int64_t* origin);

/* Six times the signed volume, rounded: for points whose orientation is not in doubt. */
double volume(const double* a, const double* b, const double* c, const double* d);

void test_text(void);
void test_arguments(void);
void test_settings(void);
void test_insertion(void);
void test_export(void);
void test_queries(void);
void test_changes(void);
void test_cells(void);
void test_voronoi(void);
void test_cleaning(void);
void test_domain(void);
void test_domain_limits(void);
void test_mesh(void);
void test_given_mesh(void);
void test_improvement(void);
void test_refinement(void);
void test_dual(void);
void test_memory(void);
void test_parts(void);
void test_periodic(void);
void test_periodic_limits(void);
void test_progress(void);
void test_long_calls(void);
void test_environment(void);
void test_interpolation(void);
void test_isa(void);
void test_compact(void);
void test_busy(void);

#endif
