/* SPDX-License-Identifier: MIT
 * Ways to give points: strides, repeats, flat sets that become solid, batches, clear, reserve. */
#include <stdlib.h>
#include <string.h>

#include "check.h"

static void strides(void) {
    const int64_t n = 500;
    double *xyz = random_points(n, 16, 21), *apart = malloc((size_t)(3 * n) * sizeof *apart),
           *back = malloc((size_t)(3 * n) * sizeof *back),
           *records = malloc((size_t)(5 * n) * sizeof *records);
    mgdt_triangulation *expected = make(n, xyz), *t = NULL;
    int64_t i;
    int k;
    for (i = 0; i < n; ++i)
        for (k = 0; k < 3; ++k) {
            apart[k * n + i] = xyz[3 * i + k];
            back[k * n + (n - 1 - i)] = xyz[3 * i + k];
            records[5 * i + k] = xyz[3 * i + k];
        }
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points_strided(t, n, apart, apart + n, apart + 2 * n, 1), MGDT_OK);
    CHECK(same_tetrahedra(t, expected, NULL));
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points_strided(t, n, xyz, xyz + 1, xyz + 2, 3), MGDT_OK);
    CHECK(same_tetrahedra(t, expected, NULL));
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points_strided(t, n, records, records + 1, records + 2, 5), MGDT_OK);
    CHECK(same_tetrahedra(t, expected, NULL));
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    CHECK_EQUAL(
        mgdt_insert_points_strided(t, n, back + n - 1, back + 2 * n - 1, back + 3 * n - 1, -1),
        MGDT_OK);
    CHECK(same_tetrahedra(t, expected, NULL));
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    /* The same point again and again. */
    CHECK_EQUAL(mgdt_insert_points_strided(t, n, xyz, xyz + 1, xyz + 2, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_point_count(t), n);
    CHECK_EQUAL(mgdt_vertex_count(t), 1);
    mgdt_destroy(t);
    mgdt_destroy(expected);
    free(xyz);
    free(apart);
    free(back);
    free(records);
}

/* Points stay the caller's: neither changed, nor read again after the call. */
static void copies(void) {
    const int64_t n = 300;
    double *xyz = random_points(n, 0, 22), *kept = random_points(n, 0, 22);
    mgdt_triangulation *t = make(n, xyz), *expected = make(n, kept);
    int64_t i;
    CHECK(memcmp(xyz, kept, (size_t)(3 * n) * sizeof *xyz) == 0);
    for (i = 0; i < 3 * n; ++i) xyz[i] = 0.5;
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, 1, kept), MGDT_OK);
    CHECK(same_tetrahedra(t, expected, NULL));
    mgdt_destroy(t);
    mgdt_destroy(expected);
    free(xyz);
    free(kept);
}

static void duplicates(void) {
    static const double xyz[] = {1, 0, 0, 0, 0, 0,    0, 0, 1,    -0.0, 0,    -0.0, 0,   1,
                                 0, 0, 0, 1, 0, -0.0, 1, 1, -0.0, 0,    0.25, 0.25, 0.25};
    static const int64_t expected[] = {0, 1, 2, 1, 4, 2, 2, 0, 8};
    int64_t map[9], i, first;
    /* Every split in two batches. */
    for (first = 0; first <= 9; ++first) {
        mgdt_triangulation* t = make(first, xyz);
        CHECK_EQUAL(mgdt_insert_points(t, 9 - first, xyz + 3 * first), MGDT_OK);
        CHECK_EQUAL(mgdt_point_count(t), 9);
        CHECK_EQUAL(mgdt_vertex_count(t), 5);
        CHECK_EQUAL(mgdt_tetrahedron_count(t), 4);
        CHECK_EQUAL(mgdt_get_point_map(t, 9, map), MGDT_OK);
        for (i = 0; i < 9; ++i) CHECK_EQUAL(map[i], expected[i]);
        CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
        mgdt_destroy(t);
    }
}

