/* SPDX-License-Identifier: MIT
 * Periodic boxes: arguments that are refused, results before a build, memory that ends, progress
 * and cancellation. */
#define _POSIX_C_SOURCE 200112L
#include <math.h>

#include "../support/counting_allocator.h"
#include "keys.h"
#include "periodic_box.h"

static void bad_arguments(void) {
    int32_t found, key;
    const double flat[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9}, zero[3] = {0, 0, 0};
    double bad[3] = {0, 1, 0}, far[3] = {0.5, -1e15, 0.5}, x[3];
    mgdt_periodic* p = (mgdt_periodic*)(void*)bad;
    mgdt_voronoi* v = (mgdt_voronoi*)(void*)bad;
    int64_t value = 0;
    double distance = 0;
    int32_t small;
    char text[8];
    CHECK_EQUAL(mgdt_periodic_create(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_periodic_create_with_allocator(counted_allocate, NULL, NULL, &p),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK(p == NULL);
    CHECK_EQUAL(mgdt_periodic_create(&p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, 1, cube), MGDT_OK);
    CHECK_EQUAL(stat_of(p, MGDT_PERIODIC_STAT_DIMENSIONS), 0);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_ERR_INVALID_ARGUMENT);
    CHECK(says(p, "the box has no vectors"));
    CHECK_EQUAL(mgdt_periodic_set_vectors(NULL, 3, cube), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_periodic_set_vectors(p, 3, NULL), MGDT_ERR_NULL_POINTER);
    CHECK(says(p, "vectors"));
    CHECK_EQUAL(mgdt_periodic_set_vectors(p, 0, cube), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_periodic_set_vectors(p, 4, cube), MGDT_ERR_INVALID_ARGUMENT);
    CHECK(says(p, "one to three vectors, not 4"));
    CHECK_EQUAL(mgdt_periodic_set_vectors(p, 3, flat), MGDT_ERR_INVALID_ARGUMENT);
    CHECK(says(p, "in a plane"));
    CHECK_EQUAL(mgdt_periodic_set_vectors(p, 1, zero), MGDT_ERR_INVALID_ARGUMENT);
    CHECK(says(p, "no length"));
    bad[0] /= bad[0];
    CHECK_EQUAL(mgdt_periodic_set_vectors(p, 1, bad), MGDT_ERR_NOT_FINITE);
    CHECK(says(p, "coordinate x of vector 0"));
    CHECK_EQUAL(mgdt_periodic_set_vectors(p, 3, cube), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_set_vectors(p, 3, flat), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(stat_of(p, MGDT_PERIODIC_STAT_DIMENSIONS), 3);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_clear(p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, -1, cube), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, 1, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, (int64_t)1 << 62, cube), MGDT_ERR_TOO_LARGE);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, 2, cube), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, 1, bad), MGDT_ERR_NOT_FINITE);
    CHECK(says(p, "point 2"));
    CHECK_EQUAL(stat_of(p, MGDT_PERIODIC_STAT_POINTS), 2);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, 1, far), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_ERR_INVALID_ARGUMENT);
    CHECK(says(p, "point 2 is more than 536870912 boxes away"));
    CHECK_EQUAL(stat_of(p, MGDT_PERIODIC_STAT_TETRAHEDRA), 0);
    CHECK_EQUAL(stat_of(p, MGDT_PERIODIC_STAT_EDGES), 0);
    no_results(p);
    CHECK_EQUAL(mgdt_periodic_create_voronoi(p, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_periodic_set_option(p, MGDT_PERIODIC_OPTION_INDEX_BASE, 2),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_periodic_set_option(p, MGDT_PERIODIC_OPTION_THREADS, -1),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_periodic_set_option(p, MGDT_PERIODIC_OPTION_MEMORY_LIMIT, -1),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_periodic_set_option(p, 11, 0), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_periodic_set_merge_distance(p, -1), MGDT_ERR_INVALID_ARGUMENT);
    CHECK(says(p, "the distance is -1"));
    CHECK_EQUAL(mgdt_periodic_set_merge_distance(p, NAN), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_periodic_set_merge_distance(p, INFINITY), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_periodic_set_merge_distance(NULL, 0), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_periodic_set_merge_distance(p, 0.5), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_get_merge_distance(p, &distance), MGDT_OK);
    CHECK(distance == 0.5);
    CHECK_EQUAL(mgdt_periodic_get_merge_distance(p, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_periodic_set_merge_distance(p, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_get_option(p, 11, &value), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_periodic_get_option(p, MGDT_PERIODIC_OPTION_THREADS, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_periodic_get_option(p, MGDT_PERIODIC_OPTION_THREADS, &value), MGDT_OK);
    CHECK_EQUAL(value, 1);
    CHECK_EQUAL(mgdt_periodic_get_option(p, MGDT_PERIODIC_OPTION_INDEX_BASE, &value), MGDT_OK);
    CHECK_EQUAL(value, 0);
    CHECK_EQUAL(mgdt_periodic_get_option(p, MGDT_PERIODIC_OPTION_MEMORY_LIMIT, &value), MGDT_OK);
    CHECK_EQUAL(value, 0);
    CHECK_EQUAL(mgdt_periodic_get_stat(p, 9, &value), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_periodic_get_stat(p, MGDT_PERIODIC_STAT_VERTICES, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_periodic_get_size(p, 9, &value), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_periodic_get_size(p, MGDT_PERIODIC_ARRAY_POINTS, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_periodic_clear(p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_check(p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_VOLUME, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_create_voronoi(p, &v), MGDT_OK);
    mgdt_voronoi_destroy(v);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, 1, cube), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
    CHECK_KINDS_OF_KEYS(periodic, p, mgdt_periodic_get_option(p, key, &value), found);
    CHECK_EQUAL(found, 11);
    CHECK_EQUAL(mgdt_periodic_get_array(p, MGDT_PERIODIC_ARRAY_POINTS, 3, &value),
                MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_periodic_get_doubles(p, MGDT_PERIODIC_ARRAY_POINT_MAP, 3, x),
                MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_periodic_get_array(p, MGDT_PERIODIC_ARRAY_POINT_MAP, 0, &value),
                MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_periodic_get_array(p, MGDT_PERIODIC_ARRAY_POINT_MAP, -1, &value),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_periodic_get_array(p, MGDT_PERIODIC_ARRAY_POINT_MAP, 1, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_periodic_get_array_i32(p, MGDT_PERIODIC_ARRAY_POINT_MAP, 1, &small), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_get_doubles(p, MGDT_PERIODIC_ARRAY_POINTS, 2, x),
                MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_periodic_get_error(p, 0, text), MGDT_ERR_INVALID_ARGUMENT);
    mgdt_periodic_destroy(p);
    mgdt_periodic_destroy(NULL);
    /* A slab with one point has no cells. */
    CHECK_EQUAL(new_box(2, cube, &p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, 1, cube), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_check(p), MGDT_OK);
    CHECK_EQUAL(stat_of(p, MGDT_PERIODIC_STAT_VERTICES), 1);
    CHECK_EQUAL(mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_VOLUME, 1, x),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK(says(p, "the points do not span space"));
    mgdt_periodic_destroy(p);
}

static void refused_memory(void) {
    double* const xyz = random_points(40, 0, 3);
    int64_t n, failures = 0;
    int done = 0;
    for (n = 1; !done; ++n) {
        counting_allocator a = {0, 0, n, 0, NULL, NULL};
        mgdt_periodic* p = NULL;
        mgdt_voronoi* v = NULL;
        double volumes[40];
        int64_t size;
        mgdt_status status =
            mgdt_periodic_create_with_allocator(counted_allocate, counted_release, &a, &p);
        if (status == MGDT_OK) status = mgdt_periodic_set_vectors(p, 3, cube);
        if (status == MGDT_OK) status = mgdt_periodic_insert_points(p, 40, xyz);
        if (status == MGDT_OK) status = mgdt_periodic_build(p);
        if (status == MGDT_OK) status = mgdt_periodic_check(p);
        if (status == MGDT_OK)
            status = mgdt_periodic_get_size(p, MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS, &size);
        if (status == MGDT_OK)
            status = mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_VOLUME, 40, volumes);
        if (status == MGDT_OK) status = mgdt_periodic_create_voronoi(p, &v);
        if (status == MGDT_OK) status = mgdt_periodic_move_points(p, 40, NULL, xyz);
        if (status == MGDT_OK) status = mgdt_periodic_build(p);
        mgdt_voronoi_destroy(v);
        done = a.calls < n;
        if (!done && status == MGDT_ERR_OUT_OF_MEMORY) {
            ++failures;
            if (p != NULL) {
                if (stat_of(p, MGDT_PERIODIC_STAT_POINTS) == 0)
                    CHECK_EQUAL(mgdt_periodic_insert_points(p, 40, xyz), MGDT_OK);
                CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
                CHECK_EQUAL(mgdt_periodic_check(p), MGDT_OK);
            }
        } else {
            CHECK_EQUAL(status, MGDT_OK);
        }
        mgdt_periodic_destroy(p);
        CHECK_EQUAL(a.blocks, 0);
    }
    CHECK(failures > 50);
    free(xyz);
}

static void memory_limit(void) {
    mgdt_periodic* const p = make_periodic(3, cube, 500);
    CHECK_EQUAL(mgdt_periodic_set_option(p, MGDT_PERIODIC_OPTION_MEMORY_LIMIT, 100000), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_ERR_OUT_OF_MEMORY);
    CHECK_EQUAL(mgdt_periodic_set_option(p, MGDT_PERIODIC_OPTION_MEMORY_LIMIT, 1 << 25), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
    CHECK(stat_of(p, MGDT_PERIODIC_STAT_MEMORY_BYTES) > 100000);
    mgdt_periodic_destroy(p);
}

typedef struct {
    mgdt_periodic* p;
    double last;
    int calls, stop_after;
} watch;

static int32_t report(double fraction, void* user) {
    watch* const w = user;
    double x[3];
    int64_t size;
    mgdt_voronoi* v = NULL;
    CHECK(fraction >= w->last && fraction <= 1);
    w->last = fraction;
    CHECK_EQUAL(mgdt_periodic_build(w->p), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_periodic_check(w->p), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_periodic_clear(w->p), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_periodic_insert_points(w->p, 1, cube), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_periodic_move_points(w->p, 0, NULL, NULL), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_periodic_set_option(w->p, MGDT_PERIODIC_OPTION_THREADS, 1), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_periodic_set_progress(w->p, NULL, NULL), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_periodic_get_size(w->p, MGDT_PERIODIC_ARRAY_POINTS, &size), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_periodic_get_cell_measures(w->p, MGDT_MEASURE_VOLUME, 1, x), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_periodic_create_voronoi(w->p, &v), MGDT_ERR_BUSY);
    mgdt_periodic_destroy(w->p);
    return ++w->calls == w->stop_after;
}

static void progress(void) {
    watch w = {NULL, 0, 0, 0};
    mgdt_voronoi* v = NULL;
    int calls, i;
    w.p = make_periodic(3, oblique, 300);
    CHECK_EQUAL(mgdt_periodic_set_progress(w.p, report, &w), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(w.p), MGDT_OK);
    CHECK(w.last == 1 && w.calls > 3);
    calls = w.calls;
    for (i = 1; i < calls; ++i) {
        w.last = 0;
        w.calls = 0;
        w.stop_after = i;
        CHECK_EQUAL(mgdt_periodic_build(w.p), MGDT_ERR_CANCELLED);
        CHECK_EQUAL(w.calls, i);
        CHECK_EQUAL(stat_of(w.p, MGDT_PERIODIC_STAT_TETRAHEDRA), 0);
    }
    CHECK_EQUAL(mgdt_periodic_set_progress(w.p, NULL, NULL), MGDT_OK);
    /* A request waits for the next call, unless it is withdrawn. */
    CHECK_EQUAL(mgdt_periodic_cancel(w.p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(w.p), MGDT_ERR_CANCELLED);
    CHECK_EQUAL(mgdt_periodic_build(w.p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_cancel(w.p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_check(w.p), MGDT_ERR_CANCELLED);
    CHECK_EQUAL(mgdt_periodic_check(w.p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_cancel(w.p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_create_voronoi(w.p, &v), MGDT_ERR_CANCELLED);
    CHECK_EQUAL(mgdt_periodic_create_voronoi(w.p, &v), MGDT_OK);
    mgdt_voronoi_destroy(v);
    CHECK_EQUAL(mgdt_periodic_cancel(w.p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_clear(w.p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(w.p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_cancel(NULL), MGDT_ERR_NULL_POINTER);
    mgdt_periodic_destroy(w.p);
}

void test_periodic_limits(void) {
    bad_arguments();
    refused_memory();
    memory_limit();
    progress();
}
