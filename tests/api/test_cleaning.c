/* SPDX-License-Identifier: MIT
 * Domains that are cleaned: options, what is mended, the numbers and arrays that say so. */
#include "domain_box.h"

/* Two cubes with a common wall, each with its own points and its own facet there. */
static const double cubes[16 * 3] = {
    0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1, /* the first */
    1, 0, 0, 2, 0, 0, 1, 1, 0, 2, 1, 0, 1, 0, 1, 2, 0, 1, 1, 1, 1, 2, 1, 1};

/* The array `key`, both kinds of integers, each after `size` given elements. */
static void expect_array(const mgdt_domain* d, int32_t key, int64_t size, const int64_t* wanted) {
    int64_t values[80], i;
    int32_t narrow[80];
    if (!CHECK_EQUAL(size_of(d, key), size)) return;
    CHECK_EQUAL(mgdt_domain_get_array(d, key, size, values), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_get_array_i32(d, key, size, narrow), MGDT_OK);
    for (i = 0; i < size; ++i) {
        CHECK_EQUAL(values[i], wanted[i]);
        CHECK_EQUAL(narrow[i], wanted[i]);
    }
}

static mgdt_domain* make_cubes(int64_t base) {
    int64_t sides[12 * 4], ends[13];
    int32_t marks[12];
    mgdt_domain* d = NULL;
    int i;
    for (i = 0; i < 48; ++i) sides[i] = quads[i % 24] + (i < 24 ? 0 : 8) + base;
    for (i = 0; i < 13; ++i) ends[i] = 4 * i + base;
    for (i = 0; i < 12; ++i) marks[i] = 20 + i;
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_INDEX_BASE, base), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_points(d, 16, cubes), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_facets(d, 12, ends, sides, marks), MGDT_OK);
    return d;
}

/* The wall is taken once. All numbers are those of the facets that were set. */
static void a_wall(int64_t base) {
    mgdt_domain* const d = make_cubes(base);
    const int64_t covered[2] = {10 + base, 5 + base};
    int64_t origins[11], marks[11], ends[12], *facets;
    double got[48];
    mgdt_mesh* m;
    int64_t i, faces, of_last = 0;
    CHECK_EQUAL(mgdt_domain_validate(d), MGDT_ERR_INVALID_BOUNDARY);
    CHECK_EQUAL(mgdt_domain_clean(d), MGDT_OK);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS), 0);
    for (i = 0; i < 11; ++i) {
        origins[i] = (i < 10 ? i : 11) + base;
        marks[i] = origins[i] - base + 20;
    }
    for (i = 0; i < 12; ++i) ends[i] = 4 * i + base;
    expect_array(d, MGDT_DOMAIN_ARRAY_FACET_ORIGINS, 11, origins);
    expect_array(d, MGDT_DOMAIN_ARRAY_FACET_MARKERS, 11, marks);
    expect_array(d, MGDT_DOMAIN_ARRAY_FACET_OFFSETS, 12, ends);
    expect_array(d, MGDT_DOMAIN_ARRAY_COVERED_FACETS, 2, covered);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_FACET_CORNERS), 44);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_FACETS), 11);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_COVERED_FACETS), 1);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_COLLAPSED_FACETS), 0);
    CHECK_EQUAL(mgdt_domain_get_doubles(d, MGDT_DOMAIN_ARRAY_POINTS, 48, got), MGDT_OK);
    CHECK(memcmp(got, cubes, sizeof cubes) == 0);
    CHECK_EQUAL(mgdt_domain_validate(d), MGDT_OK);
    m = mesh_of(d);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_REGIONS), 2);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_OK);
    faces = mesh_stat(m, MGDT_MESH_STAT_FACES);
    facets = array_of(m, MGDT_MESH_ARRAY_FACE_FACETS);
    for (i = 0; i < faces; ++i) {
        CHECK(facets[i] != 10 + base);
        if (facets[i] == 11 + base) ++of_last;
    }
    CHECK_EQUAL(of_last, 2);
    free(facets);
    mgdt_mesh_destroy(m);
    mgdt_domain_destroy(d);
}

/* A point in an edge and one inside of a triangle, a segment that both divide, a facet without
 * area, and a corner that is repeated. */
