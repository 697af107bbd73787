/* SPDX-License-Identifier: MIT
 * The Voronoi diagram as an object. */
#define _POSIX_C_SOURCE 200112L
#include <math.h>
#include <mgdt/mgdt_voronoi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../support/counting_allocator.h"
#include "check.h"
#include "keys.h"

static const double cube[24] = {1, 0,  0, 1, -1, 0, 0, 0, 0, 1, 0,  1,
                                0, -1, 0, 0, 0,  0, 1, 1, 0, 0, -1, 0};
static const int32_t integers[9] = {
    MGDT_VORONOI_ARRAY_FACE_OFFSETS,        MGDT_VORONOI_ARRAY_FACE_CORNERS,
    MGDT_VORONOI_ARRAY_FACE_SIDES,          MGDT_VORONOI_ARRAY_RAY_VERTICES,
    MGDT_VORONOI_ARRAY_CELL_OFFSETS,        MGDT_VORONOI_ARRAY_CELL_FACES,
    MGDT_VORONOI_ARRAY_CELL_BOUNDED,        MGDT_VORONOI_ARRAY_CELL_NEIGHBORS,
    MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_SHIFTS};
static const int32_t doubles[9] = {MGDT_VORONOI_ARRAY_VERTICES,
                                   MGDT_VORONOI_ARRAY_RAY_DIRECTIONS,
                                   MGDT_VORONOI_ARRAY_FACE_AREAS,
                                   MGDT_VORONOI_ARRAY_FACE_NORMALS,
                                   MGDT_VORONOI_ARRAY_FACE_CENTROIDS,
                                   MGDT_VORONOI_ARRAY_CELL_VOLUMES,
                                   MGDT_VORONOI_ARRAY_CELL_CENTROIDS,
                                   MGDT_VORONOI_ARRAY_CELL_FACE_AREAS,
                                   MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES};

static int check_message(const mgdt_voronoi* v, const char* text) {
    char message[256] = "";
    CHECK_EQUAL(mgdt_voronoi_get_error(v, sizeof message, message), MGDT_OK);
    if (strstr(message, text) == NULL) printf("the message is: %s\n", message);
    return CHECK(strstr(message, text) != NULL);
}

static int64_t stat_of(const mgdt_voronoi* v, int32_t key) {
    int64_t value = -1;
    CHECK_EQUAL(mgdt_voronoi_get_stat(v, key, &value), MGDT_OK);
    return value;
}

static int64_t size_of(const mgdt_voronoi* v, int32_t array) {
    int64_t size = -1;
    CHECK_EQUAL(mgdt_voronoi_get_size(v, array, &size), MGDT_OK);
    return size;
}

static int64_t* integers_of(const mgdt_voronoi* v, int32_t array) {
    const int64_t size = size_of(v, array);
    int64_t* const values = malloc((size_t)(size + 1) * sizeof *values);
    values[size] = -77;
    CHECK_EQUAL(mgdt_voronoi_get_array(v, array, size, values), MGDT_OK);
    CHECK_EQUAL(values[size], -77);
    return values;
}

static double* doubles_of(const mgdt_voronoi* v, int32_t array) {
    const int64_t size = size_of(v, array);
    double* const values = malloc((size_t)(size + 1) * sizeof *values);
    values[size] = -77;
    CHECK_EQUAL(mgdt_voronoi_get_doubles(v, array, size, values), MGDT_OK);
    CHECK(values[size] == -77);
    return values;
}

static mgdt_voronoi* diagram_of(mgdt_triangulation* t, int64_t planes, const double* of) {
    mgdt_voronoi* v = NULL;
    CHECK_EQUAL(mgdt_voronoi_create(t, planes, of, &v), MGDT_OK);
    CHECK(v != NULL);
    return v;
}

/* The sums over a diagram in the unit cube: the sizes fit together, cells fill the cube, the faces
 * on its boundary have its area, and the divergence theorem holds for each cell. */
