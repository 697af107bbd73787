/* SPDX-License-Identifier: MIT
 * Locating and nearest vertices, against all tetrahedra and all points. Coordinates are small
 * multiples of 1/2, so that doubles hold every volume and distance exactly. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../support/reproduction.h"
#include "check.h"

/* Points 0, 1, ..., 7 an axis; with repeats. */
static double* lattice_points(int64_t n, uint64_t seed) {
    double* xyz = random_points(n, 8, seed);
    int64_t i;
    for (i = 0; i < 3 * n; ++i) xyz[i] *= 8;
    return xyz;
}

/* Multiples of 1/2 from -1 to 8. */
static double* half_points(int64_t n, uint64_t seed) {
    double* xyz = random_points(n, 19, seed);
    int64_t i;
    for (i = 0; i < 3 * n; ++i) xyz[i] = floor(xyz[i] * 19 + 0.5) / 2 - 1;
    return xyz;
}

/* Whether all barycentric coordinates are at least `least`. */
static int contains(const double* xyz, const int64_t* v, const double* q, double least,
                    double* weights) {
    const double* p[4];
    double whole;
    int k, inside = 1;
    for (k = 0; k < 4; ++k) p[k] = xyz + 3 * v[k];
    whole = volume(p[0], p[1], p[2], p[3]);
    for (k = 0; k < 4; ++k) {
        const double* kept = p[k];
        p[k] = q;
        weights[k] = volume(p[0], p[1], p[2], p[3]) / whole;
        inside &= weights[k] >= least;
        p[k] = kept;
    }
    return inside;
}

static void located(int grid) {
    const int64_t n = is_small() ? 60 : 250, q_count = is_small() ? 100 : 1000;
    double *xyz = grid ? lattice_points(n, 41) : random_points(n, 0, 42),
           *queries = grid ? half_points(q_count, 43) : random_points(q_count, 0, 44),
           *weights = malloc((size_t)(4 * q_count + 1) * sizeof *weights);
    mgdt_triangulation* t = make(n, xyz);
    const int64_t m = mgdt_tetrahedron_count(t);
    int64_t *v = get_array(mgdt_get_tetrahedra, t, 4 * m),
            *found = malloc((size_t)(q_count + 1) * sizeof *found), i, j, one, outside = 0;
    int32_t* found32 = malloc((size_t)(q_count + 1) * sizeof *found32);
    int on, base, good = 1;
    const double slack = grid ? 0 : 1e-7; /* of rounded volumes */
    const double* vertex[4];
    double expected[4], sum;
    if (!grid) /* a few of them outside */
        for (i = 0; i < 3 * q_count; ++i) queries[i] = 1.2 * queries[i] - 0.1;
    /* Vertices themselves are on the boundary of several tetrahedra. */
    memcpy(queries, xyz, (size_t)(3 * (n / 2)) * sizeof *xyz);
    for (on = 0; on < 2; ++on)
        for (base = 0; base < 2; ++base) {
            CHECK_EQUAL(mgdt_set_canonical_output(t, on), MGDT_OK);
            CHECK_EQUAL(mgdt_set_index_base(t, base), MGDT_OK);
            CHECK_EQUAL(mgdt_get_tetrahedra(t, 4 * m, v), MGDT_OK);
            for (i = 0; i < 4 * m; ++i) v[i] -= base;
            found[q_count] = 99, found32[q_count] = 99, weights[4 * q_count] = 99;
            CHECK_EQUAL(mgdt_locate_points(t, q_count, queries, found, weights), MGDT_OK);
            CHECK_EQUAL(mgdt_locate_points_i32(t, q_count, queries, found32, NULL), MGDT_OK);
            CHECK(found[q_count] == 99 && found32[q_count] == 99 && weights[4 * q_count] == 99);
            outside = 0;
            for (i = 0; i < q_count && good; ++i) {
                const double *q = queries + 3 * i, *w = weights + 4 * i;
                int32_t one32 = -7;
                CHECK_EQUAL(mgdt_locate(t, q, &one), MGDT_OK);
                CHECK_EQUAL(mgdt_locate_i32(t, q, &one32), MGDT_OK);
                CHECK_EQUAL(one32, one);
                good &= (one == base - 1) == (found[i] == base - 1);
                good &= (found32[i] == base - 1) == (found[i] == base - 1);
                if (found[i] == base - 1) {
                    ++outside;
                    good &= w[0] == 0 && w[1] == 0 && w[2] == 0 && w[3] == 0;
                    for (j = 0; j < m; ++j) good &= !contains(xyz, v + 4 * j, q, slack, expected);
                    continue;
                }
                good &= found[i] >= base && found[i] < m + base && one >= base && one < m + base &&
                        found32[i] >= base && found32[i] < m + base;
                if (!good) break;
                good &= contains(xyz, v + 4 * (one - base), q, -slack, expected);
                good &= contains(xyz, v + 4 * (found32[i] - base), q, -slack, expected);
                good &= contains(xyz, v + 4 * (found[i] - base), q, -slack, expected);
                sum = 0;
                for (j = 0; j < 4; ++j) {
                    sum += w[j];
                    vertex[j] = xyz + 3 * v[4 * (found[i] - base) + j];
                    /* on the grid what is expected is exact but for one rounding; else random
                     * slivers cost it digits */
                    good &= grid ? w[j] == expected[j] : fabs(w[j] - expected[j]) < 1e-6;
                }
                good &= fabs(sum - 1) < 1e-15;
                good &= reproduces(vertex, q, w);
            }
            CHECK(good);
        }
    CHECK(outside > 0 && outside < q_count - n / 2);
    mgdt_destroy(t);
    free(xyz);
    free(queries);
    free(weights);
    free(v);
    free(found);
    free(found32);
}

