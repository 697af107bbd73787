/* SPDX-License-Identifier: MIT
 * Meshes: what they do without their domain. */
#include <math.h>
#include <mgdt/mgdt_domain.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "keys.h"

/* Schoenhardt's polyhedron, which has no tetrahedra without further points, and a point that comes
 * twice. */
static const double prism[7 * 3] = {8, 0,  0, -4, 7, 0,  -4, -7, 0, 7, 4,
                                    8, -7, 4, 8,  0, -8, 8,  8,  0, 0};
static const int64_t triangles[8 * 3] = {0, 2, 1, 3, 4, 5, 0, 1, 4, 0, 4, 3,
                                         1, 2, 5, 1, 5, 4, 2, 0, 3, 2, 3, 5};

static const struct {
    int32_t key, columns, is_double, stat;
} arrays[] = {{MGDT_MESH_ARRAY_POINT_ORIGINS, 1, 0, MGDT_MESH_STAT_POINTS},
              {MGDT_MESH_ARRAY_TETRAHEDRA, 4, 0, MGDT_MESH_STAT_TETRAHEDRA},
              {MGDT_MESH_ARRAY_NEIGHBORS, 4, 0, MGDT_MESH_STAT_TETRAHEDRA},
              {MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS, 1, 0, MGDT_MESH_STAT_TETRAHEDRA},
              {MGDT_MESH_ARRAY_REGION_MARKERS, 1, 0, MGDT_MESH_STAT_REGIONS},
              {MGDT_MESH_ARRAY_FACES, 3, 0, MGDT_MESH_STAT_FACES},
              {MGDT_MESH_ARRAY_FACE_TETRAHEDRA, 2, 0, MGDT_MESH_STAT_FACES},
              {MGDT_MESH_ARRAY_FACE_FACETS, 1, 0, MGDT_MESH_STAT_FACES},
              {MGDT_MESH_ARRAY_FACE_MARKERS, 1, 0, MGDT_MESH_STAT_FACES},
              {MGDT_MESH_ARRAY_EDGES, 2, 0, MGDT_MESH_STAT_EDGES},
              {MGDT_MESH_ARRAY_EDGE_SEGMENTS, 1, 0, MGDT_MESH_STAT_EDGES},
              {MGDT_MESH_ARRAY_EDGE_MARKERS, 1, 0, MGDT_MESH_STAT_EDGES},
              {MGDT_MESH_ARRAY_STEINER_EDGES, 2, 0, MGDT_MESH_STAT_STEINER_POINTS},
              {MGDT_MESH_ARRAY_POINTS, 3, 1, MGDT_MESH_STAT_POINTS},
              {MGDT_MESH_ARRAY_STEINER_PARAMETERS, 1, 1, MGDT_MESH_STAT_STEINER_POINTS}};
enum { n_arrays = sizeof arrays / sizeof *arrays };

/* The mesh of the prism, whose domain is gone. */
static mgdt_mesh* mesh_of_prism(int64_t base) {
    mgdt_domain* d = NULL;
    mgdt_mesh* m = NULL;
    int64_t corners[24];
    int i;
    for (i = 0; i < 24; ++i) corners[i] = triangles[i] + base;
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_INDEX_BASE, base), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_points(d, 7, prism), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_facets(d, 8, NULL, corners, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_build(d, &m), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_OK);
    mgdt_domain_destroy(d);
    return m;
}

static int64_t stat_of(const mgdt_mesh* m, int32_t key) {
    int64_t value = -1;
    CHECK_EQUAL(mgdt_mesh_get_stat(m, key, &value), MGDT_OK);
    return value;
}

static int64_t* array_of(const mgdt_mesh* m, int32_t key) {
    int64_t size = 0, *values;
    CHECK_EQUAL(mgdt_mesh_get_size(m, key, &size), MGDT_OK);
    values = malloc((size_t)(size + 1) * sizeof *values);
    CHECK_EQUAL(mgdt_mesh_get_array(m, key, size, values), MGDT_OK);
    return values;
}

static int check_message(const mgdt_mesh* m, const char* text) {
    char message[256] = "";
    CHECK_EQUAL(mgdt_mesh_get_error(m, sizeof message, message), MGDT_OK);
    if (strstr(message, text) == NULL) printf("the message is: %s\n", message);
    return CHECK(strstr(message, text) != NULL);
}

