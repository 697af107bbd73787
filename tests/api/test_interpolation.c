/* SPDX-License-Identifier: MIT
 * Values between points: linear functions come back, weights and values agree, and every place of
 * the closed hull has a value. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

static const int32_t methods[5] = {MGDT_INTERPOLATE_LINEAR, MGDT_INTERPOLATE_NEAREST,
                                   MGDT_INTERPOLATE_SIBSON, MGDT_INTERPOLATE_LAPLACE,
                                   MGDT_INTERPOLATE_SIBSON_C1};
static const int32_t outsides[4] = {MGDT_OUTSIDE_NONE, MGDT_OUTSIDE_NEAREST, MGDT_OUTSIDE_BOUNDARY,
                                    MGDT_OUTSIDE_LINEAR};

/* Each method with some of the choices where time is short. */
static int is_left_out(int method, int outside) {
    return is_small() && (method + outside) % 3 != 0;
}

/* Three fields: x + 2 y - 3 z + 1, a constant, and y. */
static double field(int f, const double* x) {
    return f == 0 ? x[0] + 2 * x[1] - 3 * x[2] + 1 : f == 1 ? 5 : x[1];
}
static double* values_at(int64_t n, const double* xyz) {
    double* const values = malloc(3 * (size_t)n * sizeof *values);
    int64_t i;
    int f;
    for (i = 0; i < n; ++i)
        for (f = 0; f < 3; ++f) values[3 * i + f] = field(f, xyz + 3 * i);
    return values;
}

/* Random points of a box, whose corners are points too; the first comes again at the end. */
enum { n_points = 209 };
static double* box_points(int grid) {
    double* const xyz = random_points(n_points, grid, 9);
    int i, axis;
    for (i = 0; i < 8; ++i)
        for (axis = 0; axis < 3; ++axis) xyz[3 * (200 + i) + axis] = i >> axis & 1;
    memcpy(xyz + 3 * 208, xyz, 3 * sizeof *xyz);
    return xyz;
}

/* Places at points, on the faces, edges and corners of the box, between them, and outside. */
enum { n_places = 400 };
static double* box_places(const double* xyz) {
    double* const places = random_points(n_places, 8, 10);
    int i;
    memcpy(places, xyz, 100 * 3 * sizeof *places);
    for (i = 100; i < 160; ++i) places[3 * i + i % 3] = i % 2;
    for (i = 160; i < 200; ++i) places[3 * i + i % 3] = places[3 * i + (i + 1) % 3] = i % 2;
    for (i = 300; i < n_places; ++i) places[3 * i + i % 3] = i % 2 ? 1 + 0.01 * i : -0.01 * i;
    return places;
}
static int is_outside(const double* x) {
    int axis;
    for (axis = 0; axis < 3; ++axis)
        if (x[axis] < 0 || x[axis] > 1) return 1;
    return 0;
}

static void linear_functions(int grid) {
    double* const xyz = box_points(grid);
    double* const places = box_places(xyz);
    double* const values = values_at(n_points, xyz);
    double out[3 * n_places + 1], gradients[9 * n_points + 1];
    mgdt_triangulation* const t = make(n_points, xyz);
    int m, o, i, f, axis;
    for (m = 0; m < 5; ++m)
        for (o = 0; o < 4; ++o) {
            double worst = 0;
            if (methods[m] == MGDT_INTERPOLATE_NEAREST || is_left_out(m, o)) continue;
            out[3 * n_places] = -7;
            CHECK_EQUAL(
                mgdt_interpolate(t, methods[m], outsides[o], 3, values, n_places, places, out),
                MGDT_OK);
            CHECK(out[3 * n_places] == -7);
            for (i = 0; i < n_places; ++i) {
                double place[3];
                memcpy(place, places + 3 * i, sizeof place);
                if (is_outside(place)) {
                    if (outsides[o] == MGDT_OUTSIDE_NONE) {
                        CHECK(out[3 * i] != out[3 * i]);
                        continue;
                    }
                    if (outsides[o] == MGDT_OUTSIDE_NEAREST) continue;
                    if (outsides[o] == MGDT_OUTSIDE_BOUNDARY)
                        for (axis = 0; axis < 3; ++axis)
                            place[axis] = fmin(fmax(place[axis], 0), 1);
                }
                for (f = 0; f < 3; ++f) worst = fmax(worst, fabs(out[3 * i + f] - field(f, place)));
            }
            CHECK(worst < 1e-13);
        }
    gradients[9 * n_points] = -7;
    CHECK_EQUAL(mgdt_get_gradients(t, 3, values, gradients), MGDT_OK);
    CHECK(gradients[9 * n_points] == -7);
    for (i = 0; i < n_points; ++i) {
        const double expected[9] = {1, 2, -3, 0, 0, 0, 0, 1, 0};
        for (f = 0; f < 9; ++f) CHECK(fabs(gradients[9 * i + f] - expected[f]) < 1e-12);
    }
    mgdt_destroy(t);
    free(values);
    free(places);
    free(xyz);
}

