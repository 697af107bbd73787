/* SPDX-License-Identifier: MIT
 * Measures of Voronoi cells. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

static const double canary = -7;
static const double cube[24] = {1, 0,  0, 1, -1, 0, 0, 0, 0, 1, 0,  1,
                                0, -1, 0, 0, 0,  0, 1, 1, 0, 0, -1, 0};

/* A lattice of 5 x 5 x 5 points, with further points in each cube. */
static int64_t lattice(int further, const double (*at)[3], double* xyz) {
    int64_t n = 0;
    int i, j, axis;
    for (i = 0; i < 125; ++i) {
        const double corner[3] = {i % 5, i / 5 % 5, i / 25};
        for (j = 0; j < 1 + further; ++j, ++n)
            for (axis = 0; axis < 3; ++axis)
                xyz[3 * n + axis] = corner[axis] + (j == 0 ? 0 : at[j - 1][axis]);
    }
    return n;
}

/* Cells in the middle of the lattices of crystals have the faces of their Wigner-Seitz cells, and
 * all one volume. */
static void crystals(void) {
    static const double body[1][3] = {{.5, .5, .5}};
    static const double faces[3][3] = {{.5, .5, 0}, {.5, 0, .5}, {0, .5, .5}};
    static const struct {
        int further;
        const double (*at)[3];
        double faces, area;
    } crystal[3] = {{0, NULL, 6, 6}, {1, body, 14, 3.348076}, {3, faces, 12, 2.121320}};
    double xyz[1500], volume[500], area[500], count[500], centroid[1500];
    int c;
    for (c = 0; c < 3; ++c) {
        const int64_t n = lattice(crystal[c].further, crystal[c].at, xyz);
        const int per_cube = 1 + crystal[c].further;
        mgdt_triangulation* const t = make(n, xyz);
        int64_t k, inside = 0;
        int axis;
        CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 0, NULL, n, volume), MGDT_OK);
        CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_AREA, 0, NULL, n, area), MGDT_OK);
        CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_FACES, 0, NULL, n, count), MGDT_OK);
        CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_CENTROID, 0, NULL, 3 * n, centroid),
                    MGDT_OK);
        for (k = 0; k < n; ++k) {
            int is_inside = 1;
            for (axis = 0; axis < 3; ++axis)
                is_inside &= xyz[3 * k + axis] >= 1.5 && xyz[3 * k + axis] <= 2.5;
            if (!is_inside) continue;
            ++inside;
            CHECK(count[k] == crystal[c].faces);
            CHECK(fabs(volume[k] * per_cube - 1) <= 1e-12);
            CHECK(fabs(area[k] - crystal[c].area) <= 1e-6);
            for (axis = 0; axis < 3; ++axis)
                CHECK(fabs(centroid[3 * k + axis] - xyz[3 * k + axis]) <= 1e-12);
        }
        CHECK(inside > 0);
        CHECK(volume[0] == HUGE_VAL);
        CHECK(centroid[2] == HUGE_VAL);
        CHECK(area[n - 1] == HUGE_VAL);
        mgdt_destroy(t);
    }
}

/* Within a box cells fill it, a repeat has none, and nothing behind the array is touched. */
static void clipped(void) {
    double xyz[306], x[308], sum = 0, moment[3] = {0, 0, 0};
    double* const some = random_points(100, 0, 5);
    mgdt_triangulation* t;
    int i;
    memcpy(xyz, some, 300 * sizeof *xyz);
    free(some);
    memcpy(xyz + 300, xyz, 3 * sizeof *xyz);
    memcpy(xyz + 303, xyz + 30, 3 * sizeof *xyz);
    t = make(102, xyz);
    for (i = 0; i < 308; ++i) x[i] = canary;
    CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 6, cube, 101, x),
                MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_ERROR(t, "102 are needed");
    CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_CENTROID, 6, cube, 305, x),
                MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_ERROR(t, "306 are needed");
    CHECK(x[0] == canary);
    CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 6, cube, 308, x), MGDT_OK);
    for (i = 0; i < 102; ++i) sum += x[i];
    CHECK(fabs(sum - 1) <= 1e-14);
    CHECK(x[0] > 0);
    CHECK(x[100] == 0);
    CHECK(x[101] == 0);
    CHECK(x[102] == canary);
    /* Together the cells have the centroid of the cube. */
    {
        double centroid[306];
        CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_CENTROID, 6, cube, 306, centroid),
                    MGDT_OK);
        for (i = 0; i < 306; ++i) moment[i % 3] += centroid[i] * x[i / 3];
        for (i = 0; i < 3; ++i) CHECK(fabs(moment[i] - .5) <= 1e-13);
    }
    mgdt_destroy(t);
}

