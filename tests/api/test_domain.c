/* SPDX-License-Identifier: MIT
 * Domains, and the meshes that are built of them; test_mesh.c tests what a mesh does by itself. */
#define _POSIX_C_SOURCE 200112L
#include <math.h>
#include <mgdt/mgdt_domain.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../support/aligned.h"
#include "check.h"

/* A cube of size 4, the ends of a triangle inside of it, and points on both sides of the triangle,
 * which are nearer to each other than its corners. */
static const double box[13 * 3] = {0, 0, 0, 4, 0, 0, 0, 4, 0,   4,   4, 0,   0,
                                   0, 4, 4, 0, 4, 0, 4, 4, 4,   4,   4, 1,   1,
                                   2, 3, 1, 2, 2, 3, 2, 2, 1.7, 2.1, 2, 1.7, 1.9};
static const int64_t quads[6 * 4] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                     2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
static const int64_t offsets[8] = {0, 4, 8, 12, 16, 20, 24, 27};
static const int32_t markers[7] = {1, 2, 3, 4, 5, 6, -7};

/* An allocator that refuses one of its calls, or asks to cancel at it. */
typedef struct {
    mgdt_domain* d;
    int64_t blocks, calls, refuse_at, cancel_at;
} failing;

static void* allocate(size_t size, size_t align, void* user) {
    failing* const f = user;
    void* p;
    if (++f->calls == f->refuse_at) return NULL;
    if (f->calls == f->cancel_at) mgdt_domain_cancel(f->d);
    p = allocate_aligned(size, align);
    if (p != NULL) ++f->blocks;
    return p;
}

static void release(void* p, size_t size, size_t align, void* user) {
    (void)size;
    (void)align;
    --((failing*)user)->blocks;
    free_aligned(p);
}

static int check_message(const mgdt_domain* d, const char* text) {
    char message[256] = "";
    CHECK_EQUAL(mgdt_domain_get_error(d, sizeof message, message), MGDT_OK);
    if (strstr(message, text) == NULL) printf("the message is: %s\n", message);
    return CHECK(strstr(message, text) != NULL);
}

static int64_t stat_of(const mgdt_domain* d, int32_t key) {
    int64_t value = -1;
    CHECK_EQUAL(mgdt_domain_get_stat(d, key, &value), MGDT_OK);
    return value;
}

static int64_t size_of(const mgdt_domain* d, int32_t array) {
    int64_t size = -1;
    CHECK_EQUAL(mgdt_domain_get_size(d, array, &size), MGDT_OK);
    return size;
}

static int64_t mesh_stat(const mgdt_mesh* m, int32_t key) {
    int64_t value = -1;
    CHECK_EQUAL(mgdt_mesh_get_stat(m, key, &value), MGDT_OK);
    return value;
}

static int64_t mesh_size(const mgdt_mesh* m, int32_t array) {
    int64_t size = -1;
    CHECK_EQUAL(mgdt_mesh_get_size(m, array, &size), MGDT_OK);
    return size;
}

static int64_t* array_of(const mgdt_mesh* m, int32_t array) {
    const int64_t size = mesh_size(m, array);
    int64_t* const values = malloc((size_t)(size + 1) * sizeof *values);
    int32_t* const narrow = malloc((size_t)(size + 1) * sizeof *narrow);
    int64_t i;
    values[size] = narrow[size] = -77;
    CHECK_EQUAL(mgdt_mesh_get_array(m, array, size, values), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_get_array_i32(m, array, size, narrow), MGDT_OK);
    for (i = 0; i <= size; ++i) CHECK_EQUAL(values[i], narrow[i]);
    CHECK_EQUAL(values[size], -77);
    free(narrow);
    return values;
}

static double* points_of(const mgdt_mesh* m) {
    const int64_t size = mesh_size(m, MGDT_MESH_ARRAY_POINTS);
    double* const xyz = malloc((size_t)(size + 1) * sizeof *xyz);
    xyz[size] = -77;
    CHECK_EQUAL(mgdt_mesh_get_doubles(m, MGDT_MESH_ARRAY_POINTS, size, xyz), MGDT_OK);
    CHECK(xyz[size] == -77);
    return xyz;
}