static void fits_together(void) {
    double* const xyz = random_points(300, 0, 11);
    mgdt_triangulation* const t = make(300, xyz);
    mgdt_voronoi* const v = diagram_of(t, 6, cube);
    int64_t *offsets, *sides, *cells, *faces, *bounded, *neighbors;
    double *areas, *normals, *centroids, *volumes, *face_areas, *distances;
    double volume = 0, boundary = 0, flux[300];
    int64_t f, c, n;
    int k;
    mgdt_destroy(t); /* The diagram stays. */
    offsets = integers_of(v, MGDT_VORONOI_ARRAY_FACE_OFFSETS);
    sides = integers_of(v, MGDT_VORONOI_ARRAY_FACE_SIDES);
    cells = integers_of(v, MGDT_VORONOI_ARRAY_CELL_OFFSETS);
    faces = integers_of(v, MGDT_VORONOI_ARRAY_CELL_FACES);
    bounded = integers_of(v, MGDT_VORONOI_ARRAY_CELL_BOUNDED);
    areas = doubles_of(v, MGDT_VORONOI_ARRAY_FACE_AREAS);
    normals = doubles_of(v, MGDT_VORONOI_ARRAY_FACE_NORMALS);
    centroids = doubles_of(v, MGDT_VORONOI_ARRAY_FACE_CENTROIDS);
    volumes = doubles_of(v, MGDT_VORONOI_ARRAY_CELL_VOLUMES);
    n = size_of(v, MGDT_VORONOI_ARRAY_FACE_AREAS);
    CHECK_EQUAL(size_of(v, MGDT_VORONOI_ARRAY_FACE_OFFSETS), n + 1);
    CHECK_EQUAL(size_of(v, MGDT_VORONOI_ARRAY_FACE_SIDES), 2 * n);
    CHECK_EQUAL(size_of(v, MGDT_VORONOI_ARRAY_FACE_CORNERS), offsets[n]);
    CHECK_EQUAL(size_of(v, MGDT_VORONOI_ARRAY_CELL_OFFSETS), 301);
    CHECK_EQUAL(size_of(v, MGDT_VORONOI_ARRAY_CELL_FACES), cells[300]);
    CHECK_EQUAL(size_of(v, MGDT_VORONOI_ARRAY_RAY_VERTICES), 0);
    CHECK_EQUAL(size_of(v, MGDT_VORONOI_ARRAY_CELL_CENTROIDS), 900);
    for (c = 0; c < 300; ++c) {
        volume += volumes[c];
        CHECK_EQUAL(bounded[c], 1);
        flux[c] = 0;
    }
    for (f = 0; f < n; ++f) {
        double along = 0;
        for (k = 0; k < 3; ++k) along += centroids[3 * f + k] * normals[3 * f + k];
        CHECK(sides[2 * f] >= 0);
        flux[sides[2 * f]] += along * areas[f] / 3;
        if (sides[2 * f + 1] >= 0)
            flux[sides[2 * f + 1]] -= along * areas[f] / 3;
        else
            boundary += areas[f];
        CHECK(sides[2 * f + 1] >= -6);
    }
    /* The list of neighbours with weights: the faces, as each of their cells sees them. */
    neighbors = integers_of(v, MGDT_VORONOI_ARRAY_CELL_NEIGHBORS);
    face_areas = doubles_of(v, MGDT_VORONOI_ARRAY_CELL_FACE_AREAS);
    distances = doubles_of(v, MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES);
    CHECK_EQUAL(size_of(v, MGDT_VORONOI_ARRAY_CELL_NEIGHBORS), cells[300]);
    CHECK_EQUAL(size_of(v, MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_SHIFTS), 0);
    for (c = 0; c < 300; ++c) {
        double pyramids = 0;
        for (f = cells[c]; f < cells[c + 1]; ++f) {
            const int64_t* const of = sides + 2 * faces[f];
            CHECK_EQUAL(neighbors[f], of[0] == c ? of[1] : of[0]);
            CHECK(face_areas[f] == areas[faces[f]]);
            pyramids += face_areas[f] * distances[f] / (neighbors[f] < 0 ? 3 : 6);
        }
        CHECK(fabs(pyramids - volumes[c]) < 1e-14);
    }
    CHECK(fabs(volume - 1) < 1e-14);
    CHECK(fabs(boundary - 6) < 1e-13);
    for (c = 0; c < 300; ++c) {
        CHECK(fabs(flux[c] - volumes[c]) < 1e-15);
        for (f = cells[c]; f + 1 < cells[c + 1]; ++f) CHECK(faces[f] < faces[f + 1]);
    }
    mgdt_voronoi_destroy(v);
    free(offsets), free(sides), free(cells), free(faces), free(bounded), free(areas);
    free(normals), free(centroids), free(volumes), free(xyz);
    free(neighbors), free(face_areas), free(distances);
}

