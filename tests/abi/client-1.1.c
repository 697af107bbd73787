/* SPDX-License-Identifier: MIT
 * A program as it was compiled for version 1.1: what the client of 1.0 does, compiled with the
 * header of 1.1, and what 1.1 added. Frozen like the header. */
#include "mgdt-1.1.h"

/* The header of 1.0, which this includes, has the same guard and is left out. */
#define main client_of_1_0
int client_of_1_0(void);
#include "client-1.0.c"
#undef main

static void compact_storage(void) {
    double before = 0, after = 0, grid[3 * 512];
    int64_t v[8];
    mgdt_triangulation* t = NULL;
    int i;
    for (i = 0; i < 512; ++i) {
        grid[3 * i] = i % 8;
        grid[3 * i + 1] = i / 8 % 8;
        grid[3 * i + 2] = i / 64;
    }
    CHECK(mgdt_set_compact(NULL, 1) == MGDT_ERR_NULL_POINTER);
    CHECK(mgdt_create(&t) == MGDT_OK);
    if (t == NULL) return;
    CHECK(mgdt_set_compact(t, 2) == MGDT_ERR_INVALID_ARGUMENT);
    CHECK(mgdt_insert_points(t, 512, grid) == MGDT_OK);
    CHECK(mgdt_get_stat(t, MGDT_STAT_MEMORY_BYTES, &before) == MGDT_OK);
    CHECK(mgdt_set_compact(t, 1) == MGDT_OK);
    CHECK(mgdt_get_stat(t, MGDT_STAT_MEMORY_BYTES, &after) == MGDT_OK);
    CHECK(after < before);
    CHECK(mgdt_check(t, MGDT_CHECK_CANONICAL) == MGDT_OK);
    CHECK(mgdt_set_memory_limit(t, 1) == MGDT_OK);
    CHECK(mgdt_set_compact(t, 0) == MGDT_ERR_OUT_OF_MEMORY);
    CHECK(mgdt_set_memory_limit(t, 0) == MGDT_OK);
    CHECK(mgdt_clear(t) == MGDT_OK);
    CHECK(mgdt_insert_points(t, 6, six) == MGDT_OK);
    CHECK(mgdt_set_compact(t, 0) == MGDT_OK);
    CHECK(mgdt_get_tetrahedra(t, 8, v) == MGDT_OK);
    CHECK(mgdt_check(t, MGDT_CHECK_CANONICAL) == MGDT_OK);
    mgdt_destroy(t);
}

int main(void) {
    compact_storage();
    return client_of_1_0();
}