/* Builds, and keeps no mesh. Without success there is none. */
static mgdt_status build(mgdt_domain* d) {
    mgdt_mesh* m = (mgdt_mesh*)d;
    const mgdt_status status = mgdt_domain_build(d, &m);
    CHECK((status == MGDT_OK) == (m != NULL));
    mgdt_mesh_destroy(m);
    return status;
}

/* Builds, and checks the mesh. */
static mgdt_mesh* mesh_of(mgdt_domain* d) {
    mgdt_mesh* m = NULL;
    CHECK_EQUAL(mgdt_domain_build(d, &m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_OK);
    return m;
}

static mgdt_status give_box(mgdt_domain* d, int64_t base) {
    int64_t corners[27], begin[8], segment[2];
    mgdt_status status;
    int i;
    for (i = 0; i < 24; ++i) corners[i] = quads[i] + base;
    for (i = 0; i < 3; ++i) corners[24 + i] = 8 + i + base;
    for (i = 0; i < 8; ++i) begin[i] = offsets[i] + base;
    segment[0] = base;
    segment[1] = 8 + base;
    status = mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_INDEX_BASE, base);
    if (status == MGDT_OK) status = mgdt_domain_set_points(d, 13, box);
    if (status == MGDT_OK) status = mgdt_domain_set_facets(d, 7, begin, corners, markers);
    if (status == MGDT_OK) status = mgdt_domain_set_segments(d, 1, segment, NULL);
    return status;
}

static mgdt_domain* make_box(int64_t base) {
    mgdt_domain* d = NULL;
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    CHECK_EQUAL(give_box(d, base), MGDT_OK);
    return d;
}

/* Six times the volume of all tetrahedra. */
static double volume_of(const mgdt_mesh* m, int64_t base) {
    int64_t* const v = array_of(m, MGDT_MESH_ARRAY_TETRAHEDRA);
    double* const xyz = points_of(m);
    const int64_t n = mesh_size(m, MGDT_MESH_ARRAY_TETRAHEDRA);
    double sum = 0;
    int64_t i;
    for (i = 0; i < n; i += 4) {
        const double part = volume(xyz + 3 * (v[i] - base), xyz + 3 * (v[i + 1] - base),
                                   xyz + 3 * (v[i + 2] - base), xyz + 3 * (v[i + 3] - base));
        CHECK(part > 0);
        sum += part;
    }
    free(v);
    free(xyz);
    return sum;
}

