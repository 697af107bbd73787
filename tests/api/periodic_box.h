/* SPDX-License-Identifier: MIT
 * Periodic boxes for tests, and what tests ask of one. */
#ifndef MGDT_TESTS_PERIODIC_BOX_H
#define MGDT_TESTS_PERIODIC_BOX_H

#include <mgdt/mgdt_periodic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

static const double cube[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
static const double oblique[9] = {4, 0, 0, 1.5, 3, 0, -0.75, 0.5, 2.5};

static inline int says(const mgdt_periodic* p, const char* text) {
    char message[256] = "";
    const int found = mgdt_periodic_get_error(p, (int64_t)sizeof message, message) == MGDT_OK &&
                      strstr(message, text) != NULL;
    if (!found) fprintf(stderr, "no \"%s\" in the message \"%s\"\n", text, message);
    return found;
}

static inline int64_t stat_of(const mgdt_periodic* p, int32_t key) {
    int64_t value = -1;
    CHECK_EQUAL(mgdt_periodic_get_stat(p, key, &value), MGDT_OK);
    return value;
}

static inline int64_t size_of(const mgdt_periodic* p, int32_t array) {
    int64_t size = -1;
    CHECK_EQUAL(mgdt_periodic_get_size(p, array, &size), MGDT_OK);
    return size;
}

/* A box of these vectors, without points. */
static inline mgdt_status new_box(int32_t dimensions, const double* vectors, mgdt_periodic** out) {
    mgdt_status s = mgdt_periodic_create(out);
    return s == MGDT_OK ? mgdt_periodic_set_vectors(*out, dimensions, vectors) : s;
}

/* A box with n random points, some of them outside, that has been built. */
static inline mgdt_periodic* make_periodic(int32_t dimensions, const double* vectors, int64_t n) {
    mgdt_periodic* p = NULL;
    double* const xyz = random_points(n, 0, 5);
    int64_t i;
    for (i = 0; i < 3 * n; ++i) xyz[i] = 4 * xyz[i] - 1;
    CHECK_EQUAL(new_box(dimensions, vectors, &p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, n, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
    free(xyz);
    return p;
}

/* Without a triangulation nothing is written. */
static inline void no_results(const mgdt_periodic* p) {
    static const int32_t integers[] = {MGDT_PERIODIC_ARRAY_POINT_MAP,
                                       MGDT_PERIODIC_ARRAY_POINT_SHIFTS,
                                       MGDT_PERIODIC_ARRAY_TETRAHEDRA,
                                       MGDT_PERIODIC_ARRAY_TETRAHEDRON_SHIFTS,
                                       MGDT_PERIODIC_ARRAY_NEIGHBORS,
                                       MGDT_PERIODIC_ARRAY_NEIGHBOR_SHIFTS,
                                       MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_OFFSETS,
                                       MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS,
                                       MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_SHIFTS};
    int64_t wide[100] = {-99}, size = -99;
    int32_t narrow[100] = {-99};
    double x[100] = {-99};
    mgdt_voronoi* v = NULL;
    size_t i;
    for (i = 0; i < sizeof integers / sizeof *integers; ++i) {
        CHECK_EQUAL(mgdt_periodic_get_size(p, integers[i], &size), MGDT_ERR_NOT_BUILT);
        CHECK_EQUAL(mgdt_periodic_get_array(p, integers[i], 100, wide), MGDT_ERR_NOT_BUILT);
        CHECK_EQUAL(mgdt_periodic_get_array_i32(p, integers[i], 100, narrow), MGDT_ERR_NOT_BUILT);
    }
    CHECK_EQUAL(mgdt_periodic_get_doubles(p, MGDT_PERIODIC_ARRAY_POINTS, 100, x),
                MGDT_ERR_NOT_BUILT);
    CHECK_EQUAL(mgdt_periodic_get_doubles(p, MGDT_PERIODIC_ARRAY_VECTORS, 100, x),
                MGDT_ERR_NOT_BUILT);
    CHECK_EQUAL(mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_VOLUME, 100, x),
                MGDT_ERR_NOT_BUILT);
    CHECK_EQUAL(mgdt_periodic_create_voronoi(p, &v), MGDT_ERR_NOT_BUILT);
    CHECK_EQUAL(mgdt_periodic_check(p), MGDT_ERR_NOT_BUILT);
    CHECK(says(p, "there is no triangulation"));
    CHECK(size == -99 && wide[0] == -99 && narrow[0] == -99 && x[0] == -99 && v == NULL);
}

#endif