/* Dimension by dimension, a point (and a repeat) at a time. */
static void flat(void) {
    static const double xyz[] = {2, 2, 2, 2, 2, 2, 3, 3, 3, 5, 5, 5, 3, 3, 3,
                                 2, 3, 4, 7, 8, 9, 2, 2, 2, 0, 0, 1, 4, 4, 4};
    static const int32_t dimension[] = {0, 0, 1, 1, 1, 2, 2, 2, 3, 3};
    static const int64_t vertices[] = {1, 1, 2, 3, 3, 4, 5, 5, 6, 7};
    mgdt_triangulation *t = NULL, *whole = make(10, xyz);
    int64_t k, map[10], out = 5;
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    for (k = 0; k < 10; ++k) {
        CHECK_EQUAL(mgdt_insert_points(t, 1, xyz + 3 * k), MGDT_OK);
        CHECK_EQUAL(mgdt_dimension(t), dimension[k]);
        CHECK_EQUAL(mgdt_point_count(t), k + 1);
        CHECK_EQUAL(mgdt_vertex_count(t), vertices[k]);
        CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
        CHECK_EQUAL(mgdt_get_point_map(t, k + 1, map), MGDT_OK);
        CHECK_EQUAL(map[0], 0);
        if (k >= 1) CHECK_EQUAL(map[1], 0);
        if (k >= 4) CHECK_EQUAL(map[4], 2);
        if (k >= 7) CHECK_EQUAL(map[7], 0);
        if (dimension[k] < 3) {
            CHECK_EQUAL(mgdt_tetrahedron_count(t), 0);
            CHECK_EQUAL(mgdt_hull_facet_count(t), 0);
            CHECK_EQUAL(mgdt_edge_count(t), 0);
            CHECK_EQUAL(mgdt_get_tetrahedra(t, 0, NULL), MGDT_OK);
            CHECK_EQUAL(mgdt_locate(t, xyz, &out), MGDT_OK);
            CHECK_EQUAL(out, -1);
        } else {
            CHECK(mgdt_tetrahedron_count(t) > 0);
        }
    }
    CHECK(same_tetrahedra(t, whole, NULL));
    mgdt_destroy(t);
    mgdt_destroy(whole);
}

/* Large flat sets, then one point off the plane. */
static void flat_then_solid(void) {
    const int64_t n = is_small() ? 100 : 2000;
    double* xyz = random_points(n, 32, 23);
    const double top[3] = {0.5, 0.5, 3};
    mgdt_triangulation *t, *late;
    int64_t i;
    int lines;
    for (lines = 0; lines < 2; ++lines) {
        for (i = 0; i < n; ++i) {
            if (lines) xyz[3 * i + 1] = 2 * xyz[3 * i];
            xyz[3 * i + 2] = 0;
        }
        t = make(n, xyz);
        CHECK_EQUAL(mgdt_dimension(t), lines ? 1 : 2);
        CHECK_EQUAL(mgdt_tetrahedron_count(t), 0);
        CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
        CHECK_EQUAL(mgdt_insert_points(t, 1, top), MGDT_OK);
        CHECK_EQUAL(mgdt_dimension(t), lines ? 2 : 3);
        CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
        if (!lines) {
            /* The apex first: n + 1 points whose order is another, hence the shifted indices. */
            late = make(1, top);
            CHECK_EQUAL(mgdt_insert_points(late, n, xyz), MGDT_OK);
            CHECK_EQUAL(mgdt_tetrahedron_count(late), mgdt_tetrahedron_count(t));
            CHECK_EQUAL(mgdt_hull_facet_count(late), mgdt_hull_facet_count(t));
            CHECK_EQUAL(mgdt_check(late, MGDT_CHECK_CANONICAL), MGDT_OK);
            mgdt_destroy(late);
        }
        mgdt_destroy(t);
    }
    free(xyz);
}