/* Weights give what interpolation gives, with both bases and widths. */
static void weights(void) {
    double* const xyz = box_points(16);
    double* const places = box_places(xyz);
    double* const values = values_at(n_points, xyz);
    double out[3 * n_places];
    mgdt_triangulation* const t = make(n_points, xyz);
    int64_t offsets[n_places + 2];
    int32_t offsets32[n_places + 1];
    int m, o, f;
    int64_t i, k;
    CHECK_EQUAL(mgdt_set_index_base(t, 1), MGDT_OK);
    for (m = 0; m < 5; ++m)
        for (o = 0; o < 4; ++o) {
            int64_t size, *points;
            int32_t* points32;
            double *w, *w32, worst = 0;
            if (is_left_out(m, o)) continue;
            CHECK_EQUAL(
                mgdt_interpolate(t, methods[m], outsides[o], 3, values, n_places, places, out),
                MGDT_OK);
            offsets[n_places + 1] = -7;
            CHECK_EQUAL(mgdt_get_interpolation_weights(t, methods[m], outsides[o], n_places, places,
                                                       n_places + 1, offsets, 0, NULL, NULL),
                        MGDT_OK);
            CHECK_EQUAL(offsets[0], 1);
            CHECK_EQUAL(offsets[n_places + 1], -7);
            size = offsets[n_places] - 1;
            points = malloc(((size_t)size + 1) * sizeof *points);
            points32 = malloc(((size_t)size + 1) * sizeof *points32);
            w = malloc(((size_t)size + 1) * sizeof *w);
            w32 = malloc(((size_t)size + 1) * sizeof *w32);
            points[size] = -7;
            w[size] = -7;
            CHECK_EQUAL(mgdt_get_interpolation_weights(t, methods[m], outsides[o], n_places, places,
                                                       n_places + 1, offsets, size, points, w),
                        MGDT_OK);
            CHECK(points[size] == -7 && w[size] == -7);
            CHECK_EQUAL(
                mgdt_get_interpolation_weights_i32(t, methods[m], outsides[o], n_places, places,
                                                   n_places + 1, offsets32, size, points32, w32),
                MGDT_OK);
            CHECK(memcmp(w, w32, (size_t)size * sizeof *w) == 0);
            for (k = 0; k < size; ++k) CHECK(points[k] == points32[k]);
            for (i = 0; i < n_places; ++i) {
                double sum = 0;
                CHECK(offsets[i] == offsets32[i]);
                if (offsets[i] == offsets[i + 1]) CHECK(out[3 * i] != out[3 * i]);
                for (k = offsets[i] - 1; k < offsets[i + 1] - 1; ++k) {
                    CHECK(k == offsets[i] - 1 || points[k - 1] < points[k]);
                    CHECK(points[k] >= 1 && points[k] < n_points);
                    sum += w[k];
                }
                if (offsets[i] == offsets[i + 1]) continue;
                CHECK(fabs(sum - 1) < 1e-14);
                for (f = 0; f < 3; ++f) {
                    double value = 0;
                    for (k = offsets[i] - 1; k < offsets[i + 1] - 1; ++k)
                        value += w[k] * values[3 * (points[k] - 1) + f];
                    worst = fmax(worst, fabs(value - out[3 * i + f]));
                }
            }
            CHECK(worst < 1e-13);
            if (size > 0) {
                memset(offsets, 0, sizeof offsets);
                CHECK_EQUAL(
                    mgdt_get_interpolation_weights(t, methods[m], outsides[o], n_places, places,
                                                   n_places + 1, offsets, size - 1, points, w),
                    MGDT_ERR_BUFFER_TOO_SMALL);
                CHECK_ERROR(t, "are needed");
                CHECK_EQUAL(offsets[n_places], size + 1);
            }
            free(points);
            free(points32);
            free(w);
            free(w32);
        }
    mgdt_destroy(t);
    free(values);
    free(places);
    free(xyz);
}

