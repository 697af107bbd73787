/* SPDX-License-Identifier: MIT
 * Points in parts: the tetrahedra of one triangulation, and what the parts say of each other. */
#include <math.h>
#include <mgdt/mgdt_parts.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

static void check_message(const mgdt_parts* p, const char* text, int line) {
    char message[256] = "";
    if (mgdt_parts_get_error(p, (int64_t)sizeof message, message) != MGDT_OK ||
        strstr(message, text) == NULL) {
        fprintf(stderr, "line %d: no \"%s\" in the message \"%s\"\n", line, text, message);
        CHECK(0);
    }
}
#define CHECK_MESSAGE(p, text) check_message((p), (text), __LINE__)

static mgdt_parts* make_parts(int32_t parts) {
    mgdt_parts* p = NULL;
    if (!CHECK_EQUAL(mgdt_parts_create(parts, &p), MGDT_OK)) abort();
    return p;
}

static int64_t stat(const mgdt_parts* p, int32_t part, int32_t key) {
    int64_t value = -1;
    CHECK_EQUAL(mgdt_parts_get_stat(p, part, key, &value), MGDT_OK);
    return value;
}

/* An array, with room behind it that must stay as it is; the caller frees it. */
static int64_t* array(const mgdt_parts* p, int32_t part, int32_t which, int64_t* size) {
    int64_t n = -1;
    int64_t* v;
    CHECK_EQUAL(mgdt_parts_get_size(p, part, which, &n), MGDT_OK);
    v = malloc((size_t)(n + 1) * sizeof *v);
    if (v == NULL) abort();
    v[n] = 4711;
    if (n > 0)
        CHECK_EQUAL(mgdt_parts_get_array(p, part, which, n - 1, v), MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_parts_get_array(p, part, which, n, v), MGDT_OK);
    CHECK_EQUAL(v[n], 4711);
    if (size != NULL) *size = n;
    return v;
}

/* Dealt out in turns, with their numbers as ids if that is wanted. */
static void deal(mgdt_parts* p, int32_t parts, int64_t n, const double* xyz, int numbers) {
    int64_t i;
    for (i = 0; i < n; ++i)
        CHECK_EQUAL(
            mgdt_parts_insert_points(p, (int32_t)(i % parts), 1, xyz + 3 * i, numbers ? &i : NULL),
            MGDT_OK);
}

/* The tetrahedra of all parts by ids, sorted, are those of one triangulation, each owned once. */
static void compare(mgdt_parts* p, int32_t parts, const mgdt_triangulation* one, int64_t base) {
    const int64_t count = mgdt_tetrahedron_count(one), n = mgdt_point_count(one);
    int64_t *v = get_array(mgdt_get_tetrahedra, one, 4 * count),
            *map = get_array(mgdt_get_point_map, one, n),
            *all = malloc((size_t)(4 * count + 1) * sizeof *all), found = 0, i;
    int32_t part;
    if (v == NULL || map == NULL || all == NULL) abort();
    for (i = 0; i < 4 * count; ++i) v[i] = map[v[i]];
    sort_tetrahedra(v, count);
    for (part = 0; part < parts; ++part) {
        const int64_t owned = stat(p, part, MGDT_PARTS_OWN_TETRAHEDRA);
        int64_t *corners = array(p, part, MGDT_PARTS_LOCAL_CORNERS, NULL),
                *ids = array(p, part, MGDT_PARTS_VERTEX_IDS, NULL);
        for (i = 0; i < 4 * owned && found < 4 * count; ++i) all[found++] = ids[corners[i] - base];
        free(corners);
        free(ids);
    }
    CHECK_EQUAL(found, 4 * count);
    sort_tetrahedra(all, count);
    CHECK(memcmp(all, v, (size_t)(4 * count) * sizeof *all) == 0);
    CHECK_EQUAL(stat(p, 0, MGDT_PARTS_ALL_TETRAHEDRA), count);
    CHECK_EQUAL(stat(p, 0, MGDT_PARTS_ALL_VERTICES), mgdt_vertex_count(one));
    free(v);
    free(map);
    free(all);
}

