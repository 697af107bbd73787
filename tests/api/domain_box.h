/* SPDX-License-Identifier: MIT
 * A box with a triangle in it, as a domain, and what tests of domains ask of one. */
#ifndef MGDT_TESTS_DOMAIN_BOX_H
#define MGDT_TESTS_DOMAIN_BOX_H

#include <math.h>
#include <mgdt/mgdt_domain.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

/* A cube of size 4, the ends of a triangle inside of it, and points on both sides of the triangle,
 * which are nearer to each other than its corners. */
static const double box[13 * 3] = {0, 0, 0, 4, 0, 0, 0, 4, 0,   4,   4, 0,   0,
                                   0, 4, 4, 0, 4, 0, 4, 4, 4,   4,   4, 1,   1,
                                   2, 3, 1, 2, 2, 3, 2, 2, 1.7, 2.1, 2, 1.7, 1.9};
static const int64_t quads[6 * 4] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                     2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
static const int64_t offsets[8] = {0, 4, 8, 12, 16, 20, 24, 27};
static const int32_t markers[7] = {1, 2, 3, 4, 5, 6, -7};

static inline int check_message(const mgdt_domain* d, const char* text) {
    char message[256] = "";
    CHECK_EQUAL(mgdt_domain_get_error(d, sizeof message, message), MGDT_OK);
    if (strstr(message, text) == NULL) printf("the message is: %s\n", message);
    return CHECK(strstr(message, text) != NULL);
}

static inline int64_t stat_of(const mgdt_domain* d, int32_t key) {
    int64_t value = -1;
    CHECK_EQUAL(mgdt_domain_get_stat(d, key, &value), MGDT_OK);
    return value;
}

static inline int64_t size_of(const mgdt_domain* d, int32_t array) {
    int64_t size = -1;
    CHECK_EQUAL(mgdt_domain_get_size(d, array, &size), MGDT_OK);
    return size;
}

static inline int64_t mesh_stat(const mgdt_mesh* m, int32_t key) {
    int64_t value = -1;
    CHECK_EQUAL(mgdt_mesh_get_stat(m, key, &value), MGDT_OK);
    return value;
}

static inline int64_t mesh_size(const mgdt_mesh* m, int32_t array) {
    int64_t size = -1;
    CHECK_EQUAL(mgdt_mesh_get_size(m, array, &size), MGDT_OK);
    return size;
}

static inline int64_t* array_of(const mgdt_mesh* m, int32_t array) {
    const int64_t size = mesh_size(m, array);
    int64_t* const values = malloc((size_t)(size + 1) * sizeof *values);
    int32_t* const narrow = malloc((size_t)(size + 1) * sizeof *narrow);
    int64_t i;
    values[size] = narrow[size] = -77;
    CHECK_EQUAL(mgdt_mesh_get_array(m, array, size, values), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_get_array_i32(m, array, size, narrow), MGDT_OK);
    for (i = 0; i <= size; ++i) CHECK_EQUAL(values[i], narrow[i]);
    CHECK_EQUAL(values[size], -77);
    free(narrow);
    return values;
}

static inline double* points_of(const mgdt_mesh* m) {
    const int64_t size = mesh_size(m, MGDT_MESH_ARRAY_POINTS);
    double* const xyz = malloc((size_t)(size + 1) * sizeof *xyz);
    xyz[size] = -77;
    CHECK_EQUAL(mgdt_mesh_get_doubles(m, MGDT_MESH_ARRAY_POINTS, size, xyz), MGDT_OK);
    CHECK(xyz[size] == -77);
    return xyz;
}

/* Builds, and keeps no mesh. Without success there is none. */
static inline mgdt_status build(mgdt_domain* d) {
    mgdt_mesh* m = (mgdt_mesh*)d;
    const mgdt_status status = mgdt_domain_build(d, &m);
    CHECK((status == MGDT_OK) == (m != NULL));
    mgdt_mesh_destroy(m);
    return status;
}

/* Builds, and checks the mesh. */
static inline mgdt_mesh* mesh_of(mgdt_domain* d) {
    mgdt_mesh* m = NULL;
    CHECK_EQUAL(mgdt_domain_build(d, &m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_OK);
    return m;
}

static inline mgdt_status give_box(mgdt_domain* d, int64_t base) {
    int64_t corners[27], begin[8], segment[2];
    mgdt_status status;
    int i;
    for (i = 0; i < 24; ++i) corners[i] = quads[i] + base;
    for (i = 0; i < 3; ++i) corners[24 + i] = 8 + i + base;
    for (i = 0; i < 8; ++i) begin[i] = offsets[i] + base;
    segment[0] = base;
    segment[1] = 8 + base;
    status = mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_INDEX_BASE, base);
    if (status == MGDT_OK) status = mgdt_domain_set_points(d, 13, box);
    if (status == MGDT_OK) status = mgdt_domain_set_facets(d, 7, begin, corners, markers);
    if (status == MGDT_OK) status = mgdt_domain_set_segments(d, 1, segment, NULL);
    return status;
}

static inline mgdt_domain* make_box(int64_t base) {
    mgdt_domain* d = NULL;
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    CHECK_EQUAL(give_box(d, base), MGDT_OK);
    return d;
}

/* Six times the volume of all tetrahedra. */
static inline double volume_of(const mgdt_mesh* m, int64_t base) {
    int64_t* const v = array_of(m, MGDT_MESH_ARRAY_TETRAHEDRA);
    double* const xyz = points_of(m);
    const int64_t n = mesh_size(m, MGDT_MESH_ARRAY_TETRAHEDRA);
    double sum = 0;
    int64_t i;
    for (i = 0; i < n; i += 4) {
        const double part = volume(xyz + 3 * (v[i] - base), xyz + 3 * (v[i + 1] - base),
                                   xyz + 3 * (v[i + 2] - base), xyz + 3 * (v[i + 3] - base));
        CHECK(part > 0);
        sum += part;
    }
    free(v);
    free(xyz);
    return sum;
}

#endif