/* The nearest vertex, and with the nearest place of the hull that one's. */
static void nearest(void) {
    double* const xyz = box_points(0);
    double* const places = box_places(xyz);
    double values[n_points], out[n_places];
    int64_t vertex[n_places];
    mgdt_triangulation* const t = make(n_points, xyz);
    int i;
    for (i = 0; i < n_points; ++i) values[i] = i;
    CHECK_EQUAL(mgdt_nearest_vertices(t, n_places, places, vertex), MGDT_OK);
    CHECK_EQUAL(mgdt_interpolate(t, MGDT_INTERPOLATE_NEAREST, MGDT_OUTSIDE_NEAREST, 1, values,
                                 n_places, places, out),
                MGDT_OK);
    for (i = 0; i < n_places; ++i) CHECK(out[i] == (double)vertex[i]);
    CHECK_EQUAL(mgdt_interpolate(t, MGDT_INTERPOLATE_SIBSON, MGDT_OUTSIDE_NEAREST, 1, values,
                                 n_places, places, out),
                MGDT_OK);
    for (i = 300; i < n_places; ++i) CHECK(out[i] == (double)vertex[i]);
    CHECK_EQUAL(mgdt_interpolate(t, MGDT_INTERPOLATE_NEAREST, MGDT_OUTSIDE_NONE, 1, values,
                                 n_places, places, out),
                MGDT_OK);
    for (i = 0; i < 300; ++i) CHECK(out[i] == out[i]);
    mgdt_destroy(t);
    free(places);
    free(xyz);
}

/* The points of a body-centred lattice have neighbours in pairs, to both sides. So gradients of a
 * paraboloid are exact in the middle, and Sibson's C1 gives it again. */
static void paraboloid(void) {
    enum { n = 432 };
    double xyz[3 * n], values[n], gradients[3 * n], places[60], out[20];
    double* const random = random_points(20, 0, 6);
    mgdt_triangulation* t;
    int i, axis, inside = 0;
    for (i = 0; i < n; ++i) {
        const int k = i % 216;
        const double corner[3] = {k % 6, k / 6 % 6, k / 36};
        values[i] = 0;
        for (axis = 0; axis < 3; ++axis) {
            xyz[3 * i + axis] = corner[axis] + (i < 216 ? 0 : .5);
            values[i] += xyz[3 * i + axis] * xyz[3 * i + axis];
        }
    }
    t = make(n, xyz);
    CHECK_EQUAL(mgdt_get_gradients(t, 1, values, gradients), MGDT_OK);
    for (i = 0; i < n; ++i) {
        const double* const x = xyz + 3 * i;
        if (fmin(fmin(x[0], x[1]), x[2]) < 1 || fmax(fmax(x[0], x[1]), x[2]) > 4.5) continue;
        ++inside;
        for (axis = 0; axis < 3; ++axis) CHECK(fabs(gradients[3 * i + axis] - 2 * x[axis]) < 1e-13);
    }
    CHECK(inside > 100);
    for (i = 0; i < 60; ++i) places[i] = 2.25 + random[i];
    CHECK_EQUAL(mgdt_interpolate(t, MGDT_INTERPOLATE_SIBSON_C1, MGDT_OUTSIDE_NONE, 1, values, 20,
                                 places, out),
                MGDT_OK);
    for (i = 0; i < 20; ++i) {
        const double* const x = places + 3 * i;
        CHECK(fabs(out[i] - (x[0] * x[0] + x[1] * x[1] + x[2] * x[2])) < 1e-12);
    }
    mgdt_destroy(t);
    free(random);
}

/* Numbers for points that are not in are not read, and gradients there are none. */
static void absent_points(void) {
    double* const xyz = box_points(0);
    double* const values = values_at(n_points, xyz);
    double gradients[9 * n_points], out[3];
    const int64_t gone = 7;
    mgdt_triangulation* const t = make(n_points, xyz);
    int f;
    CHECK_EQUAL(mgdt_remove_points(t, 1, &gone), MGDT_OK);
    for (f = 0; f < 3; ++f) values[3 * gone + f] = NAN;
    CHECK_EQUAL(mgdt_get_gradients(t, 3, values, gradients), MGDT_OK);
    for (f = 0; f < 9; ++f) {
        CHECK(gradients[9 * gone + f] != gradients[9 * gone + f]);
        CHECK(gradients[9 * 208 + f] == gradients[f]);
    }
    CHECK_EQUAL(mgdt_interpolate(t, MGDT_INTERPOLATE_SIBSON, MGDT_OUTSIDE_NONE, 3, values, 1,
                                 xyz + 3 * gone, out),
                MGDT_OK);
    for (f = 0; f < 3; ++f) CHECK(fabs(out[f] - field(f, xyz + 3 * gone)) < 1e-13);
    mgdt_destroy(t);
    free(values);
    free(xyz);
}