/* What one part says of itself, and of others. */
static void check_part(const mgdt_parts* p, int32_t part, int32_t parts, int64_t base) {
    const int64_t own = stat(p, part, MGDT_PARTS_OWN_VERTICES),
                  vertices = stat(p, part, MGDT_PARTS_VERTICES),
                  owned = stat(p, part, MGDT_PARTS_OWN_TETRAHEDRA),
                  tetrahedra = stat(p, part, MGDT_PARTS_TETRAHEDRA);
    int64_t n, i, *numbers = array(p, part, MGDT_PARTS_VERTEX_NUMBERS, &n),
                  *owners = array(p, part, MGDT_PARTS_VERTEX_OWNERS, NULL),
                  *ranges = array(p, part, MGDT_PARTS_VERTEX_RANGES, NULL),
                  *corners = array(p, part, MGDT_PARTS_CORNERS, NULL),
                  *places = array(p, part, MGDT_PARTS_LOCAL_CORNERS, NULL),
                  *of_tetrahedra = array(p, part, MGDT_PARTS_TETRAHEDRON_NUMBERS, NULL),
                  *tetrahedron_owners = array(p, part, MGDT_PARTS_TETRAHEDRON_OWNERS, NULL),
                  *tetrahedron_ranges = array(p, part, MGDT_PARTS_TETRAHEDRON_RANGES, NULL),
                  *neighbors = array(p, part, MGDT_PARTS_NEIGHBORS, NULL);
    double* xyz = malloc((size_t)(3 * vertices + 1) * sizeof *xyz);
    if (xyz == NULL) abort();
    CHECK_EQUAL(n, vertices);
    CHECK(stat(p, part, MGDT_PARTS_RECEIVED) >= vertices - own);
    CHECK_EQUAL(mgdt_parts_get_coordinates(p, part, 3 * vertices, xyz), MGDT_OK);
    CHECK_EQUAL(ranges[0], base);
    CHECK_EQUAL(ranges[parts], base + stat(p, part, MGDT_PARTS_ALL_VERTICES));
    CHECK_EQUAL(ranges[part + 1] - ranges[part], own);
    CHECK_EQUAL(tetrahedron_ranges[part + 1] - tetrahedron_ranges[part], owned);
    for (i = 0; i < vertices; ++i) {
        if (i < own) CHECK_EQUAL(numbers[i], ranges[part] + i);
        if (i > own) CHECK(numbers[i] > numbers[i - 1]);
        CHECK(numbers[i] >= ranges[owners[i]] && numbers[i] < ranges[owners[i] + 1]);
        CHECK_EQUAL(owners[i] == part, i < own);
    }
    for (i = 0; i < tetrahedra; ++i) {
        int64_t least = 0;
        int k, is_own = 0;
        CHECK(of_tetrahedra[i] >= tetrahedron_ranges[tetrahedron_owners[i]] &&
              of_tetrahedra[i] < tetrahedron_ranges[tetrahedron_owners[i] + 1]);
        CHECK_EQUAL(tetrahedron_owners[i] == part, i < owned);
        for (k = 0; k < 4; ++k) {
            const int64_t place = places[4 * i + k] - base;
            const double *a = xyz + 3 * place, *b;
            CHECK_EQUAL(corners[4 * i + k], numbers[place]);
            is_own |= place < own;
            b = xyz + 3 * (k == 0 ? place : least);
            if (a[0] < b[0] || (a[0] == b[0] && (a[1] < b[1] || (a[1] == b[1] && a[2] <= b[2]))))
                least = place;
        }
        CHECK(is_own);
        CHECK_EQUAL(owners[least], tetrahedron_owners[i]);
        CHECK(volume(xyz + 3 * (places[4 * i] - base), xyz + 3 * (places[4 * i + 1] - base),
                     xyz + 3 * (places[4 * i + 2] - base),
                     xyz + 3 * (places[4 * i + 3] - base)) >= -1e-12);
    }
    for (i = 0; i < 4 * owned; ++i)
        CHECK(neighbors[i] >= base - 1 && neighbors[i] < tetrahedron_ranges[parts] &&
              neighbors[i] != of_tetrahedra[i / 4]);
    free(numbers);
    free(owners);
    free(ranges);
    free(corners);
    free(places);
    free(of_tetrahedra);
    free(tetrahedron_owners);
    free(tetrahedron_ranges);
    free(neighbors);
    free(xyz);
}

