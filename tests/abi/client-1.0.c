/* SPDX-License-Identifier: MIT
 * A program as it was compiled for version 1.0: with that version's header, against whatever
 * library is current. It calls every function and compares what it gets with what 1.0 promised.
 * Frozen like the header: if it fails, programs out there fail. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mgdt-1.0.h"

static int checks, failures;
#define CHECK(condition)                                   \
    do {                                                   \
        ++checks;                                          \
        if (!(condition)) {                                \
            ++failures;                                    \
            printf("line %d: %s\n", __LINE__, #condition); \
        }                                                  \
    } while (0)

/* Two tetrahedra on one facet, and the first point again. */
static const double six[18] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0};

static int64_t live_bytes;
static void* take(size_t size, size_t align, void* user) {
    char *raw = malloc(size + align + sizeof raw), *p;
    if (raw == NULL) return NULL;
    p = raw + sizeof raw;
    p += (align - (size_t)p % align) % align;
    memcpy(p - sizeof raw, &raw, sizeof raw);
    *(int64_t*)user += (int64_t)size;
    return p;
}
static void give(void* p, size_t size, size_t align, void* user) {
    char* raw;
    (void)align;
    memcpy(&raw, (char*)p - sizeof raw, sizeof raw);
    *(int64_t*)user -= (int64_t)size;
    free(raw);
}

static int32_t hear(double fraction, void* user) {
    *(double*)user = fraction;
    return 0;
}
static int32_t stop(double fraction, void* user) {
    (void)user;
    return fraction >= 0;
}

static double determinant(const int64_t* v) {
    const double* a = six + 3 * v[0];
    double m[9];
    int i, k;
    for (i = 0; i < 3; ++i)
        for (k = 0; k < 3; ++k) m[3 * i + k] = six[3 * v[i + 1] + k] - a[k];
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
           m[2] * (m[3] * m[7] - m[4] * m[6]);
}

static void constants_and_names(void) {
    int32_t scheme = -1;
    CHECK(mgdt_abi_version() == 1);
    CHECK(strncmp(mgdt_version_string(), "1.", 2) == 0);
    CHECK(strcmp(mgdt_order_scheme_name(MGDT_ORDER_MULTI_GRID), "multi-grid") == 0);
    CHECK(mgdt_order_scheme_name(5) == NULL);
    CHECK(mgdt_order_scheme_from_name("brio", &scheme) == MGDT_OK && scheme == MGDT_ORDER_BRIO);
    CHECK(mgdt_order_scheme_from_name("none", &scheme) == MGDT_ERR_UNKNOWN_SCHEME);
    CHECK(strcmp(mgdt_stat_name(MGDT_STAT_WALK_STEPS), "walk steps") == 0);
    CHECK(mgdt_stat_name(5) == NULL);
    CHECK(mgdt_status_string(MGDT_OK)[0] != '\0' && mgdt_status_string(-1)[0] != '\0');
}

static void settings(mgdt_triangulation* t) {
    static const int32_t schemes[] = {
        MGDT_ORDER_AUTO,          MGDT_ORDER_INPUT,   MGDT_ORDER_RANDOM,
        MGDT_ORDER_LEXICOGRAPHIC, MGDT_ORDER_BRIO,    MGDT_ORDER_HILBERT,
        MGDT_ORDER_REGULAR_GRID,  MGDT_ORDER_KD_TREE, MGDT_ORDER_ENHANCED_KD_TREE,
        MGDT_ORDER_MULTI_GRID};
    size_t k;
    for (k = 0; k < sizeof schemes / sizeof *schemes; ++k)
        CHECK(mgdt_set_order_scheme(t, schemes[k]) == MGDT_OK);
    CHECK(mgdt_set_order_scheme(t, 5) == MGDT_ERR_UNKNOWN_SCHEME);
    CHECK(mgdt_set_order_scheme(NULL, 0) == MGDT_ERR_NULL_POINTER);
    CHECK(mgdt_set_order_parameter(t, MGDT_PARAMETER_POINTS_PER_CELL, 6) == MGDT_OK);
    CHECK(mgdt_set_order_parameter(t, MGDT_PARAMETER_THRESHOLD, 100) == MGDT_OK);
    CHECK(mgdt_set_order_parameter(t, MGDT_PARAMETER_SEPARATION, 0) == MGDT_OK);
    CHECK(mgdt_set_order_parameter(t, MGDT_PARAMETER_ROUND_RATIO, 3) == MGDT_OK);
    CHECK(mgdt_set_order_parameter(t, 5, 1) == MGDT_ERR_UNKNOWN_KEY);
    CHECK(mgdt_set_seed(t, UINT64_C(0xFFFFFFFFFFFFFFFF)) == MGDT_OK);
    CHECK(mgdt_set_threads(t, 2) == MGDT_OK);
    CHECK(mgdt_set_threads(t, -1) == MGDT_ERR_INVALID_ARGUMENT);
    CHECK(mgdt_set_index_base(t, 2) == MGDT_ERR_INVALID_ARGUMENT);
    CHECK(mgdt_set_index_base(t, 0) == MGDT_OK);
    CHECK(mgdt_set_memory_limit(t, INT64_C(1) << 33) == MGDT_OK);
    CHECK(mgdt_set_canonical_output(t, 1) == MGDT_OK);
    CHECK(mgdt_set_isa(t, "baseline") == MGDT_OK);
    CHECK(strcmp(mgdt_isa_name(t), "baseline") == 0);
    CHECK(mgdt_set_isa(t, NULL) == MGDT_OK);
    CHECK(mgdt_reserve(t, 100) == MGDT_OK);
}