static void batches(void) {
    const int64_t n = is_small() ? 120 : 1500;
    static const int64_t counts[] = {2, 7, 40};
    double* xyz = random_points(n, 10, 24);
    mgdt_triangulation* expected = make(n, xyz);
    size_t c;
    int64_t k;
    for (c = 0; c < 3; ++c) {
        mgdt_triangulation* t = NULL;
        CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
        for (k = 0; k < counts[c]; ++k) {
            const int64_t from = n * k / counts[c], to = n * (k + 1) / counts[c];
            CHECK_EQUAL(mgdt_insert_points(t, to - from, xyz + 3 * from), MGDT_OK);
        }
        CHECK(same_tetrahedra(t, expected, NULL));
        mgdt_destroy(t);
    }
    mgdt_destroy(expected);
    free(xyz);
}

static void clear_and_reserve(void) {
    const int64_t n = 600;
    double *xyz = random_points(n, 0, 25), *other = random_points(n, 0, 26);
    mgdt_triangulation *expected = make(n, xyz), *t = NULL;
    int64_t v[4];
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    CHECK_EQUAL(mgdt_set_index_base(t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_scheme(t, MGDT_ORDER_KD_TREE), MGDT_OK);
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    CHECK_EQUAL(mgdt_reserve(t, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_reserve(t, n), MGDT_OK);
    CHECK_EQUAL(mgdt_point_count(t), 0);
    CHECK_EQUAL(mgdt_insert_points(t, n, other), MGDT_OK);
    CHECK_EQUAL(mgdt_reserve(t, 10), MGDT_OK); /* less than there are: nothing to do */
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    CHECK_EQUAL(mgdt_dimension(t), -1);
    CHECK_EQUAL(mgdt_point_count(t), 0);
    CHECK_EQUAL(mgdt_vertex_count(t), 0);
    CHECK_EQUAL(mgdt_tetrahedron_count(t), 0);
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, 4, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_get_tetrahedra(t, 4, v), MGDT_OK);
    CHECK_EQUAL(v[0] + v[1] + v[2] + v[3], 10); /* the index base is a setting: it stays */
    CHECK_EQUAL(mgdt_set_index_base(t, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n - 4, xyz + 12), MGDT_OK);
    CHECK(same_tetrahedra(t, expected, NULL));
    mgdt_destroy(t);
    mgdt_destroy(expected);
    free(xyz);
    free(other);
}

/* Every scheme with parameters far from their defaults. */
static void parameters(void) {
    static const double points[] = {1, 3, 1e6}, thresholds[] = {1, 20, 1e9},
                        ratios[] = {1.01, 2, 1e6};
    const int64_t n = is_small() ? 100 : 1200;
    double* xyz = random_points(n, 20, 27);
    mgdt_triangulation* expected = make(n, xyz);
    int32_t s, scheme = 0;
    int k;
    for (s = 0; mgdt_order_scheme_at(s, &scheme) == MGDT_OK; ++s)
        for (k = 0; k < 3; ++k) {
            mgdt_triangulation* t = NULL;
            CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
            CHECK_EQUAL(mgdt_set_order_scheme(t, scheme), MGDT_OK);
            CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_POINTS_PER_CELL, points[k]),
                        MGDT_OK);
            CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_THRESHOLD, thresholds[k]),
                        MGDT_OK);
            CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_SEPARATION, k % 3), MGDT_OK);
            CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_ROUND_RATIO, ratios[k]),
                        MGDT_OK);
            CHECK_EQUAL(mgdt_set_seed(t, UINT64_MAX - (uint64_t)k), MGDT_OK);
            CHECK_EQUAL(mgdt_set_threads(t, k), MGDT_OK);
            CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
            CHECK(same_tetrahedra(t, expected, NULL));
            mgdt_destroy(t);
        }
    mgdt_destroy(expected);
    free(xyz);
}

void test_insertion(void) {
    strides();
    copies();
    duplicates();
    flat();
    flat_then_solid();
    batches();
    clear_and_reserve();
    parameters();
}