/* Sets of dimension 0, 1, 2 and 3, with repeats. */
static void nearest(void) {
    const int64_t n = is_small() ? 60 : 300, q_count = is_small() ? 60 : 400;
    double* queries = half_points(q_count, 45);
    int64_t* many = malloc((size_t)(q_count + 1) * sizeof *many);
    int32_t* many32 = malloc((size_t)(q_count + 1) * sizeof *many32);
    int dimension, base;
    for (dimension = 0; dimension <= 3; ++dimension) {
        double* xyz = lattice_points(n, 46);
        mgdt_triangulation* t;
        int64_t i, k, got;
        int good = 1;
        for (i = 0; i < n; ++i) {
            if (dimension < 3) xyz[3 * i + 2] = 1;
            if (dimension < 2) xyz[3 * i + 1] = 7 - xyz[3 * i];
            if (dimension < 1) xyz[3 * i] = 3, xyz[3 * i + 1] = 4;
        }
        t = make(n, xyz);
        CHECK_EQUAL(mgdt_dimension(t), dimension);
        for (base = 0; base < 2; ++base) {
            CHECK_EQUAL(mgdt_set_index_base(t, base), MGDT_OK);
            many[q_count] = 99, many32[q_count] = 99;
            CHECK_EQUAL(mgdt_nearest_vertices(t, q_count, queries, many), MGDT_OK);
            CHECK_EQUAL(mgdt_nearest_vertices_i32(t, q_count, queries, many32), MGDT_OK);
            CHECK(many[q_count] == 99 && many32[q_count] == 99);
            for (k = 0; k < q_count; ++k) {
                const double* q = queries + 3 * k;
                int32_t got32 = -7;
                double least = HUGE_VAL;
                int64_t expected = -1;
                for (i = 0; i < n; ++i) { /* the first of several: the lowest index */
                    const double x = xyz[3 * i] - q[0], y = xyz[3 * i + 1] - q[1],
                                 z = xyz[3 * i + 2] - q[2], d = x * x + y * y + z * z;
                    if (d < least) least = d, expected = i;
                }
                got = -7;
                good &= mgdt_nearest_vertex(t, q, &got) == MGDT_OK && got == expected + base;
                good &= mgdt_nearest_vertex_i32(t, q, &got32) == MGDT_OK && got32 == got;
                good &= many[k] == got && many32[k] == got;
            }
        }
        CHECK(good);
        mgdt_destroy(t);
        free(xyz);
    }
    free(queries);
    free(many);
    free(many32);
}