/* Points in a plane have a nearest one alone; no points have nothing. */
static void flat_and_empty(void) {
    const double flat[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, place[3] = {.9, .2, 7};
    const double values[4] = {1, 2, 3, 4};
    double out = -7, gradients[12];
    int64_t offsets[2] = {-7, -7};
    mgdt_triangulation* t = make(4, flat);
    CHECK_EQUAL(mgdt_interpolate(t, MGDT_INTERPOLATE_LINEAR, MGDT_OUTSIDE_NEAREST, 1, values, 1,
                                 place, &out),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "there are no values between points: all points are in one plane");
    CHECK_EQUAL(mgdt_get_gradients(t, 1, values, gradients), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "there are no gradients: all points are in one plane");
    CHECK(out == -7);
    CHECK_EQUAL(
        mgdt_interpolate(t, MGDT_INTERPOLATE_NEAREST, MGDT_OUTSIDE_NONE, 1, values, 1, place, &out),
        MGDT_OK);
    CHECK(out != out);
    CHECK_EQUAL(mgdt_interpolate(t, MGDT_INTERPOLATE_NEAREST, MGDT_OUTSIDE_LINEAR, 1, values, 1,
                                 place, &out),
                MGDT_OK);
    CHECK(out == 2);
    /* In the closed hull without anything outside: at a point, on an edge, inside, in the plane
     * only, and off it. */
    {
        static const double at[15] = {1, 1, 0, .5, 0, 0, .25, .125, 0, 1.5, .5, 0, .5, .5, 1e-300};
        double five[5];
        CHECK_EQUAL(mgdt_interpolate(t, MGDT_INTERPOLATE_NEAREST, MGDT_OUTSIDE_NONE, 1, values, 5,
                                     at, five),
                    MGDT_OK);
        CHECK(five[0] == 4 && five[1] == 1 && five[2] == 1);
        CHECK(five[3] != five[3] && five[4] != five[4]);
    }
    mgdt_destroy(t);
    t = make(0, NULL);
    CHECK_EQUAL(
        mgdt_interpolate(t, MGDT_INTERPOLATE_LINEAR, MGDT_OUTSIDE_LINEAR, 1, NULL, 1, place, &out),
        MGDT_OK);
    CHECK(out != out);
    CHECK_EQUAL(mgdt_get_interpolation_weights(t, MGDT_INTERPOLATE_SIBSON, MGDT_OUTSIDE_NEAREST, 1,
                                               place, 2, offsets, 0, NULL, NULL),
                MGDT_OK);
    CHECK(offsets[0] == 0 && offsets[1] == 0);
    CHECK_EQUAL(mgdt_get_gradients(t, 1, NULL, NULL), MGDT_OK);
    mgdt_destroy(t);
}

/* Smooth values, and linear ones outside, of points that are nearly in one plane in no direction of
 * an axis: linear functions come back, and weights say the same. */
static void thin_slabs(void) {
    static const double thickness[4] = {1e-3, 1e-8, 1e-12, 1e-14};
    enum { n = 300, m = 60 };
    double xyz[3 * n], values[n], places[3 * m], out[m], weights[200 * m];
    int64_t offsets[m + 1], points[200 * m];
    double* const at = random_points(n, 0, 7);
    double* const of = random_points(m, 0, 8);
    int s, i, k, method;
    for (s = 0; s < 4; ++s) {
        mgdt_triangulation* t;
        for (i = 0; i < n + m; ++i) {
            const double* const p = i < n ? at + 3 * i : of + 3 * (i - n);
            /* Half of the places are outside, in the plane and above it. */
            const double size = i >= n && i % 2 ? 1.5 : 1, a = size * (p[0] - .5),
                         b = size * (p[1] - .5), c = size * (p[2] - .5) * thickness[s];
            double* const to = i < n ? xyz + 3 * i : places + 3 * (i - n);
            to[0] = .6 * a - .64 * b + .48 * c;
            to[1] = .8 * a + .48 * b - .36 * c;
            to[2] = .6 * b + .8 * c;
        }
        for (i = 0; i < n; ++i)
            values[i] = 1 + xyz[3 * i] - 2 * xyz[3 * i + 1] + 3 * xyz[3 * i + 2];
        t = make(n, xyz);
        for (method = 0; method < 2; ++method) {
            const int32_t of_methods[2] = {MGDT_INTERPOLATE_SIBSON_C1, MGDT_INTERPOLATE_LINEAR};
            CHECK_EQUAL(mgdt_interpolate(t, of_methods[method], MGDT_OUTSIDE_LINEAR, 1, values, m,
                                         places, out),
                        MGDT_OK);
            CHECK_EQUAL(
                mgdt_get_interpolation_weights(t, of_methods[method], MGDT_OUTSIDE_LINEAR, m,
                                               places, m + 1, offsets, 200 * m, points, weights),
                MGDT_OK);
            for (i = 0; i < m; ++i) {
                const double exact =
                    1 + places[3 * i] - 2 * places[3 * i + 1] + 3 * places[3 * i + 2];
                double sum = 0;
                for (k = (int)offsets[i]; k < offsets[i + 1]; ++k)
                    sum += weights[k] * values[points[k]];
                CHECK(fabs(out[i] - exact) <= 1e-11);
                CHECK(fabs(sum - exact) <= 1e-11);
            }
        }
        mgdt_destroy(t);
    }
    free(at);
    free(of);
}

/* Two points side by side have a steep slope between them, which is at right angles to the way to
 * this place. */
static void points_side_by_side(void) {
    static const double xyz[12] = {0,  0, .3, .2,       .3, .3, /**/
                                   7., 2, 5,  -0x1p-49, 0,  .3};
    static const double place[3] = {3.4999999999999991, 1, 2.6499999999999999},
                        values[4] = {-2, -1, 0, 1};
    double out, sum = 0, weights[4];
    int64_t offsets[2], points[4];
    int k;
    mgdt_triangulation* const t = make(4, xyz);
    CHECK_EQUAL(mgdt_interpolate(t, MGDT_INTERPOLATE_SIBSON_C1, MGDT_OUTSIDE_NEAREST, 1, values, 1,
                                 place, &out),
                MGDT_OK);
    CHECK_EQUAL(mgdt_get_interpolation_weights(t, MGDT_INTERPOLATE_SIBSON_C1, MGDT_OUTSIDE_NEAREST,
                                               1, place, 2, offsets, 4, points, weights),
                MGDT_OK);
    for (k = 0; k < offsets[1]; ++k) sum += weights[k] * values[points[k]];
    CHECK(offsets[1] == 4);
    CHECK(fabs(sum - out) <= 1e-12);
    mgdt_destroy(t);
}

/* The same bits with any number of threads, and one by one. */
static void threads(void) {
    const int64_t n = is_small() ? 1000 : 20000;
    double* const xyz = random_points(500, 0, 3);
    double* const places = random_points(n, 0, 4);
    double* const values = values_at(500, xyz);
    double* const out = malloc(3 * (size_t)n * sizeof *out);
    double* const again = malloc(3 * (size_t)n * sizeof *out);
    mgdt_triangulation* const t = make(500, xyz);
    int m;
    int64_t i;
    for (m = 0; m < 5; ++m) {
        mgdt_set_threads(t, 1);
        CHECK_EQUAL(mgdt_interpolate(t, methods[m], MGDT_OUTSIDE_LINEAR, 3, values, n, places, out),
                    MGDT_OK);
        mgdt_set_threads(t, 3);
        CHECK_EQUAL(
            mgdt_interpolate(t, methods[m], MGDT_OUTSIDE_LINEAR, 3, values, n, places, again),
            MGDT_OK);
        CHECK(memcmp(out, again, 3 * (size_t)n * sizeof *out) == 0);
        for (i = 0; i < 50; ++i)
            CHECK_EQUAL(mgdt_interpolate(t, methods[m], MGDT_OUTSIDE_LINEAR, 3, values, 1,
                                         places + 3 * i, again + 3 * i),
                        MGDT_OK);
        CHECK(memcmp(out, again, 150 * sizeof *out) == 0);
    }
    mgdt_destroy(t);
    free(again);
    free(out);
    free(values);
    free(places);
    free(xyz);
}

static void refused(void) {
    const double simplex[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double values[4] = {1, 2, 3, 4}, nan_place[6] = {0, 0, 0, 0, NAN, 0};
    const int32_t linear = MGDT_INTERPOLATE_LINEAR, none = MGDT_OUTSIDE_NONE;
    double out[12] = {-7};
    int64_t offsets[3] = {-7}, points[8];
    mgdt_triangulation* const t = make(4, simplex);
    CHECK_EQUAL(mgdt_interpolate(t, 11, none, 1, values, 1, simplex, out), MGDT_ERR_UNKNOWN_KEY);
    CHECK_ERROR(t, "there is no method 11");
    CHECK_EQUAL(mgdt_interpolate(t, linear, 0, 1, values, 1, simplex, out), MGDT_ERR_UNKNOWN_KEY);
    CHECK_ERROR(t, "there is no value 0 for what is outside");
    CHECK_EQUAL(mgdt_interpolate(t, linear, none, -1, values, 1, simplex, out),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "the number of fields is negative (-1)");
    CHECK_EQUAL(mgdt_interpolate(t, linear, none, INT64_MAX, values, 1, simplex, out),
                MGDT_ERR_TOO_LARGE);
    CHECK_ERROR(t, "are more than memory can hold");
    CHECK_EQUAL(mgdt_interpolate(t, linear, none, 1, values, -1, simplex, out),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_interpolate(t, linear, none, 1, values, INT64_MAX, simplex, out),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_interpolate(t, linear, none, 1, NULL, 1, simplex, out), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_interpolate(t, linear, none, 1, values, 1, NULL, out), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_interpolate(t, linear, none, 1, values, 1, simplex, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_interpolate(t, linear, none, 1, values, 2, nan_place, out),
                MGDT_ERR_NOT_FINITE);
    CHECK_ERROR(t, "point 1");
    CHECK_EQUAL(mgdt_interpolate(t, linear, none, 0, NULL, 1, simplex, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_interpolate(t, linear, none, 1, NULL, 0, NULL, NULL), MGDT_OK);
    CHECK(out[0] == -7);

    CHECK_EQUAL(mgdt_get_interpolation_weights(t, 11, none, 1, simplex, 2, offsets, 0, NULL, NULL),
                MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(
        mgdt_get_interpolation_weights(t, linear, none, -1, simplex, 2, offsets, 0, NULL, NULL),
        MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(
        mgdt_get_interpolation_weights(t, linear, none, 1, simplex, 1, offsets, 0, NULL, NULL),
        MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_ERROR(t, "the array of offsets holds 1 elements; 2 are needed");
    CHECK_EQUAL(
        mgdt_get_interpolation_weights(t, linear, none, 1, simplex, 2, offsets, -1, NULL, NULL),
        MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_get_interpolation_weights(t, linear, none, 1, simplex, 2, NULL, 0, NULL, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_interpolation_weights(t, linear, none, 1, NULL, 2, offsets, 0, NULL, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(
        mgdt_get_interpolation_weights(t, linear, none, 1, simplex, 2, offsets, 8, NULL, out),
        MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(
        mgdt_get_interpolation_weights(t, linear, none, 1, simplex, 2, offsets, 8, points, NULL),
        MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(
        mgdt_get_interpolation_weights(t, linear, none, 2, nan_place, 3, offsets, 8, points, out),
        MGDT_ERR_NOT_FINITE);
    CHECK(offsets[0] == -7);
    CHECK_EQUAL(mgdt_get_interpolation_weights(t, linear, none, 0, NULL, 1, offsets, 0, NULL, NULL),
                MGDT_OK);
    CHECK_EQUAL(offsets[0], 0);

    CHECK_EQUAL(mgdt_get_gradients(t, -1, values, out), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_get_gradients(t, INT64_MAX, values, out), MGDT_ERR_TOO_LARGE);
    CHECK_EQUAL(mgdt_get_gradients(t, 1, NULL, out), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_gradients(t, 1, values, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_gradients(t, 0, NULL, NULL), MGDT_OK);
    mgdt_destroy(t);
}

void test_interpolation(void) {
    refused();
    linear_functions(0);
    linear_functions(4);
    weights();
    nearest();
    paraboloid();
    absent_points();
    flat_and_empty();
    thin_slabs();
    points_side_by_side();
    threads();
}