/* Numbers begin at the index base; rays and planes count from -1 down in any base. */
static void index_base(void) {
    static const double xyz[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    int32_t base;
    for (base = 0; base < 2; ++base) {
        mgdt_triangulation* const t = make(4, xyz);
        mgdt_voronoi* v;
        int64_t *offsets, *corners, *sides, *rays, least = 9;
        int32_t narrow[64];
        int64_t i, n;
        CHECK_EQUAL(mgdt_set_index_base(t, base), MGDT_OK);
        v = diagram_of(t, 0, NULL);
        offsets = integers_of(v, MGDT_VORONOI_ARRAY_FACE_OFFSETS);
        corners = integers_of(v, MGDT_VORONOI_ARRAY_FACE_CORNERS);
        sides = integers_of(v, MGDT_VORONOI_ARRAY_FACE_SIDES);
        rays = integers_of(v, MGDT_VORONOI_ARRAY_RAY_VERTICES);
        for (i = 0; i < 7; ++i) CHECK_EQUAL(offsets[i], base + 3 * i);
        for (i = 0; i < 6; ++i) {
            CHECK_EQUAL(corners[3 * i], base);
            CHECK(corners[3 * i + 1] < 0 && corners[3 * i + 2] < 0);
            CHECK(sides[2 * i] >= base && sides[2 * i] < sides[2 * i + 1]);
            CHECK(sides[2 * i + 1] < base + 4);
        }
        for (i = 0; i < 18; ++i)
            if (corners[i] < least) least = corners[i];
        CHECK_EQUAL(least, -4);
        for (i = 0; i < 4; ++i) CHECK_EQUAL(rays[i], base);
        for (i = 0; i < 7; ++i) {
            int64_t* const wide = integers_of(v, integers[i]);
            int64_t k;
            n = size_of(v, integers[i]);
            CHECK(n <= 64);
            CHECK_EQUAL(mgdt_voronoi_get_array_i32(v, integers[i], 64, narrow), MGDT_OK);
            for (k = 0; k < n; ++k) CHECK_EQUAL(wide[k], narrow[k]);
            free(wide);
        }
        free(offsets), free(corners), free(sides), free(rays);
        mgdt_voronoi_destroy(v);
        v = diagram_of(t, 6, cube);
        sides = integers_of(v, MGDT_VORONOI_ARRAY_FACE_SIDES);
        n = size_of(v, MGDT_VORONOI_ARRAY_FACE_AREAS);
        least = 0;
        for (i = 0; i < n; ++i)
            if (sides[2 * i + 1] < least) least = sides[2 * i + 1];
        CHECK_EQUAL(least, -6);
        free(sides);
        mgdt_voronoi_destroy(v);
        mgdt_destroy(t);
    }
}

static void arguments(void) {
    int32_t found, key;
    static const double xyz[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    mgdt_triangulation* const t = make(5, xyz);
    mgdt_voronoi *v = (mgdt_voronoi*)t, *other;
    int64_t size = 5, values[8];
    int32_t narrow[8];
    double x[64], planes[24];
    char text[8];
    int i;
    CHECK_EQUAL(mgdt_voronoi_create(NULL, 0, NULL, &v), MGDT_ERR_NULL_POINTER);
    CHECK(v == NULL);
    CHECK_EQUAL(mgdt_voronoi_create(t, 0, NULL, NULL), MGDT_ERR_NULL_POINTER);
    v = (mgdt_voronoi*)t;
    CHECK_EQUAL(mgdt_voronoi_create(t, 5, cube, &v), MGDT_ERR_INVALID_ARGUMENT);
    CHECK(v == NULL);
    CHECK_ERROR(t, "do not bound a region: plane 0 has no end");
    CHECK_EQUAL(mgdt_voronoi_create(t, -1, cube, &v), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_voronoi_create(t, 6, NULL, &v), MGDT_ERR_NULL_POINTER);
    memcpy(planes, cube, sizeof planes);
    planes[3] = .5;
    CHECK_EQUAL(mgdt_voronoi_create(t, 6, planes, &v), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "point 1 is beyond plane 0");
    planes[3] = NAN;
    CHECK_EQUAL(mgdt_voronoi_create(t, 6, planes, &v), MGDT_ERR_NOT_FINITE);
    v = diagram_of(t, 6, cube);
    CHECK_EQUAL(mgdt_voronoi_get_size(NULL, MGDT_VORONOI_ARRAY_VERTICES, &size),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_voronoi_get_size(v, MGDT_VORONOI_ARRAY_VERTICES, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_KINDS_OF_KEYS(voronoi, v, MGDT_ERR_UNKNOWN_KEY, found);
    CHECK_EQUAL(found, 19);
    CHECK_EQUAL(stat_of(v, MGDT_VORONOI_STAT_VERTICES),
                size_of(v, MGDT_VORONOI_ARRAY_VERTICES) / 3);
    CHECK_EQUAL(stat_of(v, MGDT_VORONOI_STAT_RAYS), size_of(v, MGDT_VORONOI_ARRAY_RAY_VERTICES));
    CHECK_EQUAL(stat_of(v, MGDT_VORONOI_STAT_FACES), size_of(v, MGDT_VORONOI_ARRAY_FACE_AREAS));
    CHECK_EQUAL(stat_of(v, MGDT_VORONOI_STAT_POINTS), size_of(v, MGDT_VORONOI_ARRAY_CELL_VOLUMES));
    CHECK(stat_of(v, MGDT_VORONOI_STAT_MEMORY_BYTES) > 0);
    CHECK_EQUAL(mgdt_voronoi_get_stat(v, MGDT_VORONOI_ARRAY_VERTICES, &size), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_voronoi_get_stat(v, MGDT_VORONOI_STAT_FACES, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_voronoi_get_stat(NULL, MGDT_VORONOI_STAT_FACES, &size), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_voronoi_get_size(v, 9, &size), MGDT_ERR_UNKNOWN_KEY);
    check_message(v, "there is no array 9");
    CHECK_EQUAL(size, 5);
    for (i = 0; i < 9; ++i) {
        CHECK_EQUAL(mgdt_voronoi_get_array(NULL, integers[i], 8, values), MGDT_ERR_NULL_POINTER);
        CHECK_EQUAL(mgdt_voronoi_get_doubles(v, integers[i], 64, x), MGDT_ERR_UNKNOWN_KEY);
        check_message(v, "has integers");
        CHECK_EQUAL(mgdt_voronoi_get_array(v, doubles[i], 8, values), MGDT_ERR_UNKNOWN_KEY);
        CHECK_EQUAL(mgdt_voronoi_get_array_i32(v, doubles[i], 8, narrow), MGDT_ERR_UNKNOWN_KEY);
        check_message(v, "has doubles");
        if (size_of(v, integers[i]) > 0) {
            CHECK_EQUAL(mgdt_voronoi_get_array(v, integers[i], 1, values),
                        MGDT_ERR_BUFFER_TOO_SMALL);
            CHECK_EQUAL(mgdt_voronoi_get_array(v, integers[i], 1000, NULL), MGDT_ERR_NULL_POINTER);
        }
        if (size_of(v, doubles[i]) > 0) {
            CHECK_EQUAL(mgdt_voronoi_get_doubles(v, doubles[i], 1, x), MGDT_ERR_BUFFER_TOO_SMALL);
            CHECK_EQUAL(mgdt_voronoi_get_doubles(v, doubles[i], 1000, NULL), MGDT_ERR_NULL_POINTER);
        }
    }
    CHECK_EQUAL(mgdt_voronoi_get_array(v, MGDT_VORONOI_ARRAY_CELL_OFFSETS, -1, values),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_voronoi_drop_small_faces(NULL, 0, 0), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_voronoi_drop_small_faces(v, -1, 0), MGDT_ERR_INVALID_ARGUMENT);
    check_message(v, "the least area is -1");
    CHECK_EQUAL(mgdt_voronoi_drop_small_faces(v, NAN, 0), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_voronoi_drop_small_faces(v, 0, 1), MGDT_ERR_INVALID_ARGUMENT);
    check_message(v, "the least share");
    CHECK_EQUAL(mgdt_voronoi_drop_small_faces(v, 0, NAN), MGDT_ERR_INVALID_ARGUMENT);
    size = size_of(v, MGDT_VORONOI_ARRAY_FACE_AREAS);
    CHECK_EQUAL(mgdt_voronoi_drop_small_faces(v, 1e-300, 1e-300), MGDT_OK);
    CHECK_EQUAL(size_of(v, MGDT_VORONOI_ARRAY_FACE_AREAS), size);
    CHECK_EQUAL(mgdt_voronoi_get_error(NULL, 8, text), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_voronoi_get_error(v, 8, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_voronoi_get_error(v, 0, text), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_voronoi_get_error(v, 8, text), MGDT_OK);
    CHECK_EQUAL(strlen(text), 7);
    other = diagram_of(t, 0, NULL);
    mgdt_voronoi_destroy(other);
    mgdt_voronoi_destroy(v);
    mgdt_voronoi_destroy(NULL);
    mgdt_destroy(t);
}

/* No points, and points that span no space. */
static void few_points(void) {
    static const double xyz[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    static const double planes[16] = {-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 1, 1, 1, 1};
    mgdt_triangulation* t = make(0, NULL);
    mgdt_voronoi* v = diagram_of(t, 0, NULL);
    int i;
    for (i = 0; i < 9; ++i) {
        const int is_offset = integers[i] == MGDT_VORONOI_ARRAY_FACE_OFFSETS ||
                              integers[i] == MGDT_VORONOI_ARRAY_CELL_OFFSETS;
        CHECK_EQUAL(size_of(v, integers[i]), is_offset);
        CHECK_EQUAL(size_of(v, doubles[i]), 0);
        CHECK_EQUAL(mgdt_voronoi_get_doubles(v, doubles[i], 0, NULL), MGDT_OK);
    }
    CHECK_EQUAL(mgdt_voronoi_drop_small_faces(v, 1, 0), MGDT_OK);
    mgdt_voronoi_destroy(v);
    /* In a region, too, whose planes begin at no point. */
    v = diagram_of(t, 4, planes);
    CHECK_EQUAL(size_of(v, MGDT_VORONOI_ARRAY_CELL_VOLUMES), 0);
    mgdt_voronoi_destroy(v);
    mgdt_destroy(t);
    t = make(4, xyz);
    CHECK_EQUAL(mgdt_voronoi_create(t, 0, NULL, &v), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "there are no cells: all points are in one plane");
    CHECK(v == NULL);
    mgdt_destroy(t);
}

/* A diagram has the memory limit of its triangulation, for itself. */
static void memory_limit(void) {
    double* const xyz = random_points(2000, 0, 3);
    mgdt_triangulation* const t = make(2000, xyz);
    mgdt_voronoi* v;
    CHECK_EQUAL(mgdt_set_memory_limit(t, 1000000), MGDT_OK);
    CHECK_EQUAL(mgdt_voronoi_create(t, 0, NULL, &v), MGDT_ERR_OUT_OF_MEMORY);
    CHECK(v == NULL);
    CHECK_EQUAL(mgdt_set_memory_limit(t, INT64_C(1) << 30), MGDT_OK);
    v = diagram_of(t, 0, NULL);
    mgdt_voronoi_destroy(v);
    mgdt_destroy(t);
    free(xyz);
}

static void cancel(void* t) {
    mgdt_cancel(t);
}

/* A request stops the diagram wherever it comes, and nothing else. */
static void cancelled(void) {
    double* const xyz = random_points(1500, 0, 4);
    counting_allocator a = {0, 0, 0, 0, cancel, NULL};
    mgdt_triangulation* t = NULL;
    mgdt_voronoi* v = NULL;
    int64_t before, all, stopped = 0, planes;
    CHECK_EQUAL(mgdt_create_with_allocator(counted_allocate, counted_release, &a, &t), MGDT_OK);
    a.on = t;
    CHECK_EQUAL(mgdt_insert_points(t, 1500, xyz), MGDT_OK);
    for (planes = 0; planes <= 6; planes += 6) {
        a.calls = 0;
        a.act_at = 0;
        v = diagram_of(t, planes, cube);
        mgdt_voronoi_destroy(v);
        all = a.calls;
        before = a.blocks;
        for (a.act_at = 1; a.act_at <= all; a.act_at += 1 + all / 40) {
            mgdt_status status;
            a.calls = 0;
            status = mgdt_voronoi_create(t, planes, cube, &v);
            CHECK(status == MGDT_OK || status == MGDT_ERR_CANCELLED);
            CHECK((status == MGDT_OK) == (v != NULL));
            if (status == MGDT_ERR_CANCELLED) {
                ++stopped;
                CHECK_ERROR(t, "cancelled");
            }
            mgdt_voronoi_destroy(v);
            CHECK_EQUAL(a.blocks, before);
        }
    }
    CHECK(stopped > 20);
    a.act_at = 0;
    /* A request that comes before the call. */
    CHECK_EQUAL(mgdt_cancel(t), MGDT_OK);
    CHECK_EQUAL(mgdt_voronoi_create(t, 6, cube, &v), MGDT_ERR_CANCELLED);
    CHECK(v == NULL);
    v = diagram_of(t, 6, cube);
    mgdt_voronoi_destroy(v);
    CHECK_EQUAL(mgdt_insert_points(t, 10, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    mgdt_destroy(t);
    CHECK_EQUAL(a.blocks, 0);
    free(xyz);
}

void test_voronoi(void) {
    cancelled();
    fits_together();
    index_base();
    arguments();
    few_points();
    memory_limit();
}
