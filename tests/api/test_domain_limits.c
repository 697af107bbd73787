/* SPDX-License-Identifier: MIT
 * Domains: arguments that are refused, memory that ends, progress and cancellation. */
#define _POSIX_C_SOURCE 200112L
#include "../support/counting_allocator.h"
#include "domain_box.h"

static void bad_arguments(void) {
    const int64_t wrong[3] = {0, 1, 13}, bad_offsets[3] = {0, 3, 5}, late[2] = {1, 4},
                  lowest[2] = {INT64_MIN, 3}, descending[3] = {0, 1000000, 3};
    double nan[3] = {0, NAN, 0};
    mgdt_domain *d = make_box(0), *none = (mgdt_domain*)&nan;
    mgdt_mesh* m = (mgdt_mesh*)&nan;
    mgdt_progress_fn fn;
    int64_t value = 5, values[8];
    int32_t narrow[8], columns = -5, is_double = -5;
    char text[8];
    CHECK_EQUAL(mgdt_domain_create(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_create_with_allocator(NULL, counted_release, NULL, &none),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK(none == NULL);
    CHECK_EQUAL(mgdt_domain_create_with_allocator(NULL, NULL, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_clear(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_cancel(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_build(NULL, &m), MGDT_ERR_NULL_POINTER);
    CHECK(m == NULL);
    CHECK_EQUAL(mgdt_domain_build(d, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_validate(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_check(NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_check(d, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_get_progress(NULL, &fn, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_get_progress(d, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_set_progress(NULL, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_set_option(d, 9, 0), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_domain_get_option(d, 9, &value), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_domain_get_option(d, MGDT_DOMAIN_OPTION_THREADS, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_INDEX_BASE, 2),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_THREADS, -1),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_MEMORY_LIMIT, -1),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_ROUND_POINTS, 2),
                MGDT_ERR_INVALID_ARGUMENT);
    check_message(d, "2 is out of the range of option 40");
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_THREADS, 3), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_get_option(d, MGDT_DOMAIN_OPTION_THREADS, &value), MGDT_OK);
    CHECK_EQUAL(value, 3);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_ROUND_POINTS, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_get_option(d, MGDT_DOMAIN_OPTION_ROUND_POINTS, &value), MGDT_OK);
    CHECK_EQUAL(value, 1);
    CHECK_EQUAL(mgdt_domain_get_option(d, MGDT_DOMAIN_OPTION_MEMORY_LIMIT, &value), MGDT_OK);
    CHECK_EQUAL(value, 0);
    CHECK_EQUAL(mgdt_domain_set_points(d, -1, box), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_set_points(d, 3, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_set_points(d, INT64_MAX, box), MGDT_ERR_TOO_LARGE);
    CHECK_EQUAL(mgdt_domain_set_points(d, 1, nan), MGDT_ERR_NOT_FINITE);
    check_message(d, "y of point 0");
    CHECK_EQUAL(mgdt_domain_set_facets(d, 1, NULL, wrong, NULL), MGDT_ERR_INVALID_ARGUMENT);
    check_message(d, "facet 0 has the corner 13; there are 13 points");
    CHECK_EQUAL(mgdt_domain_set_facets(d, 2, bad_offsets, wrong, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_set_facets(d, 1, late, wrong, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_set_facets(d, 1, lowest, wrong, NULL), MGDT_ERR_INVALID_ARGUMENT);
    check_message(d, "facet 0 has offsets");
    /* No corner is read before all offsets have been looked at. */
    CHECK_EQUAL(mgdt_domain_set_facets(d, 2, descending, wrong, NULL), MGDT_ERR_INVALID_ARGUMENT);
    check_message(d, "facet 1 has offsets");
    CHECK_EQUAL(mgdt_domain_set_facets(d, -1, NULL, wrong, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_set_facets(d, 1, NULL, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_set_facets(d, INT64_MAX, NULL, wrong, NULL), MGDT_ERR_TOO_LARGE);
    CHECK_EQUAL(mgdt_domain_set_segments(d, 1, wrong + 1, NULL), MGDT_ERR_INVALID_ARGUMENT);
    check_message(d, "segment 0 has the corner 13");
    CHECK_EQUAL(mgdt_domain_set_segments(d, 1, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_set_segments(d, -1, wrong, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_set_segments_i32(d, -1, narrow, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_set_facets_i32(d, -1, NULL, narrow, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_set_regions(d, 1, nan, NULL), MGDT_ERR_NOT_FINITE);
    check_message(d, "coordinate y of place 0");
    CHECK_EQUAL(mgdt_domain_set_regions(d, 1, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_set_regions(d, -1, box, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_set_regions(d, INT64_MAX, box, NULL), MGDT_ERR_TOO_LARGE);
    CHECK_EQUAL(mgdt_domain_set_holes(d, 1, nan), MGDT_ERR_NOT_FINITE);
    CHECK_EQUAL(mgdt_domain_set_holes(d, 1, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_set_holes(d, -1, box), MGDT_ERR_INVALID_ARGUMENT);
    /* None of these calls has changed anything. */
    m = mesh_of(d);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_IS_ROUNDED), 1);
    CHECK(fabs(volume_of(m, 0) - 6 * 64) < 1e-9);
    mgdt_mesh_destroy(m);
    /* A key of another kind is unknown. */
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_STAT_POINTS, 1), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_domain_get_stat(d, MGDT_DOMAIN_OPTION_THREADS, &value), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_domain_get_stat(d, MGDT_DOMAIN_ARRAY_OPEN_EDGES, &value),
                MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_domain_get_array(d, MGDT_DOMAIN_STAT_POINTS, 8, values), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_domain_get_array(d, MGDT_MESH_ARRAY_TETRAHEDRA + 1, 8, values),
                MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_domain_get_stat(d, MGDT_DOMAIN_STAT_FACETS, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_get_stat(NULL, MGDT_DOMAIN_STAT_FACETS, &value), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_get_size(d, 9, &value), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_domain_get_size(d, MGDT_DOMAIN_ARRAY_OPEN_EDGES, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_array_info(MGDT_DOMAIN_ARRAY_OPEN_EDGES, &columns, &is_double),
                MGDT_OK);
    CHECK(columns == 3 && is_double == 0);
    CHECK_EQUAL(mgdt_domain_array_info(MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS, &columns, NULL), MGDT_OK);
    CHECK_EQUAL(columns, 4);
    CHECK_EQUAL(mgdt_domain_array_info(MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS, NULL, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_array_info(MGDT_DOMAIN_STAT_POINTS, &columns, &is_double),
                MGDT_ERR_UNKNOWN_KEY);
    CHECK(columns == 4 && is_double == 0);
    /* An open surface has edges. */
    CHECK_EQUAL(mgdt_domain_set_facets(d, 5, offsets, quads, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_validate(d), MGDT_OK);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_OPEN_EDGES), 4);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_OPEN_EDGES), 12);
    CHECK_EQUAL(mgdt_domain_get_array(d, MGDT_DOMAIN_ARRAY_OPEN_EDGES, -1, values),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_get_array(d, MGDT_DOMAIN_ARRAY_OPEN_EDGES, 8, values),
                MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_domain_get_array_i32(d, MGDT_DOMAIN_ARRAY_OPEN_EDGES, 8, narrow),
                MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_domain_get_array(d, MGDT_DOMAIN_ARRAY_OPEN_EDGES, 1000, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_get_error(NULL, 8, text), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_get_error(d, 0, text), MGDT_ERR_INVALID_ARGUMENT);
    mgdt_domain_destroy(d);
    mgdt_domain_destroy(NULL);
}

static void cancel(void* d) {
    mgdt_domain_cancel(d);
}

static void refused_memory(void) {
    int64_t n, failures = 0, cancelled = 0;
    int done = 0;
    for (n = 1; !done; ++n) {
        counting_allocator a = {0, 0, n, 0, NULL, NULL};
        mgdt_domain* d = NULL;
        mgdt_mesh* m = NULL;
        mgdt_status status =
            mgdt_domain_create_with_allocator(counted_allocate, counted_release, &a, &d);
        if (status == MGDT_OK) status = give_box(d, 0);
        if (status == MGDT_OK) status = mgdt_domain_build(d, &m);
        done = a.calls < n;
        if (!done && status == MGDT_ERR_OUT_OF_MEMORY) {
            ++failures;
            if (d != NULL) {
                CHECK(m == NULL);
                CHECK_EQUAL(give_box(d, 0), MGDT_OK);
                CHECK_EQUAL(mgdt_domain_build(d, &m), MGDT_OK);
            }
        } else {
            /* A buffer that is refused half as much again takes what it needs. */
            CHECK_EQUAL(status, MGDT_OK);
        }
        if (m != NULL && n % 16 == 0) CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_OK);
        mgdt_mesh_destroy(m);
        mgdt_domain_destroy(d);
        CHECK_EQUAL(a.blocks, 0);
    }
    CHECK(failures > 100);
    for (n = 2, done = 0; !done; n += 5) {
        counting_allocator a = {0, 0, 0, n, cancel, NULL};
        mgdt_domain* d = NULL;
        mgdt_status status;
        CHECK_EQUAL(mgdt_domain_create_with_allocator(counted_allocate, counted_release, &a, &d),
                    MGDT_OK);
        a.on = d;
        CHECK_EQUAL(give_box(d, 0), MGDT_OK);
        status = build(d);
        done = a.calls < n;
        if (status == MGDT_ERR_CANCELLED) {
            ++cancelled;
            CHECK_EQUAL(build(d), MGDT_OK);
        } else {
            CHECK_EQUAL(status, MGDT_OK);
        }
        mgdt_domain_destroy(d);
        CHECK_EQUAL(a.blocks, 0);
    }
    CHECK(cancelled > 20);
}

static void memory_limit(void) {
    mgdt_domain* const d = make_box(0);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_MEMORY_LIMIT, 4096), MGDT_OK);
    CHECK_EQUAL(build(d), MGDT_ERR_OUT_OF_MEMORY);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_MEMORY_LIMIT, 1 << 24), MGDT_OK);
    CHECK_EQUAL(build(d), MGDT_OK);
    mgdt_domain_destroy(d);
}

typedef struct {
    mgdt_domain* d;
    mgdt_mesh* m;
    double last;
    int calls, stop_after;
} watch;

static int32_t report(double fraction, void* user) {
    watch* const w = user;
    CHECK(fraction >= w->last && fraction <= 1);
    w->last = fraction;
    CHECK_EQUAL(build(w->d), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_domain_clear(w->d), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_domain_validate(w->d), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_domain_clean(w->d), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_domain_set_double_option(w->d, MGDT_DOMAIN_OPTION_WELD, 0), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_domain_check(w->d, w->m), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_domain_set_points(w->d, 13, box), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_domain_set_facets(w->d, 0, NULL, NULL, NULL), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_domain_set_segments(w->d, 0, NULL, NULL), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_domain_set_regions(w->d, 1, box, NULL), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_domain_set_holes(w->d, 1, box), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_domain_set_option(w->d, MGDT_DOMAIN_OPTION_THREADS, 1), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_domain_set_progress(w->d, NULL, NULL), MGDT_ERR_BUSY);
    mgdt_domain_destroy(w->d);
    return ++w->calls == w->stop_after;
}

static void progress(void) {
    watch w = {NULL, NULL, 0, 0, 0};
    mgdt_progress_fn fn = NULL;
    void* user = NULL;
    int calls, i;
    w.d = make_box(0);
    w.m = mesh_of(w.d);
    CHECK_EQUAL(mgdt_domain_set_progress(w.d, report, &w), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_get_progress(w.d, &fn, &user), MGDT_OK);
    CHECK(fn == report && user == &w);
    CHECK_EQUAL(mgdt_domain_get_progress(w.d, &fn, NULL), MGDT_OK);
    CHECK_EQUAL(build(w.d), MGDT_OK);
    CHECK(w.last == 1 && w.calls > 4);
    calls = w.calls;
    for (i = 1; i < calls; ++i) {
        w.last = 0;
        w.calls = 0;
        w.stop_after = i;
        CHECK_EQUAL(build(w.d), MGDT_ERR_CANCELLED);
        CHECK_EQUAL(w.calls, i);
    }
    /* The last report comes too late. */
    w.last = w.calls = 0;
    w.stop_after = calls;
    CHECK_EQUAL(build(w.d), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_progress(w.d, NULL, NULL), MGDT_OK);
    /* A request waits for the next call, unless it is withdrawn. */
    CHECK_EQUAL(mgdt_domain_cancel(w.d), MGDT_OK);
    CHECK_EQUAL(build(w.d), MGDT_ERR_CANCELLED);
    CHECK_EQUAL(build(w.d), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_cancel(w.d), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_validate(w.d), MGDT_ERR_CANCELLED);
    CHECK_EQUAL(mgdt_domain_cancel(w.d), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_clean(w.d), MGDT_ERR_CANCELLED);
    CHECK_EQUAL(mgdt_domain_cancel(w.d), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_clear(w.d), MGDT_OK);
    CHECK_EQUAL(give_box(w.d, 0), MGDT_OK);
    CHECK_EQUAL(build(w.d), MGDT_OK);
    mgdt_mesh_destroy(w.m);
    mgdt_domain_destroy(w.d);
}

void test_domain_limits(void) {
    bad_arguments();
    refused_memory();
    memory_limit();
    progress();
}