static void divided(void) {
    static const double xyz[18] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 2, 0, 0, 1, 1, 0, 3, 0, 0};
    static const int64_t ends[5] = {0, 3, 6, 9, 13};
    static const int64_t lists[13] = {0, 1, 2, 0, 3, 1, 4, 4, 4, 0, 1, 1, 2};
    static const int64_t segments[4] = {0, 1, 2, 2};
    static const int32_t marks[2] = {7, 8};
    static const int64_t parts[6] = {0, 3, 3, 5, 5, 1}, origins[3] = {0, 0, 0},
                         marked[3] = {7, 7, 7};
    int64_t pairs[8], from[8];
    mgdt_domain* d = NULL;
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_points(d, 6, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_facets(d, 4, ends, lists, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_segments(d, 2, segments, marks), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_clean(d), MGDT_OK);
    expect_array(d, MGDT_DOMAIN_ARRAY_SEGMENTS, 6, parts);
    expect_array(d, MGDT_DOMAIN_ARRAY_SEGMENT_ORIGINS, 3, origins);
    expect_array(d, MGDT_DOMAIN_ARRAY_SEGMENT_MARKERS, 3, marked);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_COLLAPSED_FACETS), 2);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_POINTS_IN_FACETS), 2);
    CHECK(stat_of(d, MGDT_DOMAIN_STAT_POINTS_IN_EDGES) >= 2);
    /* The first facet and the last are the same; its parts are those of the first. */
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_COVERED_FACETS), 1);
    CHECK_EQUAL(mgdt_domain_get_array(d, MGDT_DOMAIN_ARRAY_COVERED_FACETS, 2, pairs), MGDT_OK);
    CHECK(pairs[0] == 3 && pairs[1] == 0);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_FACETS), 5);
    CHECK_EQUAL(mgdt_domain_get_array(d, MGDT_DOMAIN_ARRAY_FACET_ORIGINS, 5, from), MGDT_OK);
    CHECK(from[0] == 0 && from[4] == 0);
    CHECK_EQUAL(mgdt_domain_validate(d), MGDT_OK);
    /* New facets forget what was done. */
    CHECK_EQUAL(mgdt_domain_set_facets(d, 1, NULL, lists, NULL), MGDT_OK);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_POINTS_IN_FACETS), 0);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_COVERED_FACETS), 0);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_FACET_ORIGINS), 1);
    CHECK_EQUAL(mgdt_domain_clear(d), MGDT_OK);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_FACET_OFFSETS), 1);
    CHECK_EQUAL(mgdt_domain_clean(d), MGDT_OK);
    mgdt_domain_destroy(d);
}

/* Points of both cubes that are moved a little are welded. */
static void welded(void) {
    mgdt_domain* const d = make_cubes(0);
    double moved[48], got[48];
    int64_t sides[48], ends[13];
    mgdt_mesh* m;
    int i;
    for (i = 0; i < 48; ++i) moved[i] = cubes[i] + 1e-10 * ((7 * i) % 5 - 2);
    for (i = 0; i < 48; ++i) sides[i] = quads[i % 24] + (i < 24 ? 0 : 8);
    for (i = 0; i < 13; ++i) ends[i] = 4 * i;
    CHECK_EQUAL(mgdt_domain_set_points(d, 16, moved), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_facets(d, 12, ends, sides, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_double_option(d, MGDT_DOMAIN_OPTION_WELD, 1e-9), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_clean(d), MGDT_OK);
    CHECK(stat_of(d, MGDT_DOMAIN_STAT_MOVED_POINTS) == 4);
    CHECK_EQUAL(mgdt_domain_get_doubles(d, MGDT_DOMAIN_ARRAY_POINTS, 48, got), MGDT_OK);
    for (i = 0; i < 48; ++i) CHECK(fabs(got[i] - moved[i]) < 1e-8);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_KEEP_BOUNDARY, 1), MGDT_OK);
    m = mesh_of(d);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_REGIONS), 2);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_UNUSED_POINTS), 0);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_OK);
    mgdt_mesh_destroy(m);
    mgdt_domain_destroy(d);
}