/* Volumes beyond the range of doubles. */
static void extremes(void) {
    static const double sizes[2] = {0x1p-400, 0x1p400};
    int s;
    for (s = 0; s < 2; ++s) {
        double xyz[81], box[24], x[27];
        mgdt_triangulation* t;
        int i;
        for (i = 0; i < 81; ++i)
            xyz[i] = sizes[s] * (i / 3 / (i % 3 == 0 ? 1 : i % 3 == 1 ? 3 : 9) % 3);
        for (i = 0; i < 24; ++i) box[i] = i % 4 == 3 ? 3 * sizes[s] : cube[i];
        t = make(27, xyz);
        CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 6, box, 27, x), MGDT_OK);
        for (i = 0; i < 27; ++i) CHECK(x[i] == (s == 0 ? 0 : HUGE_VAL));
        CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_FACES, 6, box, 27, x), MGDT_OK);
        for (i = 0; i < 27; ++i) CHECK(x[i] == 6);
        CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_AREA, 0, NULL, 27, x), MGDT_OK);
        CHECK(fabs(x[13] / (6 * sizes[s] * sizes[s]) - 1) <= 1e-12);
        mgdt_destroy(t);
    }
}

static void refused(const mgdt_triangulation* t, int64_t n, const double* planes,
                    mgdt_status status, const char* message) {
    double x[5] = {canary, canary, canary, canary, canary};
    CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, n, planes, 5, x), status);
    CHECK_ERROR(t, message);
    CHECK(x[0] == canary);
}

static void bad_planes(void) {
    static const double xyz[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    double planes[24], x[5];
    mgdt_triangulation* const t = make(5, xyz);
    refused(t, -1, planes, MGDT_ERR_INVALID_ARGUMENT, "the number of planes is negative (-1)");
    refused(t, INT64_C(1) << 40, planes, MGDT_ERR_TOO_LARGE, "planes are more than");
    refused(t, 6, NULL, MGDT_ERR_NULL_POINTER, "the array of planes is NULL");
    refused(t, 5, cube, MGDT_ERR_INVALID_ARGUMENT, "do not bound a region: plane 0 has no end");
    refused(t, 1, cube, MGDT_ERR_INVALID_ARGUMENT, "do not bound a region");
    memcpy(planes, cube, sizeof planes);
    planes[3] = .5;
    planes[23] = -.5;
    refused(t, 6, planes, MGDT_ERR_INVALID_ARGUMENT, "point 0 is beyond plane 5");
    planes[23] = 0;
    refused(t, 6, planes, MGDT_ERR_INVALID_ARGUMENT, "point 1 is beyond plane 0");
    CHECK_EQUAL(mgdt_set_index_base((mgdt_triangulation*)t, 1), MGDT_OK);
    refused(t, 6, planes, MGDT_ERR_INVALID_ARGUMENT, "point 2 is beyond plane 1");
    CHECK_EQUAL(mgdt_set_index_base((mgdt_triangulation*)t, 0), MGDT_OK);
    planes[3] = 1;
    planes[8] = planes[9] = 0;
    refused(t, 6, planes, MGDT_ERR_INVALID_ARGUMENT, "plane 2 has no normal");
    planes[9] = NAN;
    refused(t, 6, planes, MGDT_ERR_NOT_FINITE, "plane 2 has a number that is not finite");
    planes[9] = 1;
    planes[11] = HUGE_VAL;
    refused(t, 6, planes, MGDT_ERR_NOT_FINITE, "plane 2");
    planes[9] = 1e-300;
    planes[11] = 1e300;
    /* y <= 1e600. */
    CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 6, planes, 5, x), MGDT_OK);
    CHECK(x[2] == HUGE_VAL);
    CHECK(x[0] > 0 && x[0] < 1);
    CHECK_EQUAL(mgdt_get_cell_measures(t, 11, 0, NULL, 5, x), MGDT_ERR_UNKNOWN_KEY);
    CHECK_ERROR(t, "there is no measure 11");
    CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_FACES, 6, cube, 5, x), MGDT_OK);
    mgdt_destroy((mgdt_triangulation*)t);
}

/* Points that span no space have no cells. */
static void flat_sets(void) {
    static const double xyz[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    static const char* const where[4] = {"at one place", "on one line", "in one plane",
                                         "in one plane"};
    double x[5];
    int64_t n;
    for (n = 1; n <= 4; ++n) {
        mgdt_triangulation* const t = make(n, xyz);
        CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 0, NULL, 5, x),
                    MGDT_ERR_INVALID_ARGUMENT);
        CHECK_ERROR(t, where[n - 1]);
        mgdt_destroy(t);
    }
}

void test_cells(void) {
    crystals();
    clipped();
    extremes();
    bad_planes();
    flat_sets();
}
