/* SPDX-License-Identifier: MIT
 * Names, versions and statistics. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

static const mgdt_status statuses[] = {MGDT_OK,
                                       MGDT_ERR_NULL_POINTER,
                                       MGDT_ERR_INVALID_ARGUMENT,
                                       MGDT_ERR_NOT_FINITE,
                                       MGDT_ERR_UNKNOWN_SCHEME,
                                       MGDT_ERR_UNKNOWN_KEY,
                                       MGDT_ERR_INDEX_RANGE,
                                       MGDT_ERR_BUFFER_TOO_SMALL,
                                       MGDT_ERR_OUT_OF_MEMORY,
                                       MGDT_ERR_TOO_LARGE,
                                       MGDT_ERR_CANCELLED,
                                       MGDT_ERR_BUSY,
                                       MGDT_ERR_TRANSPORT,
                                       MGDT_ERR_CHECK_FAILED,
                                       MGDT_ERR_INVALID_BOUNDARY,
                                       MGDT_ERR_RESOLUTION,
                                       MGDT_ERR_OPEN_BOUNDARY,
                                       MGDT_ERR_NOT_BUILT,
                                       MGDT_ERR_INTERNAL};

static const int32_t stats[] = {MGDT_STAT_POINTS_INSERTED,
                                MGDT_STAT_DUPLICATES,
                                MGDT_STAT_WALK_STEPS,
                                MGDT_STAT_WALK_TESTS,
                                MGDT_STAT_CONFLICT_TESTS,
                                MGDT_STAT_TETRAHEDRA_REMOVED,
                                MGDT_STAT_TETRAHEDRA_CREATED,
                                MGDT_STAT_EXACT_CALLS,
                                MGDT_STAT_ORDER_SECONDS,
                                MGDT_STAT_INSERT_SECONDS,
                                MGDT_STAT_GRID_LEVELS,
                                MGDT_STAT_ROUNDS,
                                MGDT_STAT_MEMORY_BYTES,
                                MGDT_STAT_PEAK_MEMORY_BYTES,
                                MGDT_STAT_PUT_OFF,
                                MGDT_STAT_INSERTED_ALONE,
                                MGDT_STAT_THREADS};

static void status_strings(void) {
    const char* unknown = mgdt_status_string(12345);
    const size_t n = sizeof statuses / sizeof statuses[0];
    size_t i, j;
    CHECK(unknown != NULL && *unknown != '\0');
    CHECK(mgdt_status_string(-1) != NULL);
    for (i = 0; i < n; ++i) {
        const char* text = mgdt_status_string(statuses[i]);
        CHECK(text != NULL && *text != '\0' && strchr(text, '\n') == NULL);
        CHECK(strcmp(text, unknown) != 0);
        for (j = 0; j < i; ++j) CHECK(strcmp(text, mgdt_status_string(statuses[j])) != 0);
    }
}

static void schemes(void) {
    static const struct {
        int32_t scheme;
        const char* name;
    } known[] = {{MGDT_ORDER_AUTO, "auto"},
                 {MGDT_ORDER_INPUT, "input"},
                 {MGDT_ORDER_RANDOM, "random"},
                 {MGDT_ORDER_LEXICOGRAPHIC, "lexicographic"},
                 {MGDT_ORDER_BRIO, "brio"},
                 {MGDT_ORDER_HILBERT, "hilbert"},
                 {MGDT_ORDER_REGULAR_GRID, "regular-grid"},
                 {MGDT_ORDER_KD_TREE, "kd-tree"},
                 {MGDT_ORDER_ENHANCED_KD_TREE, "enhanced-kd-tree"},
                 {MGDT_ORDER_MULTI_GRID, "multi-grid"}};
    static const char* const wrong[] = {"", "multi", "multi-grid ", "MULTI-GRID", "grid"};
    int32_t scheme = 777;
    size_t i;
    for (i = 0; i < sizeof known / sizeof known[0]; ++i) {
        const char* name = mgdt_order_scheme_name(known[i].scheme);
        CHECK(name != NULL && strcmp(name, known[i].name) == 0);
        CHECK_EQUAL(mgdt_order_scheme_from_name(known[i].name, &scheme), MGDT_OK);
        CHECK_EQUAL(scheme, known[i].scheme);
    }
    /* Listed in this order, and no others. */
    for (i = 0; i < sizeof known / sizeof known[0]; ++i) {
        CHECK_EQUAL(mgdt_order_scheme_at((int32_t)i, &scheme), MGDT_OK);
        CHECK_EQUAL(scheme, known[i].scheme);
    }
    scheme = 777;
    CHECK_EQUAL(mgdt_order_scheme_at((int32_t)i, &scheme), MGDT_ERR_UNKNOWN_SCHEME);
    CHECK_EQUAL(mgdt_order_scheme_at(INT32_MAX, &scheme), MGDT_ERR_UNKNOWN_SCHEME);
    CHECK_EQUAL(mgdt_order_scheme_at(-1, &scheme), MGDT_ERR_UNKNOWN_SCHEME);
    CHECK_EQUAL(mgdt_order_scheme_at(INT32_MIN, &scheme), MGDT_ERR_UNKNOWN_SCHEME);
    CHECK_EQUAL(scheme, 777);
    CHECK_EQUAL(mgdt_order_scheme_at(0, NULL), MGDT_ERR_NULL_POINTER);
    CHECK(mgdt_order_scheme_name(1) == NULL);
    CHECK(mgdt_order_scheme_name(-1) == NULL);
    CHECK(mgdt_order_scheme_name(91) == NULL);
    scheme = 777;
    for (i = 0; i < sizeof wrong / sizeof wrong[0]; ++i)
        CHECK_EQUAL(mgdt_order_scheme_from_name(wrong[i], &scheme), MGDT_ERR_UNKNOWN_SCHEME);
    CHECK_EQUAL(mgdt_order_scheme_from_name(NULL, &scheme), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(scheme, 777);
    CHECK_EQUAL(mgdt_order_scheme_from_name("brio", NULL), MGDT_ERR_NULL_POINTER);
}