/* Each point's vertex is at its place. */
static void check_point_map(const mgdt_parts* p, int32_t parts, int64_t n, const double* xyz) {
    int64_t *size = calloc((size_t)parts, sizeof *size), i;
    double** at = malloc((size_t)parts * sizeof *at);
    int64_t** map = malloc((size_t)parts * sizeof *map);
    int64_t* ranges = array(p, 0, MGDT_PARTS_VERTEX_RANGES, NULL);
    int32_t part;
    if (size == NULL || at == NULL || map == NULL) abort();
    for (part = 0; part < parts; ++part) {
        const int64_t room = 3 * stat(p, part, MGDT_PARTS_VERTICES);
        at[part] = malloc((size_t)(room + 1) * sizeof **at);
        if (at[part] == NULL) abort();
        CHECK_EQUAL(mgdt_parts_get_coordinates(p, part, room, at[part]), MGDT_OK);
        map[part] = array(p, part, MGDT_PARTS_POINT_MAP, NULL);
        CHECK_EQUAL(stat(p, part, MGDT_PARTS_POINTS), (n + parts - 1 - part) / parts);
    }
    for (i = 0; i < n; ++i) {
        const int64_t vertex = map[i % parts][i / parts];
        int32_t home = 0;
        while (vertex >= ranges[home + 1]) ++home;
        CHECK(memcmp(at[home] + 3 * (vertex - ranges[home]), xyz + 3 * i, 3 * sizeof *xyz) == 0);
    }
    for (part = 0; part < parts; ++part) {
        free(at[part]);
        free(map[part]);
    }
    free(at);
    free(map);
    free(ranges);
    free(size);
}

static void has_the_tetrahedra_of_one(void) {
    const int64_t n = is_small() ? 150 : 800;
    const int32_t numbers[] = {1, 2, 5, 16};
    int grid;
    for (grid = 0; grid <= 6; grid += 6) { /* 6: many equal points, and ties */
        double* xyz = random_points(n, grid, 3);
        mgdt_triangulation* one = make(n, xyz);
        size_t k;
        for (k = 0; k < sizeof numbers / sizeof *numbers; ++k) {
            const int32_t parts = numbers[k];
            const int64_t base = parts % 2;
            mgdt_parts* p = make_parts(parts);
            int32_t part;
            CHECK_EQUAL(mgdt_parts_set_option(p, MGDT_PARTS_INDEX_BASE, base), MGDT_OK);
            deal(p, parts, n, xyz, 1);
            CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
            compare(p, parts, one, base);
            for (part = 0; part < parts; ++part) check_part(p, part, parts, base);
            CHECK_EQUAL(mgdt_parts_check(p, MGDT_CHECK_CANONICAL), MGDT_OK);
            CHECK_EQUAL(mgdt_parts_set_option(p, MGDT_PARTS_INDEX_BASE, 0), MGDT_OK);
            check_point_map(p, parts, n, xyz);
            mgdt_parts_destroy(p);
        }
        mgdt_destroy(one);
        free(xyz);
    }
}

/* Without ids points are numbered through the parts. A later build has them all; after
 * mgdt_parts_clear() there are none. */