static void exports(const mgdt_triangulation* t) {
    static const int64_t map_expected[6] = {0, 1, 2, 3, 4, 0};
    int64_t v[8], n[8], facets[18], edges[18], map[6], offsets[7], list[8], k;
    int32_t v32[8], n32[8], facets32[18], edges32[18], map32[6], offsets32[7], list32[8];
    CHECK(mgdt_point_count(t) == 6 && mgdt_vertex_count(t) == 5 && mgdt_dimension(t) == 3);
    CHECK(mgdt_tetrahedron_count(t) == 2 && mgdt_hull_facet_count(t) == 6);
    CHECK(mgdt_edge_count(t) == 9 && mgdt_vertex_tetrahedra_count(t) == 8);
    CHECK(mgdt_get_tetrahedra(t, 7, v) == MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK(mgdt_get_tetrahedra(t, 8, v) == MGDT_OK);
    CHECK(mgdt_get_tetrahedra_i32(t, 8, v32) == MGDT_OK);
    CHECK(mgdt_get_neighbors(t, 8, n) == MGDT_OK);
    CHECK(mgdt_get_neighbors_i32(t, 8, n32) == MGDT_OK);
    CHECK(mgdt_get_hull_facets(t, 18, facets) == MGDT_OK);
    CHECK(mgdt_get_hull_facets_i32(t, 18, facets32) == MGDT_OK);
    CHECK(mgdt_get_edges(t, 18, edges) == MGDT_OK);
    CHECK(mgdt_get_edges_i32(t, 18, edges32) == MGDT_OK);
    CHECK(mgdt_get_point_map(t, 6, map) == MGDT_OK);
    CHECK(mgdt_get_point_map_i32(t, 6, map32) == MGDT_OK);
    CHECK(mgdt_get_vertex_tetrahedra(t, 7, offsets, 8, list) == MGDT_OK);
    CHECK(mgdt_get_vertex_tetrahedra_i32(t, 7, offsets32, 8, list32) == MGDT_OK);
    for (k = 0; k < 8; ++k) CHECK(v32[k] == v[k] && n32[k] == n[k] && list32[k] == list[k]);
    for (k = 0; k < 18; ++k) CHECK(facets32[k] == facets[k] && edges32[k] == edges[k]);
    for (k = 0; k < 6; ++k) CHECK(map32[k] == map[k] && map[k] == map_expected[k]);
    for (k = 0; k < 7; ++k) CHECK(offsets32[k] == offsets[k]);
    /* Canonical: sorted, the least vertex first. One of 0 1 2 3, the other of 1 2 3 4. */
    CHECK(v[0] == 0 && v[1] == 1 && v[4] == 1 && v[5] == 2);
    CHECK(determinant(v) == 1 && determinant(v + 4) == 2);
    /* The shared facet is opposite vertices 0 and 4. */
    for (k = 0; k < 8; ++k) CHECK(n[k] == (v[k] == 0 ? 1 : v[k] == 4 ? 0 : -1));
    CHECK(offsets[0] == 0 && offsets[1] == 1 && offsets[6] == 8 && list[0] == 0);
    for (k = 0; k < 9; ++k) CHECK(edges[2 * k] < edges[2 * k + 1]);
}

static void queries(const mgdt_triangulation* t) {
    static const double asked[6] = {0.1, 0.1, 0.1, 9, 9, 9};
    int64_t found = 77, both[2], v[8];
    int32_t both32[2];
    double weights[8], weights32[8], value = -1;
    int k;
    CHECK(mgdt_locate(t, asked, &found) == MGDT_OK && found == 0);
    CHECK(mgdt_locate_points(t, 2, asked, both, weights) == MGDT_OK);
    CHECK(mgdt_locate_points_i32(t, 2, asked, both32, weights32) == MGDT_OK);
    CHECK(both[0] == 0 && both[1] == -1 && both32[0] == 0 && both32[1] == -1);
    CHECK(mgdt_get_tetrahedra(t, 8, v) == MGDT_OK);
    for (k = 0; k < 4; ++k) {
        CHECK(fabs(weights[k] - (v[k] == 0 ? 0.7 : 0.1)) < 1e-14 && weights32[k] == weights[k]);
        CHECK(weights[4 + k] == 0);
    }
    CHECK(mgdt_nearest_vertex(t, asked + 3, &found) == MGDT_OK && found == 4);
    CHECK(mgdt_check(t, MGDT_CHECK_COMBINATORIAL) == MGDT_OK);
    CHECK(mgdt_check(t, MGDT_CHECK_GEOMETRIC) == MGDT_OK);
    CHECK(mgdt_check(t, MGDT_CHECK_CANONICAL) == MGDT_OK);
    CHECK(mgdt_check(t, 9) == MGDT_ERR_INVALID_ARGUMENT);
    CHECK(mgdt_get_stat(t, MGDT_STAT_DUPLICATES, &value) == MGDT_OK && value == 1);
    CHECK(mgdt_get_stat(t, MGDT_STAT_POINTS_INSERTED, &value) == MGDT_OK && value == 5);
    CHECK(mgdt_get_stat(t, MGDT_STAT_MEMORY_BYTES, &value) == MGDT_OK && value > 0);
    CHECK(mgdt_get_stat(t, 5, &value) == MGDT_ERR_UNKNOWN_KEY);
}

static void failures_and_cancelling(mgdt_triangulation* t) {
    static const double bad[6] = {1, 2, 3, 1, 2, HUGE_VAL};
    char message[256] = "";
    int64_t found = 0;
    CHECK(mgdt_insert_points(t, 2, bad) == MGDT_ERR_NOT_FINITE);
    CHECK(mgdt_get_error(t, sizeof message, message) == MGDT_OK && strlen(message) > 5);
    CHECK(mgdt_insert_points(t, -1, six) == MGDT_ERR_INVALID_ARGUMENT);
    CHECK(mgdt_insert_points(t, 1, NULL) == MGDT_ERR_NULL_POINTER);
    CHECK(mgdt_point_count(t) == 6);
    CHECK(mgdt_clear(t) == MGDT_OK && mgdt_point_count(t) == 0 && mgdt_dimension(t) == -1);
    CHECK(mgdt_cancel(t) == MGDT_OK);
    CHECK(mgdt_insert_points(t, 6, six) == MGDT_ERR_CANCELLED);
    CHECK(mgdt_clear(t) == MGDT_OK);
    CHECK(mgdt_set_progress(t, stop, NULL) == MGDT_OK);
    CHECK(mgdt_insert_points(t, 6, six) == MGDT_ERR_CANCELLED);
    CHECK(mgdt_set_progress(t, NULL, NULL) == MGDT_OK);
    CHECK(mgdt_clear(t) == MGDT_OK);
    CHECK(mgdt_set_memory_limit(t, 1) == MGDT_OK);
    CHECK(mgdt_reserve(t, 1000000) == MGDT_ERR_OUT_OF_MEMORY);
    CHECK(mgdt_set_memory_limit(t, 0) == MGDT_OK);
    /* The other way to give points, counted from 1. */
    CHECK(mgdt_set_index_base(t, 1) == MGDT_OK);
    CHECK(mgdt_insert_points_strided(t, 6, six, six + 1, six + 2, 3) == MGDT_OK);
    CHECK(mgdt_nearest_vertex(t, six + 12, &found) == MGDT_OK && found == 5);
    CHECK(mgdt_locate(t, bad + 3, &found) == MGDT_ERR_NOT_FINITE);
    CHECK(mgdt_tetrahedron_count(t) == 2);
}

int main(void) {
    mgdt_triangulation* t = NULL;
    double fraction = -1;
    constants_and_names();
    CHECK(mgdt_create(NULL) == MGDT_ERR_NULL_POINTER);
    CHECK(mgdt_create(&t) == MGDT_OK && t != NULL);
    mgdt_destroy(t);
    mgdt_destroy(NULL);
    CHECK(mgdt_create_with_allocator(take, NULL, NULL, &t) == MGDT_ERR_INVALID_ARGUMENT);
    CHECK(t == NULL);
    CHECK(mgdt_create_with_allocator(take, give, &live_bytes, &t) == MGDT_OK);
    if (t == NULL) return 1;
    settings(t);
    CHECK(mgdt_set_progress(t, hear, &fraction) == MGDT_OK);
    CHECK(mgdt_insert_points(t, 6, six) == MGDT_OK && fraction == 1);
    CHECK(mgdt_set_progress(t, NULL, NULL) == MGDT_OK);
    exports(t);
    queries(t);
    failures_and_cancelling(t);
    CHECK(live_bytes > 0);
    mgdt_destroy(t);
    CHECK(live_bytes == 0);
    printf("%d checks, %d failed\n", checks, failures);
    return failures ? 1 : 0;
}