static void versions(void) {
    char expected[64];
    mgdt_triangulation* t = NULL;
    snprintf(expected, sizeof expected, "%d.%d.%d", MGDT_VERSION_MAJOR, MGDT_VERSION_MINOR,
             MGDT_VERSION_PATCH);
    CHECK(strcmp(mgdt_version_string(), expected) == 0);
    CHECK_EQUAL(mgdt_abi_version(), 1);
    CHECK(MGDT_VERSION_AT_LEAST(1, 2) && MGDT_VERSION_AT_LEAST(0, 99));
    CHECK(MGDT_VERSION_AT_LEAST(MGDT_VERSION_MAJOR, MGDT_VERSION_MINOR));
    CHECK(!MGDT_VERSION_AT_LEAST(MGDT_VERSION_MAJOR, MGDT_VERSION_MINOR + 1));
    CHECK(!MGDT_VERSION_AT_LEAST(MGDT_VERSION_MAJOR + 1, 0));
    CHECK(mgdt_isa_name(NULL) != NULL && strcmp(mgdt_isa_name(NULL), "") == 0);
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    CHECK(mgdt_isa_name(t) != NULL && strcmp(mgdt_isa_name(t), "") != 0);
    mgdt_destroy(t);
}

static double stat_of(const mgdt_triangulation* t, int32_t key) {
    double value = -1;
    CHECK_EQUAL(mgdt_get_stat(t, key, &value), MGDT_OK);
    CHECK(value >= 0);
    return value;
}