static void mesh_of_a_box(int64_t base) {
    mgdt_domain* const d = make_box(base);
    const double inside[3] = {2, 2, 3};
    const int32_t marker = 42;
    mgdt_mesh* m;
    int64_t *faces, *sides, *facets, *face_markers, *region_markers, *origins, *sources;
    double* xyz;
    int64_t i, n, inner = 0, given = 0;
    CHECK_EQUAL(mgdt_domain_set_regions(d, 1, inside, &marker), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_validate(d), MGDT_OK);
    m = mesh_of(d);
    CHECK(fabs(volume_of(m, base) - 6 * 64) < 1e-9);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_POINTS), 13);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_FACETS), 7);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_SEGMENTS), 1);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_REGIONS), 1);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_PLANAR_FACETS), 7);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_MISSING_FACETS), 1);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_CAVITIES), 1);
    CHECK(mesh_stat(m, MGDT_MESH_STAT_LARGEST_CAVITY) >= 3);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_IS_ROUNDED), 0);
    CHECK(mesh_stat(m, MGDT_MESH_STAT_MEMORY_BYTES) > 0);
    n = mesh_stat(m, MGDT_MESH_STAT_FACES);
    faces = array_of(m, MGDT_MESH_ARRAY_FACES);
    sides = array_of(m, MGDT_MESH_ARRAY_FACE_TETRAHEDRA);
    facets = array_of(m, MGDT_MESH_ARRAY_FACE_FACETS);
    face_markers = array_of(m, MGDT_MESH_ARRAY_FACE_MARKERS);
    CHECK_EQUAL(mesh_size(m, MGDT_MESH_ARRAY_FACES), 3 * n);
    for (i = 0; i < n; ++i) {
        CHECK_EQUAL(face_markers[i], markers[facets[i] - base]);
        if (facets[i] - base == 6) ++inner;
        /* The polygons of the cube turn about normals that point out of it. */
        CHECK_EQUAL(sides[2 * i] == base - 1, facets[i] - base < 6);
        CHECK(sides[2 * i + 1] >= base);
    }
    CHECK(inner >= 1);
    sources = array_of(m, MGDT_MESH_ARRAY_EDGE_SEGMENTS);
    for (i = 0; i < mesh_size(m, MGDT_MESH_ARRAY_EDGE_SEGMENTS); ++i)
        if (sources[i] >= base) {
            ++given;
            CHECK_EQUAL(sources[i], base);
        }
    CHECK(given >= 1);
    region_markers = array_of(m, MGDT_MESH_ARRAY_REGION_MARKERS);
    CHECK_EQUAL(region_markers[0], 42);
    xyz = points_of(m);
    CHECK(memcmp(xyz, box, sizeof box) == 0);
    CHECK_EQUAL(mesh_size(m, MGDT_MESH_ARRAY_POINTS),
                39 + 3 * mesh_stat(m, MGDT_MESH_STAT_STEINER_POINTS));
    origins = array_of(m, MGDT_MESH_ARRAY_POINT_ORIGINS);
    for (i = 0; i < mesh_stat(m, MGDT_MESH_STAT_POINTS); ++i)
        CHECK_EQUAL(origins[i], i < 13 ? i + base : base - 1);
    free(xyz);
    free(faces);
    free(sides);
    free(facets);
    free(face_markers);
    free(origins);
    free(sources);
    free(region_markers);
    /* A hole leaves nothing. The mesh stays as it was. */
    CHECK_EQUAL(mgdt_domain_set_holes(d, 1, inside), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_ERR_CHECK_FAILED);
    check_message(d, "is in a hole");
    CHECK_EQUAL(build(d), MGDT_ERR_OPEN_BOUNDARY);
    check_message(d, "all that the facets enclose are holes");
    /* Holes and regions are set in place of those before. */
    CHECK_EQUAL(mgdt_domain_set_holes(d, 0, NULL), MGDT_OK);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_HOLES), 0);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_regions(d, 1, inside, NULL), MGDT_OK);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_REGIONS), 1);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_ERR_CHECK_FAILED);
    check_message(d, "has the marker 42, not 0");
    CHECK_EQUAL(mgdt_domain_clear(d), MGDT_OK);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_POINTS), 0);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_REGIONS), 0);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_ERR_CHECK_FAILED);
    check_message(d, "points besides Steiner points");
    mgdt_domain_destroy(d);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    mgdt_mesh_destroy(m);
}