static void grows_and_is_cleared(void) {
    const int64_t n = 60;
    double* xyz = random_points(2 * n, 0, 5);
    mgdt_triangulation *half = make(n, xyz), *one = make(2 * n, xyz);
    mgdt_parts* p = make_parts(3);
    int64_t size;
    CHECK_EQUAL(mgdt_parts_get_size(p, 0, MGDT_PARTS_CORNERS, &size), MGDT_OK);
    CHECK_EQUAL(size, 0);
    CHECK_EQUAL(mgdt_parts_get_array(p, 0, MGDT_PARTS_CORNERS, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_get_coordinates(p, 0, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_check(p, 1), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
    CHECK_EQUAL(stat(p, 0, MGDT_PARTS_ALL_VERTICES), 0);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 1, n, xyz, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 1, 0, NULL, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
    compare(p, 3, half, 0);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 2, n, xyz + 3 * n, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
    compare(p, 3, one, 0);
    CHECK(stat(p, 0, MGDT_PARTS_MEMORY_BYTES) > 100 * n);
    CHECK_EQUAL(mgdt_parts_clear(p), MGDT_OK);
    CHECK_EQUAL(stat(p, 1, MGDT_PARTS_POINTS), 0);
    CHECK_EQUAL(stat(p, 1, MGDT_PARTS_VERTICES), 0);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
    CHECK_EQUAL(stat(p, 0, MGDT_PARTS_ALL_TETRAHEDRA), 0);
    mgdt_parts_destroy(p);
    mgdt_destroy(half);
    mgdt_destroy(one);
    free(xyz);
}

static void compares_ids(void) {
    const double xyz[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const int64_t ids[] = {7, -3, 9, 40};
    int32_t part;
    mgdt_parts* p = make_parts(2);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 0, 4, xyz, ids), MGDT_OK);
    /* The same point may have the same id, or another. */
    CHECK_EQUAL(mgdt_parts_insert_points(p, 1, 2, xyz, ids), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 1, 1, xyz, ids + 3), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_MESSAGE(p, "id 40 is given to two points: (0, 0, ");
    CHECK_MESSAGE(p, " in part 0");
    CHECK_MESSAGE(p, " in part 1");
    CHECK_EQUAL(stat(p, 0, MGDT_PARTS_ALL_VERTICES), 0);
    CHECK_EQUAL(mgdt_parts_clear(p), MGDT_OK);

    CHECK_EQUAL(mgdt_parts_insert_points(p, 0, 4, xyz, ids), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 1, 1, xyz + 3, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_MESSAGE(p, "part 1: its points have no ids, those of part 0 have");
    CHECK_EQUAL(mgdt_parts_insert_points(p, 1, 1, xyz + 3, ids), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_MESSAGE(p, "the points before these have no ids");
    CHECK_EQUAL(mgdt_parts_clear(p), MGDT_OK);

    CHECK_EQUAL(mgdt_parts_insert_points(p, 1, 4, xyz, ids), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 0, 1, xyz, ids + 1), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_MESSAGE(p, "id -3 is given to two points");
    CHECK_EQUAL(mgdt_parts_clear(p), MGDT_OK);
    /* A vertex has the least id of its points. */
    CHECK_EQUAL(mgdt_parts_insert_points(p, 0, 1, xyz, ids + 3), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 1, 1, xyz, ids + 1), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 1, 1, xyz, ids + 2), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
    CHECK_EQUAL(stat(p, 0, MGDT_PARTS_ALL_VERTICES), 1);
    for (part = 0; part < 2; ++part) {
        int64_t size, *of_vertices = array(p, part, MGDT_PARTS_VERTEX_IDS, &size);
        if (size > 0) CHECK_EQUAL(of_vertices[0], -3);
        free(of_vertices);
    }
    mgdt_parts_destroy(p);
}

/* An insertion that fails takes the next build with it, once; the points before stay. */
static void reports_bad_points(void) {
    double xyz[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    mgdt_parts* p = make_parts(3);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 0, 4, xyz, NULL), MGDT_OK);
    xyz[7] = NAN;
    CHECK_EQUAL(mgdt_parts_insert_points(p, 2, 4, xyz, NULL), MGDT_ERR_NOT_FINITE);
    CHECK_MESSAGE(p, "coordinate y of point 2 is NaN");
    CHECK_EQUAL(stat(p, 2, MGDT_PARTS_POINTS), 0);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_ERR_NOT_FINITE);
    CHECK_MESSAGE(p, "part 2: coordinate y of point 2 is NaN");
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
    CHECK_EQUAL(stat(p, 1, MGDT_PARTS_ALL_TETRAHEDRA), 1);
    mgdt_parts_destroy(p);
}

/* One part at a time: what each look finds. */
struct looks {
    mgdt_parts* p;
    int64_t base, *tetrahedra, found;
    int count, stop_at;
};

static int32_t look(const mgdt_parts* p, int32_t part, void* user) {
    struct looks* l = user;
    const int64_t owned = stat(p, part, MGDT_PARTS_OWN_TETRAHEDRA);
    int64_t *corners = array(p, part, MGDT_PARTS_LOCAL_CORNERS, NULL),
            *ids = array(p, part, MGDT_PARTS_VERTEX_IDS, NULL),
            *ranges = array(p, part, MGDT_PARTS_TETRAHEDRON_RANGES, NULL), i;
    CHECK(p == l->p && part == l->count);
    CHECK_EQUAL(ranges[part], l->found / 4 + l->base);
    CHECK_EQUAL(ranges[part + 1] - ranges[part], owned);
    for (i = 0; i < 4 * owned; ++i) l->tetrahedra[l->found++] = ids[corners[i] - l->base];
    CHECK_EQUAL(mgdt_parts_get_array(p, part, MGDT_PARTS_NEIGHBORS, 4 * owned, corners),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_MESSAGE(p, "one part at a time");
    /* Others have none. */
    CHECK_EQUAL(stat(p, part == 0 ? 1 : 0, MGDT_PARTS_TETRAHEDRA), 0);
    CHECK_EQUAL(mgdt_parts_clear(l->p), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_parts_build(l->p), MGDT_ERR_BUSY);
    mgdt_parts_destroy(l->p); /* does nothing */
    free(corners);
    free(ids);
    free(ranges);
    return ++l->count == l->stop_at;
}

static void builds_each(void) {
    const int64_t n = is_small() ? 150 : 800;
    int grid;
    for (grid = 0; grid <= 6; grid += 6) {
        double* xyz = random_points(n, grid, 3);
        mgdt_triangulation* one = make(n, xyz);
        const int64_t count = mgdt_tetrahedron_count(one);
        int64_t *v = get_array(mgdt_get_tetrahedra, one, 4 * count),
                *map = get_array(mgdt_get_point_map, one, n), i;
        int32_t parts;
        if (v == NULL || map == NULL) abort();
        for (i = 0; i < 4 * count; ++i) v[i] = map[v[i]];
        sort_tetrahedra(v, count);
        for (parts = 2; parts <= 8; parts += 3) {
            struct looks l = {0};
            l.base = parts % 2;
            l.p = make_parts(parts);
            l.tetrahedra = malloc((size_t)(4 * count + 1) * sizeof *l.tetrahedra);
            if (l.tetrahedra == NULL) abort();
            CHECK_EQUAL(mgdt_parts_set_option(l.p, MGDT_PARTS_INDEX_BASE, l.base), MGDT_OK);
            deal(l.p, parts, n, xyz, 1);
            CHECK_EQUAL(mgdt_parts_build_each(l.p, look, &l), MGDT_OK);
            CHECK_EQUAL(l.count, parts);
            CHECK_EQUAL(l.found, 4 * count);
            sort_tetrahedra(l.tetrahedra, count);
            CHECK(memcmp(l.tetrahedra, v, (size_t)(4 * count) * sizeof *v) == 0);
            CHECK_EQUAL(stat(l.p, 0, MGDT_PARTS_TETRAHEDRA), 0);
            CHECK_EQUAL(stat(l.p, 0, MGDT_PARTS_ALL_TETRAHEDRA), count);
            CHECK_EQUAL(mgdt_parts_check(l.p, 1), MGDT_ERR_INVALID_ARGUMENT);
            CHECK_EQUAL(mgdt_parts_set_option(l.p, MGDT_PARTS_INDEX_BASE, 0), MGDT_OK);
            check_point_map(l.p, parts, n, xyz);
            /* Ended after the second part, and then all at once. */
            l.base = l.found = l.count = 0;
            l.stop_at = 2;
            CHECK_EQUAL(mgdt_parts_build_each(l.p, look, &l), MGDT_ERR_CANCELLED);
            CHECK_EQUAL(l.count, 2);
            CHECK_EQUAL(stat(l.p, 0, MGDT_PARTS_ALL_VERTICES), 0);
            CHECK_EQUAL(mgdt_parts_build_each(l.p, NULL, &l), MGDT_ERR_NULL_POINTER);
            CHECK_EQUAL(mgdt_parts_build(l.p), MGDT_OK);
            compare(l.p, parts, one, 0);
            mgdt_parts_destroy(l.p);
            free(l.tetrahedra);
        }
        free(v);
        free(map);
        free(xyz);
        mgdt_destroy(one);
    }
}

static void refuses_arguments(void) {
    const double xyz[] = {0, 0, 0};
    int64_t value = 5, values[8];
    double coordinates[3];
    char buffer[4];
    mgdt_parts* p = (mgdt_parts*)buffer;
    CHECK_EQUAL(mgdt_parts_create(1, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_parts_create(0, &p), MGDT_ERR_INVALID_ARGUMENT);
    CHECK(p == NULL);
    CHECK_EQUAL(mgdt_parts_create((1 << 20) + 1, &p), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_parts_create_with_transport(NULL, &p), MGDT_ERR_NULL_POINTER);
    mgdt_parts_destroy(NULL);
    CHECK_EQUAL(mgdt_parts_build(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_parts_cancel(NULL), MGDT_ERR_NULL_POINTER);

    p = make_parts(2);
    CHECK_EQUAL(stat(p, 1, MGDT_PARTS_PARTS), 2);
    CHECK_EQUAL(stat(p, 1, MGDT_PARTS_FIRST_LOCAL), 0);
    CHECK_EQUAL(stat(p, 1, MGDT_PARTS_LOCAL_PARTS), 2);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 2, 1, xyz, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_MESSAGE(p, "part 2 is not among those of this process, 0 to 1");
    CHECK_EQUAL(mgdt_parts_insert_points(p, MGDT_PARTS_THIS_PART, 1, xyz, NULL),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_MESSAGE(p, "MGDT_PARTS_THIS_PART is for a process with one part; this one has 2");
    CHECK_EQUAL(mgdt_parts_insert_points(p, -2, 1, xyz, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_MESSAGE(p, "part -2 is not among those of this process, 0 to 1");
    CHECK_EQUAL(mgdt_parts_insert_points(p, 0, -1, xyz, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 0, 1, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_parts_clear(p), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 0, 1, xyz, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_check(p, 0), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_parts_check(p, 4), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_parts_get_stat(p, 0, 5, &value), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_parts_get_stat(p, 2, MGDT_PARTS_POINTS, &value), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_parts_get_stat(p, 0, MGDT_PARTS_POINTS, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_parts_get_size(p, 0, 5, &value), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_parts_get_size(p, 2, MGDT_PARTS_CORNERS, &value), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_parts_get_size(p, 0, MGDT_PARTS_CORNERS, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_parts_get_array(p, 0, 5, 8, values), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_parts_get_array(p, 0, MGDT_PARTS_POINT_MAP, -1, values),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_parts_get_array(p, 0, MGDT_PARTS_POINT_MAP, 1, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_parts_get_coordinates(p, 2, 3, coordinates), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_parts_get_option(p, 5, &value), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_parts_get_option(p, MGDT_PARTS_THREADS, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_parts_set_option(p, 5, 1), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_parts_set_option(p, MGDT_PARTS_INDEX_BASE, 2), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_parts_set_option(p, MGDT_PARTS_THREADS, -1), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_parts_set_option(p, MGDT_PARTS_MEMORY_LIMIT, -1), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_parts_set_option(p, MGDT_PARTS_THREADS, 2), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_get_option(p, MGDT_PARTS_THREADS, &value), MGDT_OK);
    CHECK_EQUAL(value, 2);
    CHECK_EQUAL(mgdt_parts_get_option(p, MGDT_PARTS_INDEX_BASE, &value), MGDT_OK);
    CHECK_EQUAL(value, 0);
    CHECK_EQUAL(mgdt_parts_get_option(p, MGDT_PARTS_MEMORY_LIMIT, &value), MGDT_OK);
    CHECK_EQUAL(value, 0);
    CHECK_EQUAL(mgdt_parts_get_error(p, 0, buffer), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_parts_get_error(p, 4, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_parts_get_error(p, 4, buffer), MGDT_OK);
    CHECK_EQUAL(strlen(buffer), 3);
    mgdt_parts_destroy(p);
}

struct steps {
    mgdt_parts* p;
    int count, stop_at;
    double last;
};

static int32_t step(double fraction, void* user) {
    struct steps* s = user;
    int64_t value;
    CHECK(fraction >= s->last && fraction <= 1);
    s->last = fraction;
    CHECK_EQUAL(mgdt_parts_get_stat(s->p, 0, MGDT_PARTS_POINTS, &value), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_parts_build(s->p), MGDT_ERR_BUSY);
    mgdt_parts_destroy(s->p); /* does nothing */
    return ++s->count == s->stop_at;
}

static void tells_progress(void) {
    const int64_t n = 500;
    double* xyz = random_points(n, 0, 7);
    mgdt_parts* p = make_parts(3);
    struct steps s = {0};
    int stop;
    s.p = p;
    deal(p, 3, n, xyz, 0);
    CHECK_EQUAL(mgdt_parts_set_progress(p, step, &s), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
    CHECK(s.last == 1 && s.count > 10);
    for (stop = 1; stop < s.count; stop += 1 + s.count / 20) {
        struct steps some = {0};
        some.p = p;
        some.stop_at = stop;
        CHECK_EQUAL(mgdt_parts_set_progress(p, step, &some), MGDT_OK);
        CHECK_EQUAL(mgdt_parts_build(p), MGDT_ERR_CANCELLED);
        CHECK_EQUAL(some.count, stop);
        CHECK_EQUAL(stat(p, 0, MGDT_PARTS_ALL_VERTICES), 0);
    }
    CHECK_EQUAL(mgdt_parts_set_progress(p, NULL, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_cancel(p), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_ERR_CANCELLED);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
    CHECK_EQUAL(stat(p, 0, MGDT_PARTS_ALL_VERTICES), n);
    mgdt_parts_destroy(p);
    free(xyz);
}

/* Memory of the host's, all of which comes back; the allocation numbered `refused` fails. */
struct memory {
    int64_t held, count, refused;
};

static void* take(size_t size, size_t align, void* user) {
    struct memory* m = user;
    char *block, *at;
    if (m->count++ == m->refused) return NULL;
    block = malloc(size + align + sizeof(char*));
    if (block == NULL) return NULL;
    at = block + sizeof(char*);
    at += (align - (uintptr_t)at % align) % align;
    memcpy(at - sizeof(char*), &block, sizeof block);
    m->held += (int64_t)size;
    return at;
}

static void give_back(void* p, size_t size, size_t align, void* user) {
    char* block;
    (void)align;
    memcpy(&block, (char*)p - sizeof block, sizeof block);
    ((struct memory*)user)->held -= (int64_t)size;
    free(block);
}

static void runs_out_of_memory(void) {
    const int64_t n = 40;
    double* xyz = random_points(n, 0, 9);
    int64_t refused, allocations = 1, failures = 0;
    for (refused = -1; refused < allocations; refused += refused < 0 || !is_small() ? 1 : 7) {
        struct memory m = {0};
        mgdt_parts* p = NULL;
        mgdt_status status, built = MGDT_OK;
        int32_t part;
        m.refused = refused;
        status = mgdt_parts_create_with_allocator(2, take, give_back, &m, &p);
        for (part = 0; part < 2 && status == MGDT_OK; ++part)
            status = mgdt_parts_insert_points(p, part, n / 2, xyz + 3 * (n / 2) * part, NULL);
        if (p != NULL) built = mgdt_parts_build(p);
        if (p != NULL && status != MGDT_OK) CHECK_EQUAL(built, status);
        if (status == MGDT_OK) status = built;
        if (p != NULL && status == MGDT_OK) status = mgdt_parts_check(p, 3);
        /* Some are done without: room to spare. */
        CHECK(status == (refused < 0 ? MGDT_OK : MGDT_ERR_OUT_OF_MEMORY) || status == MGDT_OK);
        failures += status != MGDT_OK;
        if (refused < 0) allocations = m.count;
        /* It goes on once there is memory. */
        if (p != NULL && refused >= 0 && stat(p, 1, MGDT_PARTS_POINTS) > 0)
            CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
        mgdt_parts_destroy(p);
        CHECK_EQUAL(m.held, 0);
    }
    CHECK(failures > allocations / (is_small() ? 16 : 2));
    {
        mgdt_parts* p = make_parts(2);
        CHECK_EQUAL(mgdt_parts_insert_points(p, 0, n, xyz, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_parts_set_option(p, MGDT_PARTS_MEMORY_LIMIT, 20000), MGDT_OK);
        CHECK_EQUAL(mgdt_parts_build(p), MGDT_ERR_OUT_OF_MEMORY);
        CHECK_EQUAL(mgdt_parts_set_option(p, MGDT_PARTS_MEMORY_LIMIT, 50000000), MGDT_OK);
        CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
        CHECK(stat(p, 0, MGDT_PARTS_MEMORY_BYTES) < 50000000);
        mgdt_parts_destroy(p);
    }
    free(xyz);
}

void test_parts(void) {
    has_the_tetrahedra_of_one();
    grows_and_is_cleared();
    builds_each();
    compares_ids();
    reports_bad_points();
    refuses_arguments();
    tells_progress();
    runs_out_of_memory();
}