/* Every array has the shape that array_info gives, and as many rows as a statistic says. */
static void shapes(void) {
    mgdt_mesh* const m = mesh_of_prism(0);
    int k;
    for (k = 0; k < n_arrays; ++k) {
        int32_t columns = -1, is_double = -1;
        int64_t size = -1;
        CHECK_EQUAL(mgdt_mesh_array_info(arrays[k].key, &columns, &is_double), MGDT_OK);
        CHECK_EQUAL(columns, arrays[k].columns);
        CHECK_EQUAL(is_double, arrays[k].is_double);
        CHECK_EQUAL(is_double, arrays[k].key >= 300);
        CHECK_EQUAL(mgdt_mesh_get_size(m, arrays[k].key, &size), MGDT_OK);
        CHECK_EQUAL(size, columns * stat_of(m, arrays[k].stat));
        CHECK(size > 0);
    }
    mgdt_mesh_destroy(m);
}

/* No two keys are equal, and a key of one kind is unknown to the functions of another one. */
static void kinds_of_keys(void) {
    mgdt_mesh* const m = mesh_of_prism(0);
    int64_t wide[200], value;
    int32_t found, key;
    double x[200];
    CHECK_KINDS_OF_KEYS(mesh, m, mgdt_mesh_get_option(m, key, &value), found);
    /* Four arrays describe an improvement (test_improvement.c), and two a refinement
     * (test_refinement.c). */
    CHECK_EQUAL(found, n_arrays + 6);
    CHECK_EQUAL(mgdt_mesh_get_array(m, MGDT_MESH_ARRAY_POINTS, 200, wide), MGDT_ERR_UNKNOWN_KEY);
    check_message(m, "has doubles, not integers");
    CHECK_EQUAL(mgdt_mesh_get_doubles(m, MGDT_MESH_ARRAY_FACES, 200, x), MGDT_ERR_UNKNOWN_KEY);
    check_message(m, "has integers, not doubles");
    mgdt_mesh_destroy(m);
}

/* The origins of points, and the index base, which may be changed. */
static void numbers(int64_t base) {
    mgdt_mesh* const m = mesh_of_prism(base);
    const int64_t n = stat_of(m, MGDT_MESH_STAT_POINTS),
                  tetrahedra = stat_of(m, MGDT_MESH_STAT_TETRAHEDRA);
    int64_t* origins = array_of(m, MGDT_MESH_ARRAY_POINT_ORIGINS);
    int64_t *corners = array_of(m, MGDT_MESH_ARRAY_TETRAHEDRA), *others, value = -1, i;
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_STEINER_POINTS), n - 7);
    CHECK(n > 7);
    for (i = 0; i < n; ++i) CHECK_EQUAL(origins[i], i == 6 ? base : i < 7 ? i + base : base - 1);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_UNUSED_POINTS), 0);
    CHECK_EQUAL(mgdt_mesh_get_option(m, MGDT_MESH_OPTION_INDEX_BASE, &value), MGDT_OK);
    CHECK_EQUAL(value, base);
    CHECK_EQUAL(mgdt_mesh_set_option(m, MGDT_MESH_OPTION_INDEX_BASE, 1 - base), MGDT_OK);
    others = array_of(m, MGDT_MESH_ARRAY_TETRAHEDRA);
    for (i = 0; i < 4 * tetrahedra; ++i) CHECK_EQUAL(others[i] - (1 - base), corners[i] - base);
    free(others);
    free(origins);
    free(corners);
    mgdt_mesh_destroy(m);
}