static void offending_pairs(void) {
    const int64_t triangle[3] = {8, 9, 11},
                  expected[4] = {MGDT_DOMAIN_KIND_FACET, 7, MGDT_DOMAIN_KIND_FACET, 8};
    int64_t corners[30], begin[9], pairs[4];
    int32_t narrow[30], narrow_begin[9], narrow_pairs[4];
    mgdt_domain* d = make_box(1);
    double xyz[39];
    memcpy(xyz, box, sizeof xyz);
    xyz[33] = 2;
    xyz[34] = 2;
    xyz[35] = 2;
    memcpy(corners, quads, sizeof quads);
    for (int i = 0; i < 3; ++i) {
        corners[24 + i] = 8 + i;
        corners[27 + i] = triangle[i];
    }
    for (int i = 0; i < 30; ++i) ++corners[i];
    for (int i = 0; i < 8; ++i) begin[i] = offsets[i] + 1;
    begin[8] = 31;
    CHECK_EQUAL(mgdt_domain_set_points(d, 13, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_facets(d, 8, begin, corners, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_validate(d), MGDT_ERR_INVALID_BOUNDARY);
    check_message(d, "facet 7 and facet 8 meet");
    CHECK_EQUAL(build(d), MGDT_ERR_INVALID_BOUNDARY);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_OFFENDING_PAIRS), 1);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS), 4);
    CHECK_EQUAL(mgdt_domain_get_array(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS, 4, pairs), MGDT_OK);
    CHECK(memcmp(pairs, expected, sizeof expected) == 0);
    CHECK_EQUAL(mgdt_domain_get_array_i32(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS, 4, narrow_pairs),
                MGDT_OK);
    for (int i = 0; i < 4; ++i) CHECK_EQUAL(narrow_pairs[i], expected[i]);
    /* The same facets, in 32 bits. */
    for (int i = 0; i < 30; ++i) narrow[i] = (int32_t)corners[i];
    for (int i = 0; i < 9; ++i) narrow_begin[i] = (int32_t)begin[i];
    CHECK_EQUAL(mgdt_domain_set_facets_i32(d, 8, narrow_begin, narrow, NULL), MGDT_OK);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS), 0);
    CHECK_EQUAL(mgdt_domain_set_segments_i32(d, 1, narrow, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_validate(d), MGDT_ERR_INVALID_BOUNDARY);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS), 4);
    /* Setting points removes what depended on them. */
    CHECK_EQUAL(mgdt_domain_set_points(d, 13, box), MGDT_OK);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS), 0);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_FACETS), 0);
    mgdt_domain_destroy(d);
}

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
    CHECK_EQUAL(mgdt_domain_create_with_allocator(NULL, release, NULL, &none),
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

static void refused_memory(void) {
    int64_t n, failures = 0, cancelled = 0;
    int done = 0;
    for (n = 1; !done; ++n) {
        failing f = {NULL, 0, 0, n, 0};
        mgdt_domain* d = NULL;
        mgdt_mesh* m = NULL;
        mgdt_status status = mgdt_domain_create_with_allocator(allocate, release, &f, &d);
        if (status == MGDT_OK) status = give_box(d, 0);
        if (status == MGDT_OK) status = mgdt_domain_build(d, &m);
        done = f.calls < n;
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
        CHECK_EQUAL(f.blocks, 0);
    }
    CHECK(failures > 100);
    for (n = 2, done = 0; !done; n += 5) {
        failing f = {NULL, 0, 0, 0, n};
        mgdt_status status;
        CHECK_EQUAL(mgdt_domain_create_with_allocator(allocate, release, &f, &f.d), MGDT_OK);
        CHECK_EQUAL(give_box(f.d, 0), MGDT_OK);
        status = build(f.d);
        done = f.calls < n;
        if (status == MGDT_ERR_CANCELLED) {
            ++cancelled;
            CHECK_EQUAL(build(f.d), MGDT_OK);
        } else {
            CHECK_EQUAL(status, MGDT_OK);
        }
        mgdt_domain_destroy(f.d);
        CHECK_EQUAL(f.blocks, 0);
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
    CHECK_EQUAL(mgdt_domain_clear(w.d), MGDT_OK);
    CHECK_EQUAL(give_box(w.d, 0), MGDT_OK);
    CHECK_EQUAL(build(w.d), MGDT_OK);
    mgdt_mesh_destroy(w.m);
    mgdt_domain_destroy(w.d);
}

/* Nothing at all, and points without facets, enclose nothing. */
static void nothing(void) {
    mgdt_domain* d = NULL;
    int i;
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    for (i = 0; i < 2; ++i) {
        CHECK_EQUAL(mgdt_domain_validate(d), MGDT_OK);
        CHECK_EQUAL(build(d), MGDT_ERR_OPEN_BOUNDARY);
        CHECK_EQUAL(mgdt_domain_set_points(d, 13, box), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_facets(d, 0, NULL, NULL, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_segments(d, 0, NULL, NULL), MGDT_OK);
    }
    mgdt_domain_destroy(d);
}

/* Builds, and counts what the mesh leaves out. */
static void expect_unused(mgdt_domain* d, int64_t points, int64_t faces, int64_t regions,
                          int64_t holes) {
    mgdt_mesh* const m = mesh_of(d);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_UNUSED_POINTS), points);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_UNUSED_FACES), faces);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_UNUSED_REGIONS), regions);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_UNUSED_HOLES), holes);
    mgdt_mesh_destroy(m);
}