/* More places than a thread is worth, inside and far outside, with one thread and with three. */
static void nearest_in_threads(void) {
    const int64_t n = is_small() ? 500 : 5000, q_count = 20000;
    double *xyz = random_points(n, 0, 47), *queries = random_points(q_count, 0, 48);
    int64_t* found[2];
    mgdt_triangulation* t = make(n, xyz);
    int64_t i, k;
    int threads, good = 1;
    for (i = 0; i < 3 * q_count; ++i) queries[i] = 3 * queries[i] - 1;
    for (threads = 0; threads < 2; ++threads) {
        found[threads] = malloc((size_t)q_count * sizeof *found[threads]);
        CHECK_EQUAL(mgdt_set_threads(t, 1 + 2 * threads), MGDT_OK);
        CHECK_EQUAL(mgdt_nearest_vertices(t, q_count, queries, found[threads]), MGDT_OK);
    }
    CHECK(memcmp(found[0], found[1], (size_t)q_count * sizeof *found[0]) == 0);
    for (k = 0; k < q_count; k += is_small() ? 97 : 7) {
        int64_t one = -7;
        good &= mgdt_nearest_vertex(t, queries + 3 * k, &one) == MGDT_OK && one == found[0][k];
    }
    CHECK(good);
    mgdt_destroy(t);
    free(found[0]);
    free(found[1]);
    free(xyz);
    free(queries);
}

/* Distances and volumes that no double can tell apart, or hold at all. */
static void extremes(void) {
    static const double tiny[] = {0, 0, 0, 1e-300, 0, 0, 0, 1e-300, 0, 0, 0, 1e-300, 0, 0, 3e-300};
    static const double huge[] = {-1e308, -1e308, -1e308, 1e308, -1e308, -1e308,
                                  -1e308, 1e308,  -1e308, 0,     0,      1.5e308};
    static const struct {
        double q[3];
        int64_t nearest;
    } tiny_cases[] = {{{1, 0, 0}, 1},     {{-1, 0, 0}, 0},          {{0, 1, 1e-310}, 2},
                      {{0, 0, 1}, 4},     {{1e-300, 1e-300, 0}, 1}, {{0, 0, 1.9e-300}, 3},
                      {{0, 0, 2e-300}, 3}};
    static const double inside[3] = {-1e307, -1e307, 1e307}, outside[3] = {1e308, 1e308, 1e308},
                        corner[3] = {1e308, -1e308, -1e308};
    mgdt_triangulation* t = make(5, tiny);
    int64_t found = -7, all[7];
    double weights[4] = {0, 0, 0, 0}, places[21];
    size_t k;
    for (k = 0; k < sizeof tiny_cases / sizeof tiny_cases[0]; ++k) {
        CHECK_EQUAL(mgdt_nearest_vertex(t, tiny_cases[k].q, &found), MGDT_OK);
        CHECK_EQUAL(found, tiny_cases[k].nearest);
    }
    for (k = 0; k < 7; ++k) memcpy(places + 3 * k, tiny_cases[k].q, 3 * sizeof *places);
    CHECK_EQUAL(mgdt_nearest_vertices(t, 7, places, all), MGDT_OK);
    for (k = 0; k < 7; ++k) CHECK_EQUAL(all[k], tiny_cases[k].nearest);
    CHECK_EQUAL(mgdt_locate(t, tiny_cases[0].q, &found), MGDT_OK);
    CHECK_EQUAL(found, -1);
    mgdt_destroy(t);
    t = make(4, huge);
    CHECK_EQUAL(mgdt_locate(t, inside, &found), MGDT_OK);
    CHECK_EQUAL(found, 0);
    CHECK_EQUAL(mgdt_locate(t, outside, &found), MGDT_OK);
    CHECK_EQUAL(found, -1);
    CHECK_EQUAL(mgdt_locate(t, corner, &found), MGDT_OK);
    CHECK_EQUAL(found, 0);
    CHECK_EQUAL(mgdt_locate_points(t, 1, inside, &found, weights), MGDT_OK);
    CHECK(weights[0] > 0 && weights[1] > 0 && weights[2] > 0 && weights[3] > 0);
    CHECK(fabs(weights[0] + weights[1] + weights[2] + weights[3] - 1) < 1e-15);
    CHECK_EQUAL(mgdt_nearest_vertex(t, corner, &found), MGDT_OK);
    CHECK_EQUAL(found, 1);
    CHECK_EQUAL(mgdt_nearest_vertices(t, 4, huge, all), MGDT_OK);
    CHECK(all[0] == 0 && all[1] == 1 && all[2] == 2 && all[3] == 3);
    mgdt_destroy(t);
}

void test_queries(void) {
    located(0);
    located(1);
    nearest();
    nearest_in_threads();
    extremes();
}
