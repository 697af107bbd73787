/* SPDX-License-Identifier: MIT
 * The progress callback, and stopping by it or by mgdt_cancel(). */
#define _POSIX_C_SOURCE 200112L
#include <stdlib.h>

#include "../support/aligned.h"
#include "check.h"

typedef struct {
    mgdt_triangulation* t;
    int64_t calls, stop_at; /* the call that asks to stop; -1 for none */
    int by_function;        /* by mgdt_cancel() instead of the return value */
    int in_order;
    double last;
} watch;

static int32_t observe(double fraction, void* user) {
    watch* w = user;
    if (++w->calls == 1) w->in_order &= fraction == 0;
    w->in_order &= fraction >= w->last && fraction >= 0 && fraction <= 1;
    w->last = fraction;
    if (w->calls != w->stop_at) return 0;
    if (!w->by_function) return 1;
    w->in_order &= mgdt_cancel(w->t) == MGDT_OK;
    return 0;
}

static watch start(mgdt_triangulation* t, int64_t stop_at, int by_function) {
    watch w;
    w.t = t;
    w.calls = 0;
    w.stop_at = stop_at;
    w.by_function = by_function;
    w.in_order = 1;
    w.last = 0;
    return w;
}

static void progress(int64_t n, const double* xyz) {
    mgdt_triangulation* t = NULL;
    watch w;
    int64_t calls, *map;
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    w = start(t, -1, 0);
    CHECK_EQUAL(mgdt_set_progress(t, observe, &w), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    CHECK(w.in_order);
    CHECK(w.calls >= 10 && w.calls <= 1000);
    CHECK(w.last == 1);
    calls = w.calls;
    /* Insertions of points alone report, unless calls that read are to do so. */
    CHECK_EQUAL(mgdt_insert_points(t, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_reserve(t, 3 * n), MGDT_OK);
    CHECK_EQUAL(mgdt_set_compact(t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_set_compact(t, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    map = get_array(mgdt_get_point_map, t, n);
    CHECK_EQUAL(mgdt_locate_points(t, n, xyz, map, NULL), MGDT_OK);
    free(map);
    CHECK_EQUAL(w.calls, calls);
    CHECK_EQUAL(mgdt_set_progress(t, NULL, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    CHECK_EQUAL(w.calls, calls);
    mgdt_destroy(t);
}

/* After a stop: a valid triangulation of what got in, and insertion goes on to the full result. */
static void stops(int64_t n, const double* xyz, const mgdt_triangulation* expected) {
    int by_function, k;
    for (by_function = 0; by_function < 2; ++by_function)
        for (k = 1; k <= 40; k += 13) {
            mgdt_triangulation* t = NULL;
            watch w;
            int64_t *map, i, in = 0;
            double inserted = -1;
            CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
            w = start(t, k, by_function);
            CHECK_EQUAL(mgdt_set_progress(t, observe, &w), MGDT_OK);
            CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_ERR_CANCELLED);
            CHECK(w.in_order);
            /* A stop is a stop: at most the call that is on its way comes after it. */
            CHECK(w.calls >= k && w.calls <= k + 1);
            CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
            CHECK_EQUAL(mgdt_point_count(t), n);
            CHECK(mgdt_vertex_count(t) < mgdt_vertex_count(expected));
            map = get_array(mgdt_get_point_map, t, n);
            for (i = 0; i < n; ++i) in += map[i] == i;
            free(map);
            CHECK_EQUAL(in, mgdt_vertex_count(t));
            CHECK_EQUAL(mgdt_get_stat(t, MGDT_STAT_POINTS_INSERTED, &inserted), MGDT_OK);
            CHECK_EQUAL((int64_t)inserted, in);
            CHECK_EQUAL(mgdt_set_progress(t, NULL, NULL), MGDT_OK);
            CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
            CHECK_EQUAL(mgdt_vertex_count(t), mgdt_vertex_count(expected));
            CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
            CHECK(same_tetrahedra(t, expected, NULL));
            mgdt_destroy(t);
        }
}

/* Between calls, a request to stop waits for the next insertion, and for that one alone. */
static void before_a_call(int64_t n, const double* xyz, const mgdt_triangulation* expected) {
    mgdt_triangulation* t = NULL;
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    CHECK_EQUAL(mgdt_cancel(t), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_ERR_CANCELLED);
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    CHECK(same_tetrahedra(t, expected, NULL));
    /* Also while a triangulation stands. */
    CHECK_EQUAL(mgdt_cancel(t), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_ERR_CANCELLED);
    CHECK(same_tetrahedra(t, expected, NULL));
    /* No points are no insertion. */
    CHECK_EQUAL(mgdt_cancel(t), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_ERR_CANCELLED);
    /* Clearing withdraws the request, but not one that comes after. */
    CHECK_EQUAL(mgdt_cancel(t), MGDT_OK);
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    CHECK(same_tetrahedra(t, expected, NULL));
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    CHECK_EQUAL(mgdt_cancel(t), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_ERR_CANCELLED);
    mgdt_destroy(t);
}

/* Points that were accepted while they did not span space are not lost to a stop later on. */
static void held_points_stay(void) {
    const int64_t n = is_small() ? 300 : 3000;
    double* flat = random_points(n, 0, 7);
    double* more = random_points(n, 0, 8);
    mgdt_triangulation* t = NULL;
    watch w;
    int64_t i, *map;
    for (i = 0; i < n; ++i) flat[3 * i + 2] = 0;
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    w = start(t, -1, 0);
    CHECK_EQUAL(mgdt_set_progress(t, observe, &w), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, flat), MGDT_OK);
    CHECK_EQUAL(mgdt_dimension(t), 2);
    CHECK(w.last == 1);
    w = start(t, 10, 0);
    CHECK_EQUAL(mgdt_insert_points(t, n, more), MGDT_ERR_CANCELLED);
    CHECK_EQUAL(mgdt_dimension(t), 3);
    map = get_array(mgdt_get_point_map, t, 2 * n);
    for (i = 0; i < n; ++i) CHECK_EQUAL(map[i], i);
    CHECK_EQUAL(map[2 * n - 1] >= 0 && mgdt_vertex_count(t) == 2 * n, 0);
    free(map);
    mgdt_destroy(t);
    free(flat);
    free(more);
}

/* A request to stop ends with the call that it reached, also when that fails for another reason. */
static void* cancel_and_refuse(size_t size, size_t align, void* user) {
    watch* w = user;
    if (w->stop_at != 0 && size >= 4096) {
        mgdt_cancel(w->t);
        return NULL;
    }
    return allocate_aligned(size, align);
}

static void give(void* p, size_t size, size_t align, void* user) {
    (void)size;
    (void)align;
    (void)user;
    free_aligned(p);
}

static void requests_end(void) {
    double* xyz = random_points(2000, 0, 9);
    mgdt_triangulation* t = NULL;
    watch w = start(NULL, 0, 0);
    CHECK_EQUAL(mgdt_create_with_allocator(cancel_and_refuse, give, &w, &t), MGDT_OK);
    if (t != NULL) {
        w.t = t;
        CHECK_EQUAL(mgdt_insert_points(t, 100, xyz), MGDT_OK);
        w.stop_at = 1;
        CHECK(mgdt_insert_points(t, 2000, xyz) != MGDT_OK);
        w.stop_at = 0;
        CHECK_EQUAL(mgdt_insert_points(t, 2000, xyz), MGDT_OK);
        CHECK_EQUAL(mgdt_vertex_count(t), 2000);
    }
    mgdt_destroy(t);
    free(xyz);
}

void test_progress(void) {
    const int64_t n = is_small() ? 3000 : 60000;
    double* xyz = random_points(n, is_small() ? 100 : 0, 51);
    mgdt_triangulation* expected = make(n, xyz);
    progress(n, xyz);
    stops(n, xyz, expected);
    before_a_call(n, xyz, expected);
    mgdt_destroy(expected);
    free(xyz);
    held_points_stay();
    requests_end();
}