/* Two cubes, one inside of the other, one of whose sides is missing in turn; a point that comes
 * twice, one far away, and places outside. */
static void losses(void) {
    /* Outside, inside twice, outside. */
    const double places[12] = {9, 9, 9, 2, 2, 2, 2, 2, 2, 9, 9, 9}, between[3] = {0.5, 2, 2},
                 far_away[3] = {1e300, 0, 0};
    const int32_t marks[2] = {7, 8};
    double xyz[18 * 3];
    int64_t corners[44], begin[12], i, k, skipped, value;
    mgdt_domain* d = NULL;
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    for (i = 0; i < 24; ++i) {
        xyz[i] = box[i];
        xyz[24 + i] = 1 + box[i] / 2;
    }
    memcpy(xyz + 48, box, 3 * sizeof *box);
    memcpy(xyz + 51, places, 3 * sizeof *places);
    CHECK_EQUAL(mgdt_domain_get_option(d, MGDT_DOMAIN_OPTION_STRICT, &value), MGDT_OK);
    CHECK_EQUAL(value, 0);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_STRICT, 2), MGDT_ERR_INVALID_ARGUMENT);
    for (skipped = 0; skipped < 12; skipped += 6) {
        k = 0;
        for (i = 0; i < 12; ++i) {
            int64_t c;
            if (i == skipped) continue;
            begin[k / 4] = k;
            for (c = 0; c < 4; ++c) corners[k++] = quads[4 * (i % 6) + c] + 8 * (i / 6);
        }
        begin[11] = 44;
        CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_STRICT, 0), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_clear(d), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_points(d, 17, xyz), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_facets(d, 11, begin, corners, NULL), MGDT_OK);
        CHECK_EQUAL(build(d), MGDT_OK);
        CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_OPEN_EDGES), 4);
        /* Without a side of the outer cube the inner one alone is filled. */
        if (skipped == 0)
            expect_unused(d, 9, 10, 0, 0);
        else
            expect_unused(d, 0, 0, 0, 0);
        CHECK_EQUAL(mgdt_domain_set_regions(d, 2, places, marks), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_holes(d, 1, far_away), MGDT_OK);
        expect_unused(d, skipped == 0 ? 9 : 0, skipped == 0 ? 10 : 0, 1, 1);
        CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_STRICT, 1), MGDT_OK);
        CHECK_EQUAL(build(d), skipped == 0 ? MGDT_ERR_OPEN_BOUNDARY : MGDT_ERR_INVALID_ARGUMENT);
        check_message(d, skipped == 0 ? "facet 0 bounds nothing" : "region 0 is in no region");
    }
    /* The whole cubes: the strict build succeeds, or names what is left out. */
    {
        int64_t all[48], offsets_of_all[13];
        for (i = 0; i < 48; ++i) all[i] = quads[i % 24] + 8 * (i / 24);
        for (i = 0; i < 13; ++i) offsets_of_all[i] = 4 * i;
        CHECK_EQUAL(mgdt_domain_clear(d), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_points(d, 17, xyz), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_facets(d, 12, offsets_of_all, all, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_regions(d, 1, between, marks), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_holes(d, 2, places + 3), MGDT_OK);
        expect_unused(d, 0, 0, 0, 0);
        CHECK_EQUAL(mgdt_domain_set_holes(d, 3, places + 3), MGDT_OK);
        CHECK_EQUAL(build(d), MGDT_ERR_INVALID_ARGUMENT);
        check_message(d, "hole 2 is in nothing");
        CHECK_EQUAL(mgdt_domain_clear(d), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_points(d, 18, xyz), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_facets(d, 12, offsets_of_all, all, NULL), MGDT_OK);
        CHECK_EQUAL(build(d), MGDT_ERR_INVALID_ARGUMENT);
        check_message(d, "point 17 is a corner of no tetrahedron");
    }
    mgdt_domain_destroy(d);
}

void test_domain(void) {
    mesh_of_a_box(0);
    mesh_of_a_box(1);
    offending_pairs();
    bad_arguments();
    refused_memory();
    memory_limit();
    progress();
    nothing();
    losses();
}