static void statistics(void) {
    const int64_t n = 1000;
    double *xyz = random_points(n, 0, 5), *again = random_points(n, 0, 6);
    mgdt_triangulation* t = NULL;
    double value = 4.5, created, removed, memory;
    size_t i;
    for (i = 0; i < sizeof stats / sizeof stats[0]; ++i) {
        const char* name = mgdt_stat_name(stats[i]);
        CHECK(name != NULL && *name != '\0');
    }
    CHECK(strcmp(mgdt_stat_name(MGDT_STAT_WALK_STEPS), "walk steps") == 0);
    CHECK(mgdt_stat_name(0) == NULL);
    CHECK(mgdt_stat_name(-5) == NULL);

    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    CHECK_EQUAL(mgdt_get_stat(t, 9999, &value), MGDT_ERR_UNKNOWN_KEY);
    CHECK_ERROR(t, "9999");
    CHECK(value == 4.5);
    for (i = 0; i < sizeof stats / sizeof stats[0]; ++i)
        if (stats[i] < MGDT_STAT_MEMORY_BYTES) CHECK(stat_of(t, stats[i]) == 0);
    memory = stat_of(t, MGDT_STAT_MEMORY_BYTES);
    CHECK(memory > 0);

    memcpy(again, xyz, 30 * sizeof *xyz); /* ten repeats */
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    CHECK(stat_of(t, MGDT_STAT_POINTS_INSERTED) == 1000);
    CHECK(stat_of(t, MGDT_STAT_DUPLICATES) == 0);
    CHECK_EQUAL(mgdt_insert_points(t, n, again), MGDT_OK);
    CHECK(stat_of(t, MGDT_STAT_POINTS_INSERTED) == 1990);
    CHECK(stat_of(t, MGDT_STAT_DUPLICATES) == 10);
    CHECK_EQUAL(mgdt_vertex_count(t), 1990);

    created = stat_of(t, MGDT_STAT_TETRAHEDRA_CREATED);
    removed = stat_of(t, MGDT_STAT_TETRAHEDRA_REMOVED);
    CHECK(removed > 10 * 1990 && removed < 60 * 1990);
    CHECK(created - removed >= (double)mgdt_tetrahedron_count(t));
    CHECK(stat_of(t, MGDT_STAT_WALK_STEPS) >= 1980);
    CHECK(stat_of(t, MGDT_STAT_WALK_TESTS) >= 1980);
    CHECK(stat_of(t, MGDT_STAT_CONFLICT_TESTS) >= removed);
    CHECK(stat_of(t, MGDT_STAT_INSERT_SECONDS) > 0);
    CHECK(stat_of(t, MGDT_STAT_ORDER_SECONDS) > 0);
    CHECK(stat_of(t, MGDT_STAT_ROUNDS) >= 1);
    CHECK(stat_of(t, MGDT_STAT_MEMORY_BYTES) > 1990 * (double)sizeof(double) * 3);
    CHECK(stat_of(t, MGDT_STAT_PEAK_MEMORY_BYTES) >= stat_of(t, MGDT_STAT_MEMORY_BYTES));

    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    CHECK(stat_of(t, MGDT_STAT_POINTS_INSERTED) == 0);
    CHECK(stat_of(t, MGDT_STAT_WALK_STEPS) == 0);
    CHECK(stat_of(t, MGDT_STAT_TETRAHEDRA_CREATED) == 0);
    mgdt_destroy(t);
    free(xyz);
    free(again);
}

/* Lattices cannot be decided by the filter; random points nearly always can. */
static void exact_calls(void) {
    double *random = random_points(400, 0, 8), *lattice = random_points(400, 6, 8);
    mgdt_triangulation *a = make(400, random), *b = make(400, lattice);
    if (a != NULL && b != NULL)
        CHECK(stat_of(a, MGDT_STAT_EXACT_CALLS) < stat_of(b, MGDT_STAT_EXACT_CALLS));
    mgdt_destroy(a);
    mgdt_destroy(b);
    free(random);
    free(lattice);
}

void test_text(void) {
    status_strings();
    schemes();
    versions();
    statistics();
    exact_calls();
}