static void double_options(void) {
    static const int32_t keys[2] = {MGDT_DOMAIN_OPTION_WELD, MGDT_DOMAIN_OPTION_FLATNESS};
    static const double bad[4] = {-1e-300, 0.1, HUGE_VAL, -HUGE_VAL};
    mgdt_domain* d = NULL;
    double value = -1;
    int64_t integer = 0;
    int i, k;
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    for (i = 0; i < 2; ++i) {
        CHECK_EQUAL(mgdt_domain_get_double_option(d, keys[i], &value), MGDT_OK);
        CHECK(value == 0);
        CHECK_EQUAL(mgdt_domain_set_double_option(d, keys[i], 0.0625), MGDT_OK);
        for (k = 0; k < 4; ++k)
            CHECK_EQUAL(mgdt_domain_set_double_option(d, keys[i], bad[k]),
                        MGDT_ERR_INVALID_ARGUMENT);
        CHECK_EQUAL(mgdt_domain_set_double_option(d, keys[i], nan("")), MGDT_ERR_INVALID_ARGUMENT);
        CHECK_EQUAL(mgdt_domain_get_double_option(d, keys[i], &value), MGDT_OK);
        CHECK(value == 0.0625);
        CHECK_EQUAL(mgdt_domain_get_double_option(d, keys[i], NULL), MGDT_ERR_NULL_POINTER);
        CHECK_EQUAL(mgdt_domain_set_option(d, keys[i], 0), MGDT_ERR_UNKNOWN_KEY);
        CHECK_EQUAL(mgdt_domain_get_option(d, keys[i], &integer), MGDT_ERR_UNKNOWN_KEY);
    }
    CHECK_EQUAL(mgdt_domain_set_double_option(d, MGDT_DOMAIN_OPTION_WELD, 0.25),
                MGDT_ERR_INVALID_ARGUMENT);
    check_message(d, "0.25 is out of the range of option 70");
    CHECK_EQUAL(mgdt_domain_set_double_option(d, MGDT_DOMAIN_OPTION_THREADS, 1),
                MGDT_ERR_UNKNOWN_KEY);
    check_message(d, "no option 20 with a double");
    CHECK_EQUAL(mgdt_domain_get_double_option(d, MGDT_DOMAIN_OPTION_THREADS, &value),
                MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_domain_set_double_option(NULL, MGDT_DOMAIN_OPTION_WELD, 0),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_get_double_option(NULL, MGDT_DOMAIN_OPTION_WELD, &value),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_clean(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_get_doubles(NULL, MGDT_DOMAIN_ARRAY_POINTS, 0, &value),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_domain_get_doubles(d, MGDT_DOMAIN_ARRAY_SEGMENTS, 0, &value),
                MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_domain_get_array(d, MGDT_DOMAIN_ARRAY_POINTS, 0, &integer),
                MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_domain_clean(d), MGDT_OK);
    mgdt_domain_destroy(d);
}

/* A point of a million copies near each other, a lattice of which all is welded, numbers at the
 * ends of the range: all end. */
static void extreme(void) {
    static const double sizes[4] = {1e-320, 1e-160, 1e150, 1.7e308};
    int i, k;
    for (i = 0; i < 4; ++i) {
        mgdt_domain* const d = make_cubes(0);
        double xyz[48];
        int64_t sides[48], ends[13];
        for (k = 0; k < 48; ++k) xyz[k] = (cubes[k] - 1) * sizes[i];
        for (k = 0; k < 48; ++k) sides[k] = quads[k % 24] + (k < 24 ? 0 : 8);
        for (k = 0; k < 13; ++k) ends[k] = 4 * k;
        CHECK_EQUAL(mgdt_domain_set_points(d, 16, xyz), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_facets(d, 12, ends, sides, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_clean(d), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_validate(d), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_double_option(d, MGDT_DOMAIN_OPTION_WELD, 1e-9), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_double_option(d, MGDT_DOMAIN_OPTION_FLATNESS, 1e-3), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_clean(d), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_validate(d), MGDT_OK);
        CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_FACETS), 11 + 0);
        mgdt_domain_destroy(d);
    }
}

void test_cleaning(void) {
    a_wall(0);
    a_wall(1);
    divided();
    welded();
    double_options();
    extreme();
}