/* Volumes add up to that of the prism, and angles are those that the coordinates have. */
static void measures(void) {
    mgdt_mesh* const m = mesh_of_prism(1);
    const int64_t n = stat_of(m, MGDT_MESH_STAT_TETRAHEDRA);
    int64_t* const v = array_of(m, MGDT_MESH_ARRAY_TETRAHEDRA);
    double* const x = malloc((size_t)n * sizeof *x);
    double xyz[300], sum = 0, expected = 0;
    int64_t i;
    CHECK_EQUAL(mgdt_mesh_get_tetrahedron_measures(m, MGDT_TETRAHEDRON_VOLUME, n, x), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_get_doubles(m, MGDT_MESH_ARRAY_POINTS, 300, xyz), MGDT_OK);
    for (i = 0; i < n; ++i) {
        const double six = volume(xyz + 3 * (v[4 * i] - 1), xyz + 3 * (v[4 * i + 1] - 1),
                                  xyz + 3 * (v[4 * i + 2] - 1), xyz + 3 * (v[4 * i + 3] - 1));
        CHECK(fabs(x[i] - six / 6) <= 1e-9);
        sum += x[i];
        expected += six / 6;
    }
    CHECK(fabs(sum - expected) < 1e-9 && sum > 100);
    CHECK_EQUAL(mgdt_mesh_set_option(m, MGDT_MESH_OPTION_THREADS, 3), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_get_tetrahedron_measures(m, MGDT_TETRAHEDRON_RADIUS_RATIO, n, x),
                MGDT_OK);
    for (i = 0; i < n; ++i) CHECK(x[i] > 0 && x[i] <= 1 + 1e-12);
    CHECK_EQUAL(mgdt_mesh_get_tetrahedron_measures(m, 9, n, x), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_mesh_get_tetrahedron_measures(m, MGDT_TETRAHEDRON_VOLUME, n - 1, x),
                MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_mesh_get_tetrahedron_measures(m, MGDT_TETRAHEDRON_VOLUME, n, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_get_tetrahedron_measures(NULL, MGDT_TETRAHEDRON_VOLUME, n, x),
                MGDT_ERR_NULL_POINTER);
    free(v);
    free(x);
    mgdt_mesh_destroy(m);
}

static void bad_arguments(void) {
    mgdt_mesh* const m = mesh_of_prism(0);
    mgdt_progress_fn fn;
    int64_t value, wide[4];
    int32_t narrow[4];
    double x[4];
    char text[8];
    CHECK_EQUAL(mgdt_mesh_check(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_cancel(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_progress(NULL, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_get_progress(NULL, &fn, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_get_progress(m, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_option(NULL, 10, 0), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_option(m, MGDT_MESH_OPTION_INDEX_BASE, 2), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_mesh_set_option(m, MGDT_MESH_OPTION_THREADS, -1), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_mesh_set_option(m, MGDT_DOMAIN_OPTION_STRICT, 1), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_mesh_get_option(m, MGDT_MESH_OPTION_THREADS, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_get_stat(m, MGDT_MESH_STAT_POINTS, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_get_stat(NULL, MGDT_MESH_STAT_POINTS, &value), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_get_size(m, MGDT_MESH_ARRAY_FACES, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_get_array(m, MGDT_MESH_ARRAY_FACES, -1, wide), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_mesh_get_array(m, MGDT_MESH_ARRAY_FACES, 4, wide), MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_mesh_get_array_i32(m, MGDT_MESH_ARRAY_FACES, 4, narrow),
                MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_mesh_get_array(m, MGDT_MESH_ARRAY_FACES, 400, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_get_doubles(m, MGDT_MESH_ARRAY_POINTS, 4, x), MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_mesh_get_doubles(m, MGDT_MESH_ARRAY_POINTS, 400, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_get_error(NULL, 8, text), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_get_error(m, 0, text), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_mesh_array_info(MGDT_MESH_ARRAY_FACES, NULL, NULL), MGDT_ERR_NULL_POINTER);
    mgdt_mesh_destroy(m);
    mgdt_mesh_destroy(NULL);
}

/* A limit that the mesh already exceeds refuses what needs memory. */
static void memory_limit(void) {
    mgdt_mesh* const m = mesh_of_prism(0);
    const int64_t bytes = stat_of(m, MGDT_MESH_STAT_MEMORY_BYTES);
    CHECK(bytes > 0);
    CHECK_EQUAL(mgdt_mesh_set_option(m, MGDT_MESH_OPTION_MEMORY_LIMIT, bytes), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_ERR_OUT_OF_MEMORY);
    CHECK_EQUAL(mgdt_mesh_set_option(m, MGDT_MESH_OPTION_MEMORY_LIMIT, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_MEMORY_BYTES), bytes);
    mgdt_mesh_destroy(m);
}

void test_mesh(void) {
    shapes();
    kinds_of_keys();
    numbers(0);
    numbers(1);
    measures();
    bad_arguments();
    memory_limit();
}
